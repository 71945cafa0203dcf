# SPDX-License-Identifier: Apache-2.0
# Films of line contacts: greatest relative error against CPU time, a line a way from coarse to fine.
# Columns: job, family, series, name, ns, steps, greatest and mean relative error, no numbers, judged.
load scripts."work.gp"
table = data.prefix.".blocks.tsv"
most = 12
set logscale xy 10
set format x "10^{%T}"
set format y "10^{%T}"
set xtics 10
set ytics 10
set mxtics 10
set xlabel "CPU time a contact (s)" offset 0, x_words
set ylabel "greatest relative error (–)" offset y_shift, 0
stats table using 5 nooutput
n = STATS_blocks < most ? STATS_blocks : most
array family[n]
do for [i=1:n] {
  stats table index i-1 using (last = strcol(2), $5) nooutput
  family[i] = last
}
# A cross where a way gave no number, if any did.
stats table using ($9 > 0 ? $5 : NaN) nooutput name "missing"
crosses = exists("missing_records") && missing_records > 0
plot for [i=0:n-1] table index i using ($5*1e-9):7 with linespoints \
       pointtype shape(i) pointsize size(family[i+1]) linewidth (is_ours(family[i+1]) ? 2.2 : 1.2) \
       linecolor rgb colour(family[i+1]) title columnheader(1), \
     table index 0:(n-1) using ($5*1e-9):($9 > 0 ? $7 : NaN) with points linestyle 10 \
       title crosses ? "no number in some cases" : ""
