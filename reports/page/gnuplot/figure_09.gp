# SPDX-License-Identifier: Apache-2.0
# Figure 9: load shares of fluid and asperities against speed.
load scripts."style.gp"
set ylabel "share of the load (–)" offset y_words
set yrange [0:1]
plot \
  for [s in surfaces] gt(s) using speed:(standing(asperity_share)) with lines linestyle 1 \
    linecolor rgb colour(s) title "asperities, ".s, \
  for [s in surfaces] gt(s) using speed:(standing(fluid_share)) with lines linestyle 4 \
    linecolor rgb colour(s) title "fluid, ".s, \
  for [s in surfaces] for [share in "asperity_share fluid_share"] marks \
    using (mark("printed", s, "GT", speed)):(mark("printed", s, "GT", value(share))) \
    with lines linestyle 3 linecolor rgb colour(s) notitle, \
  for [s in surfaces] for [share in "asperity_share fluid_share"] marks \
    using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", value(share))) \
    with points linestyle 7 linecolor rgb colour(s) notitle, \
  for [s in surfaces] for [share in "asperity_share fluid_share"] marks \
    using (mark("collapse", s, "GT", speed)):(mark("collapse", s, "GT", value(share))) \
    with points linestyle 8 linecolor rgb colour(s) notitle, \
  for [s in surfaces] marks using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", asperity_share)):(s) with labels center \
    offset 0,-0.8 font small textcolor rgb colour(s) notitle, \
  for [s in surfaces] marks using (mark("onset", s, "GT", speed)):(mark("onset", s, "GT", fluid_share)):(s) with labels center \
    offset 0,0.8 font small textcolor rgb colour(s) notitle, \
  for [s in surfaces] for [share in "asperity_share fluid_share"] marks \
    using (mark("slowest", s, "GT", speed)):(mark("slowest", s, "GT", value(share))):(s) \
    with labels left offset 0.6,-0.7 font small textcolor rgb colour(s) notitle, \
  keyentry with points linestyle 7 linecolor rgb grey \
    title "onset (film maximum)", \
  keyentry with points linestyle 8 linecolor rgb grey title "collapse", \
  keyentry with lines linestyle 3 linecolor rgb grey title "past it, as printed"
