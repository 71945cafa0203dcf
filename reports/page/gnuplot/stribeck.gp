# SPDX-License-Identifier: Apache-2.0
# The common part of figures against speed: the columns of a curve, the speed axis and room for the
# legend. The caller sets speeds_min and speeds_max, the ends of the axis.

# Columns of a curve's .tsv.
speed = 1; film = 3; film_parameter = 5; asperity_share = 6; fluid_share = 7
area = 8; summits = 9; friction = 10; inlet = 12
# A full circle marks the onset, or another point of the curve. In an SVG the strokes of a point
# have a width that depends on its size alone.
set style line 1 linewidth 2.2 dashtype solid
set style line 7 pointtype 7 pointsize 1.1*point

# The ticks of the speed axis: powers of ten, and the greatest speed if it is not one of them.
set xrange [speeds_min:speeds_max]
set logscale x 10
set format x "10^{%T}"
set xtics 10 nomirror out scale 1,0.5
last_decade = 10**floor(log10(speeds_max) + 1e-9)
ends_between = speeds_max > 1.001*last_decade
if (ends_between) set xtics add (sprintf("%g", speeds_max) speeds_max)
set mxtics 10
set xlabel "entrainment speed u (m/s)" offset 0, x_words
# Room for a legend of three rows below the plot.
set bmargin at screen 150.0/tall
set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 3 Left reverse \
  samplen 3.5 spacing 1.25 font small
