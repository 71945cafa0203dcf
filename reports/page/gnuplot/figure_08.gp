# SPDX-License-Identifier: Apache-2.0
# Figure 8: summits in contact against speed. Loaded by style.gp.
y = summits
set ylabel "summits in contact (–)" offset y_words
set logscale y 10
set format y "10^{%T}"
set autoscale yfix
set offsets 0, 0, graph 0.1, graph 0.1
load scripts."area_or_summits.gp"
