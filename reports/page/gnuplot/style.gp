# SPDX-License-Identifier: Apache-2.0
# What all figures share, and the start of each. tribocheck report calls it as
#   gnuplot -d -c style.gp SCRIPT FORMAT OUTPUT DATA NAME HEIGHT TITLE SCENE
# with SCRIPT the figure's own, beside this one, FORMAT svg or png, DATA the folder of the .tsv
# files, NAME a prefix for the identifiers in an SVG, HEIGHT in points for a width of 960. `load`
# forgets the arguments.
script = ARG1
scripts = ARG0[1:strlen(ARG0) - strlen("style.gp")]
data = ARG4."/"
tall = int(ARG6)
kind = ARG2; picture = ARG3; prefix = ARG5; head = ARG7; subhead = ARG8
load scripts."canvas.gp"

# Okabe and Ito's colours, told apart by every eye; one for each surface, in every figure.
colour(surface) = surface eq "rough" ? 0xD55E00 : surface eq "medium" ? 0x009E73 : 0x0072B2
grey = 0x666666
surfaces = "rough medium smooth"
set style line 1 linewidth 2.2 dashtype solid
set style line 2 linewidth 2.2 dashtype (12,6)     # Greenwood-Williamson
set style line 3 linewidth 1.6 dashtype (2,4)      # past the collapse
set style line 4 linewidth 2.2 dashtype (10,4,2,4) # the fluid

# Columns of curve_*.tsv; marks.tsv has three more before them.
speed = 1; film = 3; film_parameter = 5; asperity_share = 6; fluid_share = 7
area = 8; summits = 9; friction = 10; inlet = 12
curve(stem) = data."curve_".stem.".tsv"
gt(surface) = curve(surface)
gw(surface) = curve(surface."_gw")
marks = data."marks.tsv"
standing(y) = strcol(inlet) eq "collapsed" ? NaN : column(y)
collapsed(y) = strcol(inlet) eq "collapsed" ? column(y) : NaN
is_mark(event, surface, model) = \
  strcol(1) eq event && strcol(2) eq surface && strcol(3) eq model
mark(event, surface, model, y) = is_mark(event, surface, model) ? column(y + 3) : NaN
slowest(y) = strcol(1) eq "slowest" ? column(y + 3) : NaN
# Points: a full circle at the onset, a cross at the collapse, and an open triangle at the onset
# speed that the paper reports. In an SVG the strokes of a point grow with its size alone.
set style line 7 pointtype 7 pointsize 1.1*point
set style line 8 pointtype 2 pointsize 1.4*outline linewidth 1.6
set style line 9 pointtype 8 pointsize 1.7*outline linewidth 1.4

# The speed axis: powers of ten, and the last speed of the scenes.
stats gt("rough") using speed nooutput name "speeds"
set xrange [speeds_min:speeds_max]
set logscale x 10
set format x "10^{%T}"
set xtics 10 nomirror out scale 1,0.5
set xtics add (sprintf("%g", speeds_max) speeds_max)
set mxtics 10
set xlabel "entrainment speed u (m/s)" offset 0, x_words
set ytics nomirror out scale 1,0.5
set border 3 linewidth 0.8
set grid xtics ytics linetype 1 linecolor rgb "#e4e4e4" linewidth 0.6
# Room for a legend of three rows below the plot.
set lmargin at screen 0.11
set rmargin at screen 0.97
set tmargin at screen 1 - 78.0/tall
set bmargin at screen 150.0/tall
set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 3 Left reverse \
  samplen 3.5 spacing 1.25 font small

load scripts.script
