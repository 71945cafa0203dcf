# SPDX-License-Identifier: Apache-2.0
# Bytes that a batch reads and writes a second, beside a plain copy of the same number of points.
# Columns: kernel, points, ns, points a second, bytes, GB/s, share of the copy.
table = data."by_size.blocks.tsv"
set logscale xy 10
set format x "10^{%T}"
set format y "10^{%T}"
set xtics 10
set mxtics 10
set xlabel "points in a batch" offset 0, x_words
set ylabel "read and written (GB/s)" offset y_shift, 0
stats table using 2 nooutput
n = STATS_blocks
okabe(i) = word("0x777777 0xD55E00 0x0072B2 0x009E73 0xB07A00 0xCC79A7 0x7E57C2", i % 7 + 1) + 0
plot for [i=0:n-1] table index i using 2:6 with linespoints pointtype shape(i) \
  pointsize 0.8*point linewidth 1.6 linecolor rgb okabe(i) title columnheader(1)
