# SPDX-License-Identifier: Apache-2.0
# Dolan and Moré's profile: columns solver, tau, fraction.
table = data."profile.blocks.tsv"
set logscale x 10
set format x "10^{%T}"
set xtics 10
set mxtics 10
set xrange [1:1e4]
set yrange [0:1.02]
set xlabel "τ, times the best solver's time for the case" offset 0, x_words
set ylabel "fraction of the cases solved to 10^{−10} within it" offset y_shift, 0
stats table using 2 nooutput
n = STATS_blocks
array family[n]
do for [i=1:n] {
  stats table index i-1 using (last = family_of(strcol(1)), $2) nooutput
  family[i] = last
}
plot for [i=0:n-1] table index i using 2:3 with linespoints pointinterval 10 \
  pointtype shape(i) pointsize 0.7*size(family[i+1]) \
  linewidth (is_ours(family[i+1]) ? 2.6 : 1.2) \
  linecolor rgb colour(family[i+1]) title columnheader(1)
