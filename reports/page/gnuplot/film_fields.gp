# SPDX-License-Identifier: Apache-2.0
# Film and pressure over an elliptical contact, as colours with contour lines, above the two panels of film.gp.
# The arrow shows the direction of entrainment. Blocks after those of film.gp: 4 the ends, sizes and colour scales of the maps; 5 x, y, film, pressure; 6 Hertz' ellipse; 7 places of the least film.
array least[2]
array most[2]
array step[2]
array heads[2]
stats data index 4 using (x_left = column(1), x_right = column(2), x_step = column(3), y_side = column(4), wide_box = column(5), \
  high_box = column(6), least[1] = column(7), most[1] = column(8), step[1] = column(9), least[2] = 0, most[2] = column(10), \
  step[2] = column(11), is_cut = column(12), film_unit = strcol(13), 0) nooutput
heads[1] = "film thickness h (".film_unit."), × where least"
heads[2] = "pressure p (".unit.")"
set datafile separator whitespace  # as gnuplot writes its tables; only numbers follow
set contour base
unset surface
set cntrparam levels incremental step[1]*ceil(least[1]/step[1]), step[1], most[1]
set table $film_lines
splot data index 5 using 1:2:3
set cntrparam levels incremental step[2], step[2], most[2]
set table $pressure_lines
splot data index 5 using 1:2:4
unset table
unset contour
set surface

set multiplot
set label 1 head."\n{/*0.8 ".subhead."}" at screen 0.5, screen 1 - 24.0/tall center
unset title
unset key
unset grid
unset colorbox
set border 15 linewidth 0.8
set xrange [x_left:x_right]
set yrange [-y_side:y_side]
set xlabel "x (µm)" offset 0, x_words
set xtics x_step
set ytics x_step
# Cividis, as in sweep_film_map.gp.
set palette defined (0 "#00224e", 0.125 "#123570", 0.25 "#3b496c", 0.375 "#575d6d", 0.5 "#707173", \
  0.625 "#8a8678", 0.75 "#a59c74", 0.875 "#c3b369", 1 "#fee838")
map_top = 1 - 112.0/tall; map_bottom = map_top - high_box/tall
set tmargin at screen map_top
set bmargin at screen map_bottom
do for [i = 1:2] {
  map_left = (i == 1 ? 100.0 : 556.0)/960 + (300 - wide_box)/2/960
  set lmargin at screen map_left
  set rmargin at screen map_left + wide_box/960
  set label 2 heads[i] at screen map_left + wide_box/2/960, screen map_top + 14.0/tall center font small
  set arrow 1 from graph 0.05, graph 0.06 to graph 0.2, graph 0.06 size screen 0.008, 25 filled front linewidth 1.4 \
    linecolor rgb i == 1 ? "#000000" : "#ffffff"
  set label 3 "u" at graph 0.23, graph 0.06 left font small front textcolor rgb i == 1 ? "#000000" : "#ffffff"
  if (i == 1) { set ylabel "y (µm)" offset y_words - 1 } else { unset ylabel }
  set cbrange [least[i]:most[i]]
  far = most[i] - step[i]
  set cbtics 0, 2*step[i], far nomirror out scale 0.5 font small
  set cbtics add (sprintf(i == 1 || int(is_cut) ? "≥ %g" : "%g", most[i]) most[i])
  set colorbox user origin screen map_left + (wide_box + 12)/960, screen map_bottom size screen 14.0/960, screen high_box/tall
  plot \
    data index 5 using 1:2:(column(i + 2)) with image, \
    (i == 1 ? "$film_lines" : "$pressure_lines") using 1:2 with lines linewidth 0.8 linecolor rgb "#ffffff", \
    data index 6 using 1:2 with lines linewidth 1.4 dashtype (8,5) linecolor rgb "#ffffff", \
    data index 7 using 1:(i == 1 ? $2 : NaN) with points pointtype 2 pointsize 1.3*point linewidth 1.6 linecolor rgb "#D55E00"
  unset label 1
}
unset label
unset arrow
unset colorbox
set xtics autofreq
set ytics autofreq
set border 3 linewidth 0.8
set grid xtics ytics
set datafile separator "\t"
