# SPDX-License-Identifier: Apache-2.0
# Figure 7, real area of contact against speed, and Figure 8, summits in contact: GT on three surfaces and GW on the smooth one.
load scripts."style.gp"
if (prefix eq "figure_07") {
  y = area
  set ylabel "real area / nominal area, A_r/A_{nom} (–)" offset y_words
  set yrange [0:*]
  # All curves begin at the same area. Each has its name where it has fallen to about half of that.
  stats marks using (mark("slowest", "smooth", "GT", y)) nooutput name "first"
  half = 0.5*first_mean
  do for [i = 1:3] {
    s = word(surfaces, i)
    undefine onset_*
    stats marks using (mark("onset", s, "GT", speed)) nooutput name "onset"
    falling = exists("onset_max") ? onset_max : speeds_max
    stats gt(s) using (column(y) > half && column(speed) <= falling ? column(speed) : NaN) nooutput name "high"
    set label s at first high_max, half center rotate by -17 offset 0,-0.75 font small textcolor rgb colour(s)
  }
  # The dotted limits of the smooth and the medium surface coincide.
  stats marks using (mark("printed", "smooth", "GT", y)) nooutput name "limit"
  if (exists("limit_mean")) { set label "smooth, medium" at graph 0.99, first limit_mean right offset 0,0.8 font small }
} else {
  y = summits
  set ylabel "summits in contact (–)" offset y_words
  set logscale y 10
  set format y "10^{%T}"
  set autoscale yfix
  set offsets 0, 0, graph 0.1, graph 0.1
}
plot \
  for [s in surfaces] gt(s) using speed:(standing(y)) with lines linestyle 1 \
    linecolor rgb colour(s) title s." (GT)", \
  gw("smooth") using speed:(standing(y)) with lines linestyle 2 \
    linecolor rgb colour("smooth") title "smooth (GW)", \
  for [s in surfaces] marks using (mark("printed", s, "GT", speed)):(mark("printed", s, "GT", y)) \
    with lines linestyle 3 linecolor rgb colour(s) notitle, \
  marks using (mark("printed", "smooth", "GW", speed)):(mark("printed", "smooth", "GW", y)) \
    with lines linestyle 3 linecolor rgb colour("smooth") notitle, \
  for [s in surfaces] marks using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", y)) \
    with points linestyle 7 linecolor rgb colour(s) notitle, \
  marks using (mark("onset", "smooth", "GW", speed)):(mark("onset", "smooth", "GW", y)) \
    with points linestyle 7 linecolor rgb colour("smooth") notitle, \
  for [s in surfaces] \
    marks using (mark("collapse", s, "GT", speed)):(mark("collapse", s, "GT", y)) \
    with points linestyle 8 linecolor rgb colour(s) notitle, \
  marks using (mark("collapse", "smooth", "GW", speed)):(mark("collapse", "smooth", "GW", y)) \
    with points linestyle 8 linecolor rgb colour("smooth") notitle, \
  for [s in surfaces] marks using (mark("slowest", s, "GT", speed)):(prefix eq "figure_07" ? NaN : mark("slowest", s, "GT", y)):(s) \
    with labels left offset 0.6,-0.8 font small textcolor rgb colour(s) notitle, \
  keyentry with points linestyle 7 linecolor rgb grey \
    title "onset (film maximum)", \
  keyentry with points linestyle 8 linecolor rgb grey title "collapse", \
  keyentry with lines linestyle 3 linecolor rgb grey title "past it, as printed"
