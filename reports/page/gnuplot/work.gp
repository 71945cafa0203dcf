# SPDX-License-Identifier: Apache-2.0
# The common part of the diagrams of the work-precision tables.

# A colour for each family, with a contrast of at least 3 to white. The colours follow Okabe and Ito, whose orange and sky blue are paler.
colour(family) = family eq "tribocheck" ? 0xD55E00 : family eq "GSL" ? 0x0072B2 : \
  family eq "Boost" ? 0x009E73 : family eq "SciPy" ? 0xCC79A7 : family eq "table" ? 0xB07A00 : \
  family eq "textbook" || family eq "fixed rule" ? 0x7E57C2 : \
  family eq "closed form" ? 0x556B2F : family eq "plugin" ? 0x000000 : 0x777777
family_of(series) = series[1:strstrt(series, ":") - 1]
# In blocks of a table column 2 is the family and 3 the series.
ns = 5; evaluations = 6; max_ulp = 7; mean_ulp = 9; failures = 10
# Only the first blocks of a table are drawn.
most = 8
# A point shape for each series. Points of ours and of a plugin are larger; our lines are thicker.
shape(i) = word("7 5 9 11 13 4 6 8 10 12 1 2 3", i % 13 + 1) + 0
is_ours(family) = family eq "tribocheck"
size(family) = (is_ours(family) || family eq "plugin" ? 1.5 : 0.8)*point

# The error is that of the cases with a number. A cross says that some cases gave no number, or one that is far off.
failing(y) = column(failures) > 0 ? column(y) : NaN
failing_title = "failures in some cases"
set style line 10 pointtype 2 pointsize 1.6*point linewidth 1.4 linecolor rgb 0x000000

# Thirty rows fit into the height of the plot. More would begin a second column, beyond the edge.
legend = kind eq "svg" ? ",12" : ",9"
row = kind eq "svg" ? 0.88 : 1.05
y_shift = kind eq "svg" ? 0.8 : 0
set rmargin at screen 0.60
set bmargin at screen 70.0/tall
set key at screen 0.62, screen 1 - 74.0/tall left top vertical maxrows 40 Left reverse \
  samplen 2 spacing row font legend noenhanced
