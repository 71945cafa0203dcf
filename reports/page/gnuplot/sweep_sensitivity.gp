# SPDX-License-Identifier: Apache-2.0
# Sobol indices of one column: a row for each variable, in it a bar for each scene.
# Blocks: 0 the axes; 1 variables; 2 bars; 3 scenes.
load scripts."sweep.gp"
stats data index 0 using (right = column(1), top = column(2), 0) nooutput
stats data index 3 using (0) nooutput name "scenes"
array names[scenes_records]
array colours[scenes_records]
stats data index 3 using (i = int($0) + 1, names[i] = strcol(1), colours[i] = column(2), 0) nooutput
n = scenes_records
stats data index 3 using (pales_one = column(3), 0) every ::0::0 nooutput
set lmargin at screen 0.27
key_rows = ceil(((n > 1 ? n : 0) + 2)/3.0)
set bmargin at screen (92.0 + 22*key_rows)/tall
set xrange [0:right]
set yrange [0:top]
set ytics scale 0 noenhanced font small
set xtics 0.1
set border 3
set grid noytics
set xlabel "part of the variance" offset 0, x_words
set key at screen 0.62, screen 4.0/tall center bottom vertical maxrows key_rows Left reverse samplen 2 \
  spacing 1.25 font small
ink = n > 1 ? 0x666666 : colours[1]
thinned = n > 1 ? 0xBABABA : pales_one
set bars 0.6
# Columns of a bar: its middle, half of its height, first order and total, each with its ends, and two colours.
y = 1; half = 2; first = 3; total = 6; full = 9; pale = 10
clipped(x) = x < 0 ? 0 : x > right ? right : x
box(value) = clipped(column(value))
plot \
  data index 2 using (0):y:(0):(box(total)):(column(y) - column(half)):(column(y) + column(half)):pale \
    with boxxyerror fillcolor rgb variable notitle, \
  data index 2 using (0):y:(0):(box(first)):(column(y) - column(half)):(column(y) + column(half)):full \
    with boxxyerror fillcolor rgb variable notitle, \
  for [line = 1:2] data index 2 using (box(total)):y:(box(total + 1)):(box(total + 2)) with xerrorbars pointtype 0 \
    linewidth (line == 1 ? 4 : 1.2) linecolor rgb (line == 1 ? 0xffffff : 0x222222) notitle, \
  data index 1 using (NaN):1:yticlabels(2) with points notitle, \
  for [i = 1:(n > 1 ? n : 0)] keyentry with boxes fillcolor rgb colours[i] title names[i], \
  keyentry with boxes fillcolor rgb ink title "alone (first order)", \
  keyentry with boxes fillcolor rgb thinned title "with all others (total)"
