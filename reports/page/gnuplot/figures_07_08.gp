# SPDX-License-Identifier: Apache-2.0
# Figure 7, real area of contact against speed, and Figure 8, summits in contact: GT on three surfaces and GW on the smooth one.
load scripts."style.gp"
if (prefix eq "figure_07") {
  y = area
  set ylabel "real area / nominal area, A_r/A_{nom} (–)" offset y_words
  set yrange [0:*]
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
  for [s in surfaces] marks using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", y)):(s) with labels right \
    offset -0.9,0.7 font small textcolor rgb colour(s) notitle, \
  keyentry with points linestyle 7 linecolor rgb grey \
    title "onset (film maximum)", \
  keyentry with points linestyle 8 linecolor rgb grey title "collapse", \
  keyentry with lines linestyle 3 linecolor rgb grey title "past the collapse, as printed"
