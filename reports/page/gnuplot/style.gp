# SPDX-License-Identifier: Apache-2.0
# The common part of the paper's figures.

# Orange, green and blue after Okabe and Ito, one for each surface in every figure. Each is half as bright as the one
# before, so that they differ in grey, too.
colour(surface) = surface eq "rough" ? 0xD86400 : surface eq "medium" ? 0x006B50 : 0x003468
grey = 0x666666
surfaces = "rough medium smooth"
set style line 2 linewidth 2.2 dashtype (12,6)     # Greenwood-Williamson
set style line 3 linewidth 1.6 dashtype (2,4)      # as printed, past the collapse
set style line 4 linewidth 2.2 dashtype (10,4,2,4) # the fluid

# marks.tsv has three columns before those of a curve.
curve(stem) = data."curve_".stem.".tsv"
gt(surface) = curve(surface)
gw(surface) = curve(surface."_gw")
marks = data."marks.tsv"
standing(y) = strcol(inlet) eq "collapsed" ? NaN : column(y)
is_mark(event, surface, model) = \
  strcol(1) eq event && strcol(2) eq surface && strcol(3) eq model
mark(event, surface, model, y) = is_mark(event, surface, model) ? column(y + 3) : NaN
slowest(y) = strcol(1) eq "slowest" ? column(y + 3) : NaN
# Points: a full circle at the onset, an open one at the collapse, where a curve ends, and an open
# triangle at the onset speed that the paper reports.
set style line 8 pointtype 6 pointsize 1.5*outline linewidth 1.6
set style line 9 pointtype 8 pointsize 1.7*outline linewidth 1.4

stats gt("rough") using 1 nooutput name "speeds"
load scripts."stribeck.gp"
