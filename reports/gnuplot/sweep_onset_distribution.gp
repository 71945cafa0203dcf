# SPDX-License-Identifier: Apache-2.0
# Histograms of onset speeds, a lane each. Loaded by sweep.gp.
# Blocks: 0 the axis; 1 lanes; 2 scenes; then the histogram of each lane, as the outline of its bars.
stats data index 0 using (low = column(1), high = column(2), top = column(3), has_marks = column(4), 0) \
  nooutput
stats data index 1 using 1 nooutput name "lanes"
set lmargin at screen 0.20
set rmargin at screen 0.74
set bmargin at screen 92.0/tall
set xrange [low:high]
set yrange [-0.12:top]
set border 1 linewidth 0.8
unset ytics
if (high/low > 3) {
  eval log_ticks("x", low, high)
} else {
  set xtics autofreq
}
set grid xtics linetype 1 linecolor rgb "#e4e4e4" linewidth 0.6
set xlabel "onset speed (m/s)" offset 0, x_words
set label 1 "median (95 %)" at screen 0.76, first top - 0.25 left font small textcolor rgb grey
if (has_marks) {
  set key at screen 0.47, screen 4.0/tall center bottom horizontal samplen 2.5 font small
} else {
  unset key
}
left_of_axis = low*(low/high)**0.012
right_of_axis = high*(high/low)**0.03
plot \
  data index 2 using 6:3:6:7:3:4 with boxxyerror fillcolor rgb "#e6e6e6" notitle, \
  for [i = 0:lanes_records - 1] data index 3 + i using 1:2:3:4 with filledcurves \
    fillcolor rgb variable notitle, \
  data index 1 using 5:1:6:7 with xerrorbars pointtype 0 linewidth 1.4 linecolor rgb "#222222" notitle, \
  data index 1 using 5:1:(0):(0.8*column(8)) with vectors nohead linewidth 1.4 \
    linecolor rgb "#222222" notitle, \
  data index 2 using 5:3:(0):(column(4) - column(3)) with vectors nohead linewidth 1.6 \
    dashtype (6,4) linecolor rgb "#222222" notitle, \
  data index 1 using (left_of_axis):($1 + 0.28):3 with labels right font small noenhanced notitle, \
  data index 1 using (right_of_axis):($1 + 0.28):9 with labels left font small noenhanced notitle, \
  data index 2 using (left_of_axis):2:1:8 with labels right font bold noenhanced \
    textcolor rgb variable notitle, \
  keyentry with lines linewidth 1.6 dashtype (6,4) linecolor rgb "#222222" title "reported", \
  keyentry with boxes fillcolor rgb "#e6e6e6" title "rounds to it"
