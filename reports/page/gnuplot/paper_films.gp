# SPDX-License-Identifier: Apache-2.0
# Starved films of the paper's surfaces, solved and by the closures, divided by the layer of oil: a panel for each surface.
table = data."paper_films.blocks.tsv"
curves = data."paper_closures.blocks.tsv"
marks = data."marks.tsv"
mark(event, surface, y) = strcol(1) eq event && strcol(2) eq surface && strcol(3) eq "GT" ? column(y + 3) : NaN
surfaces = "smooth medium rough"
closures = "flooded_inlet starved_inlet printed_exponents damiens"
# Okabe and Ito's colours, and a dash for each.
colour(i) = word("0x0072B2 0x009E73 0xCC79A7 0xD55E00", i) + 0
set style line 1 linewidth 2.0 dashtype (12,6)
set style line 2 linewidth 2.0 dashtype (10,4,2,4)
set style line 3 linewidth 2.0 dashtype (2,4)
set style line 4 linewidth 2.0 dashtype (4,4)
set logscale x 10
set xrange [0.05:4]
set yrange [0:1.2]
set format y "%g"
set ytics 0.2 nomirror out scale 1,0.5
set xtics nomirror out scale 1,0.5 (0.05, 0.1, 0.2, 0.5, 1, 2, 3)
unset key
top = 1 - 78.0/tall; bottom = 150.0/tall; gap = 26.0/tall
panel = (top - bottom - 2*gap)/3
set multiplot
do for [i=1:3] {
  s = word(surfaces, i)
  if (i == 2) { unset title }
  set tmargin at screen top - (i - 1)*(panel + gap)
  set bmargin at screen top - (i - 1)*(panel + gap) - panel
  set ylabel s.": h*/h_{oil} (–)" offset y_words - 1, 0
  if (i < 3) {
    set format x ""
  } else {
    set format x "%g"
    set xlabel "entrainment speed u (m/s)" offset 0, x_words
    set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 3 Left reverse samplen 3.5 spacing 1.25 font small noenhanced
  }
  plot curves index i - 1 using 1:2 with lines linewidth 1.4 linecolor rgb 0x666666 title "flooded film, solved", \
    for [k=1:4] curves index i - 1 using 1:(column(k + 2)) with lines linestyle k linecolor rgb colour(k) title word(closures, k), \
    table index i - 1 using 1:2:3 with yerrorbars pointtype 7 pointsize 0.8*outline linewidth 1.3 linecolor rgb 0x000000 \
      title "starved film, solved", \
    marks using (mark("reported", s, 1)):(0.06) with points pointtype 8 pointsize 1.7*outline linewidth 1.4 linecolor rgb 0x7B3294 \
      title "onset, reported", \
    marks using (mark("onset", s, 1)):(0.06) with points pointtype 7 pointsize 1.2*outline linecolor rgb 0x7B3294 \
      title "onset (film maximum)"
}
unset multiplot
