# SPDX-License-Identifier: Apache-2.0
# One output over speed, or over a field: median and 95 % band of each scene, or a line where the band has no width.
# Blocks: 0 the axes; 1 the scenes; then the curve of each scene.
load scripts."sweep.gp"
stats data index 0 using (low = column(1), high = column(2), bottom = column(3), top = column(4), \
  is_log = column(5), label = strcol(6), \
  label_across = strcol(7), 0) nooutput
stats data index 1 using (0) nooutput name "scenes"
array names[scenes_records]
array colours[scenes_records]
stats data index 1 using (names[int($1)] = strcol(4), colours[int($1)] = column(3), \
  0) nooutput
stats data index 2 using 1 nooutput name "first"
medians = first_records > 12 ? "lines" : "linespoints"  # a few values are also shown as points
longest = 0
do for [i = 1:scenes_records] { longest = strlen(names[i]) > longest ? strlen(names[i]) : longest }
columns = longest > 26 ? 1 : 3
set bmargin at screen (90.0 + 22*ceil(scenes_records/(1.0*columns)))/tall
set xrange [low:high]
set yrange [bottom:top]
if (high/low > 3) { eval log_ticks("x", low, high) }
if (int(is_log)) { eval log_ticks("y", bottom, top) }
set xlabel label_across offset 0, x_words noenhanced
set ylabel label offset y_words
set key at screen 0.54, screen 4.0/tall center bottom horizontal maxcols columns Left reverse samplen 3 \
  spacing 1.25 font small
set style fill transparent solid (scenes_records > 3 ? 0.14 : 0.3) noborder
n = scenes_records
plot \
  for [i = 1:n] data index 1 + i using 1:2:4 with filledcurves fillcolor rgb colours[i] notitle, \
  for [i = 1:n] for [edge = 2:4:2] data index 1 + i using 1:edge with lines linewidth 0.6 \
    linecolor rgb colours[i] notitle, \
  for [i = 1:n] data index 1 + i using 1:3 with @medians linewidth 2.2 pointtype 7 pointsize 0.7 \
    linecolor rgb colours[i] title names[i]
