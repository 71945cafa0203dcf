# SPDX-License-Identifier: Apache-2.0
# Histograms of onset speeds, a lane each.
# Blocks: 0 the axis; 1 lanes; 2 scenes; then the histogram of each lane, as the outline of its bars.
load scripts."sweep.gp"
stats data index 0 using (low = column(1), high = column(2), top = column(3), has_marks = column(4), 0) \
  nooutput
# The texts stand outside the plot, where `set label` draws them and a plot style would leave them out.
stats data index 1 using (0) nooutput name "lanes"
array base[lanes_records]
array colours[lanes_records]
array criteria[lanes_records]
array numbers[lanes_records]
array missing[lanes_records]
stats data index 1 using (i = int($0) + 1, base[i] = column(1), criteria[i] = strcol(3), \
  colours[i] = column(4), numbers[i] = strcol(9), missing[i] = strcol(10) eq "-" ? "" : strcol(10), 0) nooutput
stats data index 2 using (0) nooutput name "scenes"
array heights[scenes_records]
array ids[scenes_records]
stats data index 2 using (i = int($0) + 1, ids[i] = strcol(1), heights[i] = column(2), 0) nooutput
do for [i = 1:lanes_records] {
  set label criteria[i] at screen 0.19, first base[i] + 0.28 right font small noenhanced
  set label numbers[i] at screen 0.76, first base[i] + 0.28 left font small noenhanced
  set label missing[i] at screen 0.76, first base[i] - 0.08 left font tiny textcolor rgb grey noenhanced
}
do for [i = 1:scenes_records] {
  if (strlen(ids[i]) > 16) {  # above its lanes, from the left edge on
    set label ids[i] at screen 0.01, first heights[i] left front font bold noenhanced
  } else {
    set label ids[i] at screen 0.19, first heights[i] right font bold noenhanced
  }
}
set lmargin at screen 0.20
set rmargin at screen 0.74
set bmargin at screen 92.0/tall
set xrange [low:high]
set yrange [-0.12:top]
set border 1 linewidth 0.8
unset ytics
room = 0.6
eval log_ticks("x", low, high)  # only on a logarithmic axis is the area of a bar its number of cases
set grid noytics
set xlabel "onset speed (m/s)" offset 0, x_words
set label "median (95 %)" at screen 0.76, first heights[scenes_records] left font small textcolor rgb grey
if (int(has_marks)) {
  set key at screen 0.47, screen 4.0/tall center bottom horizontal Left reverse samplen 2.5 font small
} else {
  unset key
}
plot \
  data index 2 using 6:3:6:7:3:4 with boxxyerror fillcolor rgb "#e6e6e6" notitle, \
  for [i = 0:lanes_records - 1] data index 3 + i using 1:2:3 with filledcurves \
    fillcolor rgb colours[i + 1] notitle, \
  data index 1 using 5:1:6:7 with xerrorbars pointtype 0 linewidth 1.4 linecolor rgb "#222222" notitle, \
  data index 1 using 5:1:(0):(0.8*column(8)) with vectors nohead linewidth 1.6 \
    linecolor rgb "#ffffff" notitle, \
  data index 2 using 5:3:(0):(column(4) - column(3)) with vectors nohead linewidth 1.6 \
    dashtype (6,4) linecolor rgb "#222222" notitle, \
  keyentry with lines linewidth 1.6 dashtype (6,4) linecolor rgb "#222222" title "reported", \
  keyentry with boxes fillcolor rgb "#e6e6e6" title "rounds to it"
