# SPDX-License-Identifier: Apache-2.0
# Outputs of scenes against speed: a panel for each output, all over one axis.
# Blocks: 0 the ends of the speed axis, and how many marks of each kind there are; 1 the axis of each panel; 2 the
# scenes; 3 the marks; from 4 on the curve of each scene. Curves and marks have a value for each panel. Kinds of marks:
# 1 the film maximum, 2 the last point before the film collapses, 3 a measured point on a curve, 4 another measured point.
load scripts."sweep.gp"
stats data index 0 using (low = column(1), high = column(2), onsets = column(3), ends = column(4), \
  measured = column(5), others = column(6), 0) nooutput
array labels[32]
array bottoms[32]
array tops[32]
array logs[32]
stats data index 1 using (i = int($0) + 1, labels[i] = strcol(1), bottoms[i] = column(2), tops[i] = column(3), \
  logs[i] = column(4), 0) nooutput name "panels"
array names[32]
array colours[32]
stats data index 2 using (i = int($0) + 1, names[i] = strcol(1), colours[i] = column(2), 0) nooutput name "scenes"
# Dashes, by which the curves differ in grey, too.
set style line 1 dashtype solid
set style line 2 dashtype (12,5)
set style line 3 dashtype (3,4)
set style line 4 dashtype (12,4,3,4)
set style line 5 dashtype (22,6)
set style line 6 dashtype (12,4,3,4,3,4)
set style line 7 pointtype 7 pointsize 1.2*point
set style line 8 pointtype 6 pointsize 1.5*outline linewidth 1.6
set style line 9 pointtype 5 pointsize 1.1*point linecolor rgb "#000000"
set style line 10 pointtype 4 pointsize 1.2*outline linewidth 1.6 linecolor rgb "#000000"

# The legend names only kinds of marks that occur: other entries would leave gaps.
legend = ""
if (onsets > 0) { legend = legend.', keyentry with points linestyle 7 linecolor rgb grey title "film maximum"' }
if (ends > 0) { legend = legend.', keyentry with points linestyle 8 linecolor rgb grey title "last point before the collapse"' }
if (measured > 0) { legend = legend.', keyentry with points linestyle 9 title "measured"' }
if (others > 0) { legend = legend.', keyentry with points linestyle 10 title "measured: outside, other or without a film"' }

foot = 150.0/tall
gap = 22.0/tall
panel = (1 - 78.0/tall - foot + gap)/panels_records
set lmargin at screen 0.12
set xrange [low:high]
has_labels = 0
eval log_ticks("x", low, high)
has_labels = 1
set key off
mark(kind, p) = column(1) == kind ? column(p + 3) : NaN
set multiplot
do for [p = 1:panels_records] {
  set tmargin at screen 1 - 78.0/tall - (p - 1)*panel
  set bmargin at screen 1 - 78.0/tall - p*panel + gap
  if (p > 1) { unset title }
  unset logscale y
  set ytics autofreq
  if (int(logs[p])) { eval log_ticks("y", bottoms[p], tops[p]) }
  set yrange [bottoms[p]:tops[p]]
  set ylabel labels[p] offset y_words
  if (p == panels_records) {
    eval log_ticks("x", low, high)
    set xlabel "entrainment speed u (m/s)" offset 0, x_words
    set key on
    set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 3 Left reverse samplen 3.5 spacing 1.25 font small
  }
  plot \
    for [s = 1:scenes_records] data index s + 3 using 1:(column(p + 1)) with lines linestyle s linewidth 2.2 \
      linecolor rgb colours[s] title names[s], \
    data index 3 using 2:(mark(1, p)):3 with points linestyle 7 linecolor rgb variable notitle, \
    data index 3 using 2:(mark(2, p)):3 with points linestyle 8 linecolor rgb variable notitle, \
    data index 3 using 2:(mark(4, p)) with points linestyle 10 notitle, \
    data index 3 using 2:(mark(3, p)) with points linestyle 9 notitle @legend
}
unset multiplot
