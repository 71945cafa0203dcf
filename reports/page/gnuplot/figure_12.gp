# SPDX-License-Identifier: Apache-2.0
# Figure 12: friction, and the film parameter below it, against speed.
load scripts."style.gp"
drawn(y) = strcol(3) eq "GT" || strcol(2) eq "smooth" ? y : NaN
stats marks using (drawn(slowest(friction))) nooutput name "slowest_friction"
head = 1.15*slowest_friction_max
stats data."comparison.tsv" using (strcol(1) eq "onset_film_parameter" ? column(6) : NaN) \
  nooutput name "paper"
set multiplot
call scripts."panel.gp" "upper"
set ylabel "friction coefficient μ (–)" offset y_words
set yrange [0:head]
plot \
  for [s in surfaces] gt(s) using speed:(standing(friction)) with lines linestyle 1 \
    linecolor rgb colour(s), \
  gw("smooth") using speed:(standing(friction)) with lines linestyle 2 \
    linecolor rgb colour("smooth"), \
  for [s in surfaces] marks \
    using (mark("reported", s, "GT", speed)):(mark("reported", s, "GT", friction)) \
    with points linestyle 9 linecolor rgb colour(s), \
  for [s in surfaces] marks \
    using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", friction)) \
    with points linestyle 7 linecolor rgb colour(s), \
  marks using (mark("onset", "smooth", "GW", speed)):(mark("onset", "smooth", "GW", friction)) \
    with points linestyle 7 linecolor rgb colour("smooth"), \
  for [s in surfaces] marks using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", friction)):(s) with labels center \
    offset 0,-1.4 font small textcolor rgb colour(s) notitle, \
  for [s in surfaces] marks using (mark("slowest", s, "GT", speed)):(mark("slowest", s, "GT", friction)):(s) with labels left \
    offset 0.6,-0.7 font small textcolor rgb colour(s) notitle, \
  for [s in surfaces] marks using (mark("collapse", s, "GT", speed)):(head) \
    with points linestyle 8 linecolor rgb colour(s)

# The film parameter: a linear axis, which can show the 0 of a collapsed film.
call scripts."panel.gp" "lower"
set ylabel "film parameter λ = h*/σ_s (–)" offset y_words
set yrange [0:*]
plot \
  for [s in surfaces] gt(s) using speed:(standing(film_parameter)) with lines linestyle 1 \
    linecolor rgb colour(s) title s." (GT)", \
  gw("smooth") using speed:(standing(film_parameter)) with lines linestyle 2 \
    linecolor rgb colour("smooth") title "smooth (GW)", \
  paper_mean with lines linewidth 1.4 dashtype (6,4) linecolor rgb grey \
    title sprintf("λ = %g, reported", paper_mean), \
  for [s in surfaces] marks \
    using (mark("reported", s, "GT", speed)):(mark("reported", s, "GT", film_parameter)) \
    with points linestyle 9 linecolor rgb colour(s) notitle, \
  for [s in surfaces] marks \
    using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", film_parameter)) \
    with points linestyle 7 linecolor rgb colour(s) notitle, \
  marks \
    using (mark("onset", "smooth", "GW", speed)):(mark("onset", "smooth", "GW", film_parameter)) \
    with points linestyle 7 linecolor rgb colour("smooth") notitle, \
  for [s in surfaces] \
    marks using (mark("collapse", s, "GT", speed)):(mark("collapse", s, "GT", film_parameter)) \
    with points linestyle 8 linecolor rgb colour(s) notitle, \
  for [s in surfaces] marks using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", film_parameter)):(s) with labels right \
    offset -0.9,0.7 font small textcolor rgb colour(s) notitle, \
  keyentry with points linestyle 7 linecolor rgb grey title "onset (film maximum)", \
  keyentry with points linestyle 9 linecolor rgb grey title "onset speed, reported", \
  keyentry with points linestyle 8 linecolor rgb grey title "collapse"
unset multiplot
