# SPDX-License-Identifier: Apache-2.0
# Figure 11: starved film of the smooth surface, GT against GW, and their ratio below.
load scripts."style.gp"
nm = 1e9
stats marks using (nm*slowest(film)) nooutput name "slowest_film"
foot = slowest_film_min/2
s = "smooth"
pale = 0x4A93C0
ratio = data."figure_11_ratio.tsv"
highest = speeds_max
stats marks using (mark("onset", s, "GT", speed)) nooutput name "onset"
if (exists("onset_max")) highest = onset_max
stats ratio using ($1 <= highest ? $2 : NaN) nooutput name "ratio"
room = 0.3*(ratio_max - ratio_min) + 1e-3
set multiplot
call scripts."panel.gp" "upper"
set ylabel "film h* (nm)" offset y_words
set logscale y 10
set yrange [foot:*]
set format y "%g"
plot \
  gt(s) using speed:(nm*standing(film)) with lines linewidth 5 linecolor rgb pale, \
  gw(s) using speed:(nm*standing(film)) with lines linestyle 2 linecolor rgb 0x222222, \
  for [m in "GT GW"] marks using (mark("onset", s, m, speed)):(nm*mark("onset", s, m, film)) \
    with points linestyle 7 linecolor rgb colour(s), \
  for [m in "GT GW"] marks using (mark("collapse", s, m, speed)):(foot) \
    with points linestyle 8 linecolor rgb colour(s)

call scripts."panel.gp" "lower"
unset logscale y
set ylabel "film with GW / film with GT (–)" offset y_words - 0.6
# Near the collapse the ratio leaves the panel: one film vanishes a little before the other.
set yrange [ratio_min - room:ratio_max + room]
set format y "%.2f"
plot \
  NaN with lines linewidth 5 linecolor rgb pale title "smooth (GT)", \
  NaN with lines linestyle 2 linecolor rgb 0x222222 title "smooth (GW)", \
  ratio using 1:2 with lines linestyle 1 linecolor rgb colour(s) \
    title "ratio of the films", \
  1 with lines linewidth 1 dashtype (6,4) linecolor rgb grey title "equal", \
  keyentry with points linestyle 7 linecolor rgb colour(s) title "onset (film maximum)", \
  keyentry with points linestyle 8 linecolor rgb colour(s) title "collapse: film 0"
unset multiplot
