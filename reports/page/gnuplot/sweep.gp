# SPDX-License-Identifier: Apache-2.0
# The common part of a sweep's pictures. All that they show, colours too, stands in the blocks of DATA/NAME.blocks.tsv.
# Texts in its rows are names that the user chose. They are drawn with noenhanced, so that no sign is a command.
data = data.prefix.".blocks.tsv"

tiny = kind eq "svg" ? ",12" : ",9"
bold = kind eq "svg" ? ",17" : ":Bold,11"  # an SVG of gnuplot has no bold font without enhanced text
grey = 0x666666
set style fill solid 1 noborder
set key noenhanced

# log_ticks() returns commands for eval that set the ticks of a logarithmic axis from `low` to `high`. An axis of many decades has
# ticks at powers of ten, a shorter one also at 2 and 5 of each decade, and one of about a decade also at 3, 4 and 7. If
# high ≤ 3 low, the ticks are round numbers with even steps. No tick has a label if has_labels is 0. `room` is the length of
# the axis as a part of the picture's width.
has_labels = 1
room = 1
tick_text(value) = value > 0.9e-4 && value < 1.1e4 ? sprintf("%g", value) : \
  gprintf(value/10.0**floor(log10(value) + 1e-9) > 1.5 ? "%.0t×10^{%T}" : "10^{%T}", value*(1 + 1e-12))
tick(axis, value, low, high) = value < low*(1 - 1e-9) || value > high*(1 + 1e-9) ? "" : \
  sprintf("set %stics add ('%s' %.9g); ", axis, has_labels ? tick_text(value) : "", value)
minor(axis, value, low, high) = value < low*(1 - 1e-9) || value > high*(1 + 1e-9) ? "" : \
  sprintf("set %stics add ('' %.9g 1); ", axis, value)
minors(axis, from, times, low, high) = times > 9 ? "" : \
  minor(axis, times*from, low, high).minors(axis, from, times + 1, low, high)
is_short(low, high) = log10(high/low) < 3.6*room
is_narrow(low, high) = log10(high/low) < 1.1*room
decade(axis, value, low, high) = minors(axis, value, 2, low, high).tick(axis, value, low, high). \
  (is_short(low, high) ? tick(axis, 2*value, low, high).tick(axis, 5*value, low, high) : ""). \
  (is_narrow(low, high) ? tick(axis, 3*value, low, high).tick(axis, 4*value, low, high). \
    tick(axis, 7*value, low, high) : "")
decades(axis, from, low, high) = from > high*(1 + 1e-9) ? "" : \
  decade(axis, from, low, high).decades(axis, 10*from, low, high)
nice(x) = (m = x/10.0**floor(log10(x)), x/m*(m < 1.5 ? 1 : m < 3.5 ? 2 : m < 7.5 ? 5 : 10))
even(axis, value, step, low, high) = value > high*(1 + 1e-9) ? "" : \
  tick(axis, value, low, high).even(axis, value + step, step, low, high)
log_ticks(axis, low, high) = sprintf("set logscale %s 10; set %stics (); ", axis, axis). \
  (high/low > 3 ? decades(axis, 10.0**floor(log10(low)), low, high) : \
   (step = nice((high - low)/(6*room)), even(axis, step*floor(low/step), step, low, high)))
