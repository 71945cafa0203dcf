# SPDX-License-Identifier: Apache-2.0
# Where a solver's time goes: a bar for each of its lines.
# Blocks: 0 the top of the axis and the words below the bars; 1 places, shares in per cent, names and the shares' texts.
load scripts."sweep.gp"
stats data index 0 using (top = column(1), words = strcol(2), 0) nooutput
set lmargin at screen 0.40
set rmargin at screen 0.93
set bmargin at screen 80.0/tall
unset key
set xrange [0:100]
set yrange [0:top]
set ytics scale 0 noenhanced font small
set grid noytics
set xlabel words offset 0, x_words
plot \
  data index 1 using (0):1:(0):2:($1 - 0.36):($1 + 0.36) with boxxyerror fillcolor rgb 0x6A8FB0 notitle, \
  data index 1 using (NaN):1:yticlabels(3) with points notitle, \
  data index 1 using 2:1:4 with labels left offset 0.6, 0 font small textcolor rgb "#222222" notitle
