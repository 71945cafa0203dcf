# SPDX-License-Identifier: Apache-2.0
# The page that every figure is drawn on: kind svg or png, to the file `picture`; `prefix` for the
# identifiers in an SVG; `tall` in points for a width of 960; a head and a subhead.
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
