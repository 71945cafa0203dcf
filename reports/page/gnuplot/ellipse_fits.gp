# SPDX-License-Identifier: Apache-2.0
# Errors of the published fits to Hertz' ellipse over the ratio of the radii: three panels over one axis.
table = data."ellipse_fits.blocks.tsv"
stats table using 1 nooutput name "ratios"
fits = ratios_blocks
# Okabe and Ito's colours, and a dash for each.
colour(i) = word("0xD55E00 0x0072B2 0x009E73 0x000000", i + 1) + 0
set style line 1 linewidth 2.2 dashtype solid
set style line 2 linewidth 2.2 dashtype (12,6)
set style line 3 linewidth 2.2 dashtype (10,4,2,4)
set style line 4 linewidth 2.2 dashtype (2,4)
set logscale xy 10
set xrange [ratios_min:ratios_max]
set yrange [0.005:100]
set format y "%g"
set ytics 10 nomirror out scale 1,0.5
set xtics 10 nomirror out scale 1,0.5
set mxtics 10
set mytics 10
unset key
top = 1 - 78.0/tall; bottom = 130.0/tall; gap = 22.0/tall
panel = (top - bottom - 2*gap)/3
set multiplot
do for [i=0:2] {
  if (i == 1) { unset title }
  set tmargin at screen top - i*(panel + gap)
  set bmargin at screen top - i*(panel + gap) - panel
  set ylabel "|error| of ".word("k a_x p_0", i + 1)." (%)" offset y_words, 0
  if (i < 2) {
    set format x ""
  } else {
    set format x "10^{%T}"
    set xlabel "ratio of the radii α = R_y/R_x" offset 0, x_words
    set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 2 Left reverse samplen 3.5 spacing 1.25 \
      font small noenhanced
  }
  plot for [fit=0:fits-1] table index fit using 1:(100*abs(column(i + 2))) with lines linestyle (fit + 1) \
    linecolor rgb colour(fit) title columnheader(1)
}
unset multiplot
