# SPDX-License-Identifier: Apache-2.0
# How many readings reproduce how many claims.
load scripts."ledger.gp"
scores = data."ledger_scores.tsv"
set boxwidth 0.7
set bmargin at screen 90.0/tall
unset key
set xrange [-0.6:17.6]
set xtics 1
set logscale y 10
set yrange [0.7:500000]
set format y "10^{%T}"
set mytics 10
set xlabel "claims reproduced, of 17" offset 0, x_words
set ylabel "readings" offset y_words - 1
plot scores using 1:($2 > 0 ? $2 : NaN) with boxes fillcolor rgb 0x6A8FB0 notitle, \
  scores using 1:(strlen(strcol(3)) > 1 ? $2 : NaN):3 with labels left offset -2, 0.9 font small \
    textcolor rgb "#222222" notitle
