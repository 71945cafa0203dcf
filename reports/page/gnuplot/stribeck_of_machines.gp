# SPDX-License-Identifier: Apache-2.0
# Friction, film parameter and load share of the asperities against speed, in three panels over one
# axis, of the scenes in reference/scenes.

# A colour for each scene. Other figures have these colours for the surfaces.
scenes = "ball_on_flat bearing_outer_ring gear_flank"
colour(s) = s eq "ball_on_flat" ? 0x003468 : s eq "bearing_outer_ring" ? 0x006B50 : 0xD86400
named(s) = s eq "ball_on_flat" ? "ball on a flat (circle)" : \
  s eq "bearing_outer_ring" ? "bearing's outer ring (ellipse)" : "gear's flank (line)"
grey = 0x666666
curve(s) = data."contact_".s.".tsv"
# contact_marks.tsv has a column before those of a curve.
marks = data."contact_marks.tsv"
mark(s, y) = strcol(1) eq s ? column(y + 1) : NaN
speeds_min = 1e300; speeds_max = 0
do for [s in scenes] {
  stats curve(s) using 1 nooutput name "one"
  speeds_min = one_min < speeds_min ? one_min : speeds_min
  speeds_max = one_max > speeds_max ? one_max : speeds_max
}
load scripts."stribeck.gp"
# A line style for each scene, by which the curves differ in grey, too.
set style line 11 linewidth 2.2 dashtype solid
set style line 12 linewidth 2.2 dashtype (12,5)
set style line 13 linewidth 2.2 dashtype (12,4,3,4)
dashes(s) = s eq "ball_on_flat" ? 11 : s eq "bearing_outer_ring" ? 12 : 13

gap = 0.02
foot = 150.0/tall
panel = (1 - 78.0/tall - foot - 2*gap)/3
set multiplot
set format x ""
unset xlabel
unset key
set tmargin at screen foot + 3*panel + 2*gap
set bmargin at screen foot + 2*panel + 2*gap
set ylabel "friction coefficient μ (–)" offset y_words
set yrange [0:*]
plot \
  for [s in scenes] curve(s) using speed:friction with lines linestyle dashes(s) linecolor rgb colour(s), \
  for [s in scenes] marks using (mark(s, speed)):(mark(s, friction)) with points linestyle 7 \
    linecolor rgb colour(s)

unset title
set tmargin at screen foot + 2*panel + gap
set bmargin at screen foot + panel + gap
set ylabel "film parameter λ = h*/σ_s (–)" offset y_words
set logscale y 10
set yrange [*:*]
set format y "%g"
plot \
  for [s in scenes] curve(s) using speed:film_parameter with lines linestyle dashes(s) \
    linecolor rgb colour(s), \
  for [s in scenes] marks using (mark(s, speed)):(mark(s, film_parameter)) with points linestyle 7 \
    linecolor rgb colour(s)

set tmargin at screen foot + panel
set bmargin at screen foot
set format x "10^{%T}"
set xlabel "entrainment speed u (m/s)" offset 0, x_words
set key
set ylabel "load share of the asperities (–)" offset y_words - 1.2
unset logscale y
set yrange [0:1]
plot \
  for [s in scenes] curve(s) using speed:asperity_share with lines linestyle dashes(s) \
    linecolor rgb colour(s) title named(s), \
  for [s in scenes] marks using (mark(s, speed)):(mark(s, asperity_share)) with points linestyle 7 \
    linecolor rgb colour(s) notitle, \
  keyentry with points linestyle 7 linecolor rgb grey title "least friction"
unset multiplot
