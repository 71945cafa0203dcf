# SPDX-License-Identifier: Apache-2.0
# True error against CPU time: a line for each method, from coarse to fine. Points have the greatest error, bars go down to the mean.
load scripts."work.gp"
table = data.prefix.".blocks.tsv"
set logscale xy 10
set format x "10^{%T}"
set format y "10^{%T}"
set xtics 10
set ytics 100
set mxtics 10
set xlabel "CPU time a point (ns)" offset 0, x_words
set ylabel "true error (ulp): greatest, and down to the mean" offset y_shift, 0
stats table using ns nooutput
n = STATS_blocks < most ? STATS_blocks : most
array family[n]
do for [i=1:n] {
  stats table index i-1 using (last = strcol(2), $5) nooutput
  family[i] = last
}
plot for [i=0:n-1] table index i using ns:max_ulp:mean_ulp:max_ulp with yerrorbars \
       pointtype 0 linewidth 0.5 linecolor rgb 0xc0c0c0 notitle, \
     for [i=0:n-1] table index i using ns:max_ulp with linespoints \
       pointtype shape(i) pointsize size(family[i+1]) linewidth (is_ours(family[i+1]) ? 2.2 : 1.2) \
       linecolor rgb colour(family[i+1]) title columnheader(1), \
     table index 0:(n-1) using ns:(failing(max_ulp)) with points linestyle 10 title failing_title
