# SPDX-License-Identifier: Apache-2.0
# Figure 10: starved film against speed on three surfaces.
load scripts."style.gp"
nm = 1e9
stats marks using (nm*slowest(film)) nooutput name "slowest_film"
foot = slowest_film_min/2
set ylabel "film h* (nm)" offset y_words
set logscale y 10
set yrange [foot:*]
set format y "%g"
plot \
  for [s in surfaces] gt(s) using speed:(nm*standing(film)) with lines linestyle 1 \
    linecolor rgb colour(s) title s." (GT)", \
  for [s in surfaces] marks \
    using (mark("reported", s, "GT", speed)):(nm*mark("reported", s, "GT", film)) \
    with points linestyle 9 linecolor rgb colour(s) notitle, \
  for [s in surfaces] marks \
    using (mark("onset", s, "GT", speed)):(nm*mark("onset", s, "GT", film)) \
    with points linestyle 7 linecolor rgb colour(s) notitle, \
  for [s in surfaces] marks using (mark("onset", s, "GT", speed)):(nm*mark("onset", s, "GT", film)):(s) with labels center \
    offset 0,-1.1 font small textcolor rgb colour(s) notitle, \
  for [s in surfaces] marks using (mark("collapse", s, "GT", speed)):(foot) \
    with points linestyle 8 linecolor rgb colour(s) notitle, \
  keyentry with points linestyle 7 linecolor rgb grey title "onset (film maximum)", \
  keyentry with points linestyle 9 linecolor rgb grey title "onset speed as the paper reports it", \
  keyentry with points linestyle 8 linecolor rgb grey title "collapse: film 0"
