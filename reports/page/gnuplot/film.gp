# SPDX-License-Identifier: Apache-2.0
# Pressure and film in two panels over one axis: across a line contact, or along the middle line of an ellipse, below its maps.
# Blocks: 0 the ends of the axes, a note on the spike or a blank, and the unit of pressure; 1 the profile; 2 Hertz' pressure; 3 the formulas' films.
load scripts."sweep.gp"
stats data index 0 using (left = column(1), right = column(2), pressure_top = column(3), \
  film_top = column(4), spike_x = column(5), spike_pressure = column(6), note = strcol(7), unit = strcol(8), 0) nooutput
solved = 0x0072B2
formula(is_minimum) = int(is_minimum) ? 0xD55E00 : 0x009E73
stats data nooutput name "all"
is_point = all_blocks > 4
if (is_point) { load scripts."film_fields.gp" } else { set multiplot }
low_part = 840.0/tall  # the part of the whole height that the panels take
set lmargin at screen 0.10
set rmargin at screen 0.69
key_left = 0.705
text_left = 0.717
set xrange [left:right]

set tmargin at screen low_part - 78.0/tall
set bmargin at screen 0.535*low_part
unset xlabel
set format x ""
set yrange [0:pressure_top]
set ylabel "pressure p (".unit.")" offset y_words
set key at screen key_left, first 0.98*pressure_top left top Left reverse samplen 2 font small
set label note at first spike_x, first spike_pressure left offset 0.6, 0 font tiny textcolor rgb grey
plot \
  data index 1 using 1:2 with lines linewidth 2.2 linecolor rgb solved title "solved", \
  data index 2 using 1:2 with lines linewidth 1.2 linecolor rgb grey title "Hertz"

unset title
unset label
set tmargin at screen 0.505*low_part
set bmargin at screen 80.0/tall
set format x "%g"
set xlabel "x, along the direction of entrainment (µm)".(is_point ? ", at y = 0" : "") offset 0, x_words
set yrange [0:film_top]
set ylabel "film thickness h (µm)" offset y_words
# The names of the formulas stand outside the plot. A line joins each to the level of its film.
array levels[32]
array places[32]
array minima[32]
array texts[32]
stats data index 3 using (i = int($0) + 1, levels[i] = column(1), places[i] = column(2), \
  minima[i] = column(3), texts[i] = strcol(4), 0) nooutput name "formulas"
do for [i = 1:formulas_records] {
  set arrow from first right, first levels[i] to screen text_left - 0.005, first places[i] nohead linewidth 0.8 \
    linecolor rgb formula(minima[i])
  set label texts[i] at screen text_left, first places[i] left font small noenhanced \
    textcolor rgb formula(minima[i])
}
set label "Formulas: off the solved film" at screen text_left, first 0.97*film_top left font small
set label "(off the film of the liquid that each" at screen text_left, first 0.92*film_top left font small
set label "was fitted to; ? where not known):" at screen text_left, first 0.87*film_top left font small
set key at screen key_left, first 0.12*film_top left top Left reverse samplen 2 font small
plot \
  data index 3 using (0):1:(right):(0):(formula(column(3))) with vectors nohead linewidth 1 \
    dashtype (8,5) linecolor rgb variable notitle, \
  data index 1 using 1:3 with lines linewidth 2.2 linecolor rgb solved notitle, \
  keyentry with lines linewidth 1 dashtype (8,5) linecolor rgb formula(0) title "of the film in the middle", \
  keyentry with lines linewidth 1 dashtype (8,5) linecolor rgb formula(1) title "of the least film"
unset multiplot
