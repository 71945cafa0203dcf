# SPDX-License-Identifier: Apache-2.0
# True error against evaluations of the integrand or the moment. Their number is the same on every machine.
load scripts."work.gp"
table = data.prefix.".blocks.tsv"
set logscale xy 10
set format y "10^{%T}"
set ytics 100
set xlabel "evaluations a point" offset 0, x_words
set ylabel "true error (ulp), greatest" offset y_shift, 0
stats table using ns nooutput
n = STATS_blocks < most ? STATS_blocks : most
counted = ""
array family[n]
do for [i=0:n-1] {
  stats table index i using (last = strcol(2), is_counted = strcol(evaluations) ne "NaN", $5) nooutput
  if (is_counted) { counted = counted.sprintf(" %d", i) }
  family[i+1] = last
}
plot for [i in counted] table index (i + 0) using evaluations:max_ulp with linespoints \
  pointtype shape(i) pointsize size(family[i+1]) linewidth (is_ours(family[i+1]) ? 2.2 : 1.2) \
  linecolor rgb colour(family[i+1]) title columnheader(1), \
  table index 0:(n-1) using evaluations:(failing(max_ulp)) with points linestyle 10 title failing_title
