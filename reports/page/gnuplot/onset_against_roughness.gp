# SPDX-License-Identifier: Apache-2.0
# Onset speed against roughness: bands, law, reported points.
load scripts."ledger.gp"
law = data."ledger_law.tsv"
set logscale xy 10
set xrange [20:125]
set yrange [0.002:30]
set xtics ("25 (smooth)" 25, "50 (medium)" 50, "100 (rough)" 100)
set mxtics 1
set format y "%g"
set ytics 10
set mytics 10
set xlabel "standard deviation of summit heights σ_s (nm)" offset 0, x_words
set ylabel "speed at the onset of starvation (m/s)" offset y_words - 0.6
plot \
  surfaces using sd:4:5 with filledcurves fillcolor rgb wide title "plausible inputs, 95 %", \
  surfaces using sd:6:7 with filledcurves fillcolor rgb narrow title "print precision, 95 %", \
  for [side in "4 5 6 7"] surfaces using sd:int(side) with lines linewidth 0.8 linecolor rgb edge notitle, \
  law using 1:2 with lines linewidth 2.2 linecolor rgb "#0072B2" title "film maximum, closed form", \
  law using 1:3 with lines linewidth 2.2 dashtype (12,6) linecolor rgb "#009E73" \
    title "film 5 % below the flooded one", \
  surfaces using sd:12 with points pointtype 7 pointsize 1.1*point linecolor rgb "#CC79A7" \
    title "least friction", \
  surfaces using sd:8:9:10 with yerrorbars linestyle 9 title "reported, with its print precision"
