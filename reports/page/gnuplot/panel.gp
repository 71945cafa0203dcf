# SPDX-License-Identifier: Apache-2.0
# The upper or the lower of two panels over one speed axis, called with "upper" or "lower". The title of the axis and the legend of
# both panels stand below the lower one.
if (ARG1 eq "upper") {
  set tmargin at screen 1 - 78.0/tall
  set bmargin at screen 0.56
  set format x ""
  set xtics add ("" speeds_max)
  unset xlabel
  unset key
} else {
  unset title
  set tmargin at screen 0.53
  set bmargin at screen 150.0/tall
  set format x "10^{%T}"
  set xtics add (sprintf("%g", speeds_max) speeds_max)
  set xlabel "entrainment speed u (m/s)" offset 0, x_words
  set key
}
