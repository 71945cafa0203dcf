# SPDX-License-Identifier: Apache-2.0
# Figure 4: film against speed, u^0.67 flooded and u^−1 starved.
load scripts."style.gp"
nm = 1e9
slope_curve(name) = data."figure_04_".name.".tsv"
guides = data."figure_04_guides.tsv"
marked = data."figure_04_marks.tsv"
s = "smooth"
stats slope_curve("damiens") using (nm*column(film)) nooutput name "damiens"
foot = damiens_min/3
slope_text(slope) = sprintf("slope %s%g", slope < 0 ? "−" : "", abs(slope))
set ylabel "film h* (nm)" offset y_words
set logscale y 10
set yrange [foot:*]
set format y "%g"
plot \
  slope_curve("flooded") using speed:(nm*column(film)) with lines linewidth 1.6 \
    dashtype (14,6) linecolor rgb colour(s) title "flooded inlet (no supply)", \
  slope_curve("starved_inlet") using speed:(nm*column(film)) with lines linestyle 4 \
    linecolor rgb colour(s) title "starved\\_inlet, constant flow", \
  slope_curve("damiens") using speed:(nm*column(film)) with lines linewidth 2.2 \
    dashtype (3,3) linecolor rgb colour(s) title "damiens, constant flow", \
  gt(s) using speed:(nm*standing(film)) with lines linestyle 1 linecolor rgb colour(s) \
    title "the paper's closure, constant h_{oil}", \
  for [i = 0:1] guides index i using 1:(nm*$2) with lines linewidth 1.2 linecolor rgb grey \
    notitle, \
  guides index 0 every ::1::1 using 1:(nm*$2):(slope_text($3)) with labels right \
    offset -1, 0.6 textcolor rgb grey notitle, \
  guides index 1 every ::1::1 using 1:(nm*$2):(slope_text($3)) with labels left \
    offset 1, 0.6 textcolor rgb grey notitle, \
  marked using 2:(nm*$4) with points linestyle 7 linecolor rgb colour(s) notitle, \
  marks using (mark("onset", s, "GT", speed)):(nm*mark("onset", s, "GT", film)) \
    with points linestyle 7 linecolor rgb colour(s) \
    title "onset (film maximum)", \
  marks using (mark("collapse", s, "GT", speed)):(foot) with points linestyle 8 \
    linecolor rgb colour(s) title "collapse: film 0"
