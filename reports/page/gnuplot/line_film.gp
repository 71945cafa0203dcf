# SPDX-License-Identifier: Apache-2.0
# Pressure and film across a line contact, in two panels over one axis, from DATA/NAME.tsv with the columns x/b,
# p/p0, Hertz' p/p0 and film in micrometre.
table = data.prefix.".tsv"
stats table using ($1 >= -1 && $1 <= 1 ? $2 : 1/0) nooutput name "pressure"
stats table using ($1 >= -0.5 && $1 <= 0.5 ? $4 : 1/0) nooutput name "film"
set xtics 0.5 nomirror out scale 1,0.5
set mxtics 5
set xrange [-2:1.5]
top = 1 - 78.0/tall; bottom = 110.0/tall; gap = 24.0/tall
panel = (top - bottom - gap)/2
words = y_words - 1
set multiplot
set tmargin at screen top
set bmargin at screen top - panel
set format x ""
set yrange [0:1.15*(pressure_max > 1 ? pressure_max : 1)]
set ylabel "pressure p/p_0 (–)" offset words
unset key
if (prefix eq "line_film_profile") {
  stats table using ($1 > 0.5 && $1 < 1 ? $1 : 1/0):2 nooutput name "outlet"
  set label 1 "its height is not resolved" at first outlet_pos_max_y, outlet_max_y right offset -0.6,-0.2 font small
}
plot table using 1:2 with lines linewidth 2.2 linecolor rgb 0xD55E00, \
  table using 1:3 with lines linewidth 1.8 dashtype (8,5) linecolor rgb 0x0072B2
unset title
unset label 1
set tmargin at screen bottom + panel
set bmargin at screen bottom
set format x "%g"
set xlabel "place across the contact x/b (–); the surfaces move to the right" offset 0, x_words
set yrange [0:2.5*film_mean]
set ylabel "film h (µm)" offset words
set key at screen 0.54, screen 4.0/tall center bottom horizontal Left reverse samplen 3.5 font small
plot table using 1:4 with lines linewidth 2.2 linecolor rgb 0xD55E00 title "solved", \
  keyentry with lines linewidth 1.8 dashtype (8,5) linecolor rgb 0x0072B2 title "dry contact of Hertz"
unset multiplot
