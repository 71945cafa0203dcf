# SPDX-License-Identifier: Apache-2.0
# Starts every figure, on a canvas 960 points wide. Called as
#   gnuplot -d -c canvas.gp SCRIPT FORMAT OUTPUT DATA NAME HEIGHT TITLE SUBTITLE
# SCRIPT draws the figure and lies beside this file. FORMAT is svg or png, DATA the folder of the .tsv files, NAME a prefix for the
# identifiers in an SVG, HEIGHT is in points. A loaded script does not see ARG1 and so on: they are copied.
script = ARG1; kind = ARG2; picture = ARG3; data = ARG4."/"; prefix = ARG5; tall = int(ARG6); head = ARG7; subhead = ARG8
scripts = ARG0[1:strlen(ARG0) - strlen("canvas.gp")]
set encoding utf8
set minussign
if (kind eq "svg") {
  set terminal svg size 960,tall dynamic mousing enhanced font "DejaVu Sans,Verdana,sans-serif,16" \
    name prefix background rgb "white" linewidth 1.2
  small = ",14"
  point = 0.6; outline = 0.9; x_words = 0.75; y_words = 2
} else {
  set terminal pngcairo size 1920,2*tall enhanced font "DejaVu Sans,12" fontscale 2 \
    background rgb "white" linewidth 2.4 pointscale 2
  small = ",10.5"
  point = 1; outline = 1; x_words = 0; y_words = 0
}
set output picture
set datafile separator "\t"
set datafile commentschars "#"
set title head."\n{/*0.8 ".subhead."}"

# Most figures have these. A figure that has others sets them itself.
set border 3 linewidth 0.8
set grid xtics ytics linetype 1 linecolor rgb "#e4e4e4" linewidth 0.6
set xtics nomirror out scale 1,0.5
set ytics nomirror out scale 1,0.5
set lmargin at screen 0.11
set rmargin at screen 0.97
set tmargin at screen 1 - 78.0/tall

load scripts.script
