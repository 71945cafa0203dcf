# SPDX-License-Identifier: Apache-2.0
# The upper of two panels over one speed axis: without that axis's words, and without the legend.
set tmargin at screen 1 - 78.0/tall
set bmargin at screen 0.56
set format x ""
set xtics add ("" speeds_max)
unset xlabel
unset key
