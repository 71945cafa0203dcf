# SPDX-License-Identifier: Apache-2.0
# Errors of the formulas for the film of a line contact over the numbers of load and of material: six panels with
# one scale.
table = data."line_film_errors.tsv"
labels = data."line_film_labels.blocks.tsv"
tracks = data."line_film_tracks.blocks.tsv"
array title_of[6] = ["Moes: at the greatest pressure", "Ertel and Grubin: at the greatest pressure", \
  "Dowson and Higginson: minimum (liquid not known)", "Dowson and Toyoda: central (liquid not known)", \
  "Pan and Hamrock: minimum (compressible)", "Pan and Hamrock: central (compressible)"]
stats table using 1 nooutput name "load"
stats table using 2 nooutput name "material"
track_count = 0
stats tracks using 2 nooutput name "track"
if (track_records > 0) { track_count = track_blocks }

# Contour lines: dashed below 0, solid above 0, thick at 0. The table's places are even in the logarithms of M and L.
unset surface
set contour base
do for [i=1:6] {
  set cntrparam levels discrete -70, -50, -30, -20, -10, -5, -2
  eval sprintf("set table $below%d", i)
  splot table using 1:2:(column(i + 2))
  set cntrparam levels discrete 2, 5, 10, 20, 30, 50, 70
  eval sprintf("set table $above%d", i)
  splot table using 1:2:(column(i + 2))
  set cntrparam levels discrete 0
  eval sprintf("set table $zero%d", i)
  splot table using 1:2:(column(i + 2))
}
unset table
unset contour
set surface
set datafile separator whitespace  # as gnuplot writes its tables; texts are quoted

# Colours by the logarithm of the error, so that 2 % is seen beside 50 %. Blue is below 0, orange above. The blue of an
# error is darker than the orange of the same size, so that the two differ in grey, too.
shade(error) = sgn(error)*log(1 + abs(error)/2)
set palette defined (-1 "#4f86c6", -0.55 "#8db5e0", -0.2 "#cfe0f2", 0 "#ffffff", 0.2 "#fdeacb", 0.55 "#f9cf8a", 1 "#f0a030")
set cbrange [shade(-70):shade(70)]
set style line 1 linewidth 1.2 linecolor rgb 0x000000 dashtype (8,5)
set style line 2 linewidth 1.2 linecolor rgb 0x000000
set style line 3 linewidth 2.6 linecolor rgb 0x000000
set style line 4 linewidth 4.5 linecolor rgb 0xffffff
set style line 5 linewidth 2 linecolor rgb 0x6a1b7a
set style line 6 pointtype 7 pointsize 0.9*point linecolor rgb 0x6a1b7a
# White boxes behind the labels, with sizes in parts of a panel. gnuplot's own boxes would print each text twice.
set style line 7 linewidth 0 linecolor rgb 0xffffff
set style fill solid noborder
wide = log(load_max/load_min); high = log(material_max/material_min)
left(x) = x*exp(-0.058*wide); right(x) = x*exp(0.058*wide)
below(y) = y*exp(-0.026*high); above(y) = y*exp(0.026*high)
beside(x) = x*exp(0.09*wide)
named(y) = strlen(strcol(5)) > 0 ? y : NaN
words = kind eq "svg" ? ",13" : ",9.5"
contour(i, side) = sprintf("$%s%d", side, i)

top = 1 - 108.0/tall; bottom = 200.0/tall; gap = 112.0/tall
panel = (top - bottom - 2*gap)/3
set border linewidth 1
unset title
set multiplot
set label 1 head."\n{/*0.8 ".subhead."}" at screen 0.5, screen 1 - 24.0/tall center
do for [i=1:6] {
  row = (i - 1)/2; place = (i - 1) % 2
  set lmargin at screen 0.075 + 0.485*place
  set rmargin at screen 0.485 + 0.485*place
  set tmargin at screen top - row*(panel + gap)
  set bmargin at screen top - row*(panel + gap) - panel
  # The colours. An image needs even places, so that the axes are logarithms.
  unset logscale
  unset xtics
  unset ytics
  unset border
  unset grid
  unset key
  unset xlabel
  unset ylabel
  unset title
  set xrange [log10(load_min):log10(load_max)]
  set yrange [log10(material_min):log10(material_max)]
  unset colorbox
  if (i == 6) {
    set colorbox horizontal user origin screen 0.16, screen 110.0/tall size screen 0.7, screen 18.0/tall
    set cbtics () scale 0.5
    do for [one in "-50 -20 -10 -5 -2 0 2 5 10 20 50"] {
      set cbtics add ((real(one) > 0 ? "+" : real(one) < 0 ? "−" : "").sprintf("%g", abs(real(one))) shade(real(one)))
    }
    set cblabel "error of the formula's film (%): (formula − solved)/solved" offset 0, (kind eq "svg" ? 0.6 : 0)
  }
  plot table using (log10($1)):(log10($2)):(shade(column(i + 2))) with image
  unset label 1
  # The lines, on logarithmic axes.
  set border 15 linewidth 0.8
  set logscale xy 10
  set xrange [load_min:load_max]
  set yrange [material_min:material_max]
  set xtics ("1" 1, "2" 2, "5" 5, "10" 10, "20" 20, "50" 50, "100" 100, "200" 200) nomirror out scale 1,0.5
  set ytics ("1" 1, "2" 2, "5" 5, "10" 10, "20" 20) nomirror out scale 1,0.5
  set title title_of[i] offset 0, (kind eq "svg" ? 0 : -0.4)
  set xlabel "load number M (–)" offset 0, x_words
  if (place == 0) { set ylabel "material number L (–)" offset y_words - 1 }
  if (i == 6 && track_count > 0) {
    set key at screen 0.5, screen 4.0/tall center bottom horizontal maxrows 2 Left reverse samplen 3.5 font small noenhanced
  }
  plot \
    contour(i, "below") using 1:2 with lines linestyle 1 notitle, \
    contour(i, "above") using 1:2 with lines linestyle 2 notitle, \
    contour(i, "zero") using 1:2 with lines linestyle 3 notitle, \
    for [t=0:track_count-1] tracks index t using 1:2 with lines linestyle 4 notitle, \
    for [t=0:track_count-1] tracks index t using 1:2 with lines linestyle 5 dashtype t + 1 \
      title i == 6 ? columnheader(1) : "", \
    for [t=0:track_count-1] tracks index t using 1:($4 > 0 ? $2 : NaN) with points linestyle 6 notitle, \
    for [t=0:track_count-1] tracks index t using (beside($1)):(named($2)):(left(beside($1))):(right(beside($1))): \
      (below($2)):(above($2)) with boxxyerror linestyle 7 notitle, \
    for [t=0:track_count-1] tracks index t using (beside($1)):(named($2)):5 with labels font words \
      textcolor rgb 0x6a1b7a notitle, \
    labels index i - 1 using 1:2:(left($1)):(right($1)):(below($2)):(above($2)) with boxxyerror linestyle 7 notitle, \
    labels index i - 1 using 1:2:4 with labels font words notitle
  unset key
}
unset multiplot
