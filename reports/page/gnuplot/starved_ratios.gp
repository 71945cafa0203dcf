# SPDX-License-Identifier: Apache-2.0
# Starved film divided by flooded film, solved and by the closures, against the layer of oil; and the exponent γ that fits Damiens' closure to it.
table = data."starved_ratios.blocks.tsv"
curves = data."starved_closures.tsv"
stats table using 1 nooutput name "supplies"
contacts = supplies_blocks
closures = "flooded_inlet starved_inlet printed_exponents damiens"
colour(i) = word("0x0072B2 0x009E73 0xCC79A7 0xD55E00", i) + 0
set style line 1 linewidth 2.0 dashtype (12,6)
set style line 2 linewidth 2.0 dashtype (10,4,2,4)
set style line 3 linewidth 2.0 dashtype (2,4)
set style line 4 linewidth 2.0 dashtype (4,4)
set logscale x 10
set xrange [0.2:5]
set format y "%g"
set xtics nomirror out scale 1,0.5 (0.2, 0.5, 1, 2, 5)
unset key
top = 1 - 78.0/tall; bottom = 215.0/tall; gap = 26.0/tall
panel = (top - bottom - gap)/2
set multiplot
set tmargin at screen top
set bmargin at screen top - panel
set format x ""
set yrange [0:1.05]
set ylabel "starved over flooded film ℛ (–)" offset y_words - 1, 0
plot for [k=1:4] curves using 1:(column(k + 1)) with lines linestyle k linecolor rgb colour(k) notitle, \
  for [i=0:contacts-1] table index i using 1:2:3 with yerrorbars pointtype i + 1 pointsize 0.9*outline linewidth 1.3 linecolor rgb 0x000000 notitle
unset title
set tmargin at screen bottom + panel
set bmargin at screen bottom
set format x "%g"
set xlabel "layer of oil over the flooded film ρ (–)" offset 0, x_words
set yrange [2:*]
set ylabel "exponent γ of Damiens (–)" offset y_words - 1, 0
set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 5 Left reverse samplen 3 spacing 1.2 font small noenhanced
plot for [k=1:4] keyentry with lines linestyle k linecolor rgb colour(k) title word(closures, k), \
  for [i=0:contacts-1] table index i using 1:4 with linespoints pointtype i + 1 pointsize 0.9*outline linewidth 1.3 linecolor rgb 0x444444 \
    title columnheader(1)
unset multiplot
