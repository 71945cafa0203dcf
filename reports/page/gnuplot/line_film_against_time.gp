# SPDX-License-Identifier: Apache-2.0
# Films of line or of point contacts: greatest relative error against CPU time. Each way is a line from coarse to fine.
# Columns: job, family, series, name, ns, steps, greatest and mean relative error, no numbers, judged.
load scripts."work.gp"
table = data.prefix.".blocks.tsv"
set logscale xy 10
set format x "10^{%T}"
set format y "10^{%T}"
set xtics 10
set ytics 10
set mxtics 10
set xlabel "CPU time a contact (s)" offset 0, x_words
set ylabel "greatest relative error (–)" offset y_shift, 0
stats table using 5 nooutput
# At most eight ways are drawn. Formulas of the minimum film are left out.
array family[most]
array place[most]
n = 0
do for [i=0:STATS_blocks-1] {
  stats table index i using (last = strcol(2), name = strcol(4), $5) nooutput
  if (n < most && strstrt(name, "_minimum") == 0) {
    n = n + 1
    family[n] = last
    place[n] = i
  }
}
# A cross marks a way that gave no number in some cases. The legend names it only where there is one.
stats table using ($9 > 0 ? $5 : NaN) nooutput name "missing"
crosses = exists("missing_records") && missing_records > 0
plot for [i=1:n] table index place[i] using ($5*1e-9):7 with linespoints \
       pointtype shape(i-1) pointsize size(family[i]) linewidth (is_ours(family[i]) ? 2.2 : 1.2) \
       linecolor rgb colour(family[i]) title columnheader(1), \
     table using ($5*1e-9):($9 > 0 ? $7 : NaN) with points linestyle 10 \
       title crosses ? "no number in some cases" : ""
