# SPDX-License-Identifier: Apache-2.0
# The start of figures of the scenes in reference/scenes; called as style.gp is:
#   gnuplot -d -c machines.gp SCRIPT FORMAT OUTPUT DATA NAME HEIGHT TITLE SUBTITLE
script = ARG1
scripts = ARG0[1:strlen(ARG0) - strlen("machines.gp")]
data = ARG4."/"
tall = int(ARG6)
kind = ARG2; picture = ARG3; prefix = ARG5; head = ARG7; subhead = ARG8
load scripts."canvas.gp"

# A colour for each scene, of those that the surfaces have in the other figures.
scenes = "ball_on_flat bearing_outer_ring gear_flank"
colour(s) = s eq "ball_on_flat" ? 0x0072B2 : s eq "bearing_outer_ring" ? 0x009E73 : 0xD55E00
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

load scripts.script
