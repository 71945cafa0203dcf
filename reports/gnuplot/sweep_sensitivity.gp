# SPDX-License-Identifier: Apache-2.0
# Sobol indices of one column: a row for each variable, in it a bar for each scene. Loaded by
# sweep.gp. Blocks: 0 the axes; 1 variables; 2 bars; 3 the legend.
stats data index 0 using (right = column(1), top = column(2), 0) nooutput
set lmargin at screen 0.32
set rmargin at screen 0.97
set bmargin at screen 78.0/tall
set xrange [0:right]
set yrange [0:top]
unset ytics
set xtics 0.1
set border 3
set grid xtics linetype 1 linecolor rgb "#e4e4e4" linewidth 0.6
set xlabel "part of the variance" offset 0, x_words
unset key
set bars 0.6
# Columns of a bar: middle and half of its height, then first order and total with their ends.
y = 1; half = 2; first = 3; total = 6; full = 9; pale = 10
clipped(x) = x < 0 ? 0 : x > right ? right : x
box(value) = clipped(column(value))
plot \
  data index 2 using (0):y:(0):(box(total)):(column(y) - column(half)):(column(y) + column(half)):pale \
    with boxxyerror fillcolor rgb variable, \
  data index 2 using (0):y:(0):(box(first)):(column(y) - column(half)):(column(y) + column(half)):full \
    with boxxyerror fillcolor rgb variable, \
  data index 2 using (box(total)):y:(box(total + 1)):(box(total + 2)) with xerrorbars pointtype 0 \
    linewidth 1.2 linecolor rgb "#222222", \
  data index 1 using (-0.012*right):1:2 with labels right font small noenhanced, \
  data index 3 using 1:2:3:4:5:6:8 with boxxyerror fillcolor rgb variable, \
  data index 3 using 4:2:7 with labels left offset 0.8, 0 font small noenhanced
