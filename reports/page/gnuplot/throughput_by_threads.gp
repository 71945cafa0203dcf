# SPDX-License-Identifier: Apache-2.0
# Speed-up of two million points by threads: columns kernel, threads, points a second, GB/s, speed-up.
table = data."by_threads.blocks.tsv"
set xtics 1
set xlabel "threads" offset 0, x_words
set ylabel "speed-up, wall time" offset y_shift, 0
stats table using 2 nooutput
n = STATS_blocks
most = STATS_max
set xrange [1:most + 0.05]
set yrange [0:most + 0.1]
okabe(i) = word("0x777777 0xD55E00 0x0072B2 0x009E73 0xB07A00 0xCC79A7 0x7E57C2", i % 7 + 1) + 0
plot x title "as many times as threads" linewidth 1 linecolor rgb 0xc0c0c0, \
  for [i=0:n-1] table index i using 2:5 with linespoints pointtype shape(i) \
  pointsize 0.8*point linewidth 1.6 linecolor rgb okabe(i) title columnheader(1)
