# SPDX-License-Identifier: Apache-2.0
# Asperity share at the lowest speed against roughness.
load scripts."ledger.gp"
law = data."ledger_law.tsv"
set logscale x 10
set xrange [20:125]
set yrange [0:1.05]
set xtics ("25 (smooth)" 25, "50 (medium)" 50, "100 (rough)" 100)
set mxtics 1
set xlabel "standard deviation of summit heights σ_s (nm)" offset 0, x_words
set ylabel "load share of the asperities" offset y_words
plot \
  surfaces using sd:13:14 with filledcurves fillcolor rgb wide title "plausible inputs, 95 %", \
  surfaces using sd:15:16 with filledcurves fillcolor rgb narrow title "print precision, 95 %", \
  for [side in "13 14 15 16"] surfaces using sd:int(side) with lines linewidth 0.8 linecolor rgb edge notitle, \
  law using 1:4 with lines linewidth 2.2 linecolor rgb "#0072B2" title "corrected reading", \
  surfaces using sd:17:18:19 with yerrorbars linestyle 9 title "reported, with its print precision"
