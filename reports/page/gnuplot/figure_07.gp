# SPDX-License-Identifier: Apache-2.0
# Figure 7: real area of contact against speed. Loaded by style.gp.
y = area
set ylabel "real area / nominal area, A_r/A_{nom} (–)" offset y_words
set yrange [0:*]
load scripts."area_or_summits.gp"
