# SPDX-License-Identifier: Apache-2.0
# The lower of two panels over one speed axis: with its words, and the legend for both.
unset title
set tmargin at screen 0.53
set bmargin at screen 150.0/tall
set format x "10^{%T}"
set xtics add (sprintf("%g", speeds_max) speeds_max)
set xlabel "entrainment speed u (m/s)" offset 0, x_words
set key
