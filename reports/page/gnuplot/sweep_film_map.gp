# SPDX-License-Identifier: Apache-2.0
# The film over speed and a field, or over two fields, as colours with contour lines.
# Blocks: 0 the axes; 1 speed or field, field, film (nm), with a blank line after each value of the second; 2 for each value
# of the field the speed of its greatest film, if that lies between the ends; 3, only if some of the map is a floor: for
# each value of the field the speed up to which the film is at the floor.
load scripts."sweep.gp"
stats data index 0 using (low = column(1), high = column(2), bottom = column(3), top = column(4), \
  is_log = column(5), least = column(6), most = column(7), label = strcol(8), \
  label_across = strcol(9), is_log_across = column(10), film = strcol(11), label_every = column(12), \
  interpolated = column(13), 0) nooutput
stats data nooutput name "all"
set lmargin at screen 0.13
set rmargin at screen 0.84
set border 15 linewidth 0.8
unset grid

# The levels of the contour lines are the ticks of the colour bar. They are closer where the range of films is small.
levels = ""; ticks = ""
steps = most/least > 1500 ? "1" : most/least > 8 ? "1 2 5" : "1 1.5 2 2.5 3 4 5 6 7 8 9"
do for [e = int(floor(log10(least))):int(ceil(log10(most)))] {
  do for [m in steps] {
    at = m*10.0**e
    if (at > least && at < most) {
      levels = levels.(levels eq "" ? "" : ", ").sprintf("%.9g", at)
      ticks = ticks.sprintf("%.9g ", at)
    }
  }
}
set table $contours
set contour base
unset surface
if (levels ne "") { eval "set cntrparam levels discrete ".levels }
splot data index 1 using 1:2:3
unset table
unset contour
set surface
set datafile separator whitespace  # as gnuplot writes its tables; only numbers follow

set logscale cb 10
set cbtics ()
do for [one in ticks] {
  set cbtics add (tick_text(real(one)) real(one))
}
set xrange [low:high]
set yrange [bottom:top]
set cbrange [least:most]
if (int(is_log_across)) { eval log_ticks("x", low, high) }
if (int(is_log)) { eval log_ticks("y", bottom, top) }
set xlabel label_across offset 0, x_words noenhanced
set ylabel label offset y_words - 2 noenhanced
set cblabel film offset 1 noenhanced
set bmargin at screen 84.0/tall
set colorbox user origin screen 0.86, screen 84.0/tall size screen 0.025, screen 1 - 162.0/tall
# Cividis: from blue to yellow, even in lightness, for every eye.
set palette defined (0 "#00224e", 0.125 "#123570", 0.25 "#3b496c", 0.375 "#575d6d", 0.5 "#707173", \
  0.625 "#8a8678", 0.75 "#a59c74", 0.875 "#c3b369", 1 "#fee838")
set pm3d corners2color geomean border retrace interpolate int(interpolated),int(interpolated)
set title offset 0, 0.7
set view map
set style textbox opaque noborder margins 0.6, 0.6 fillcolor rgb "#ffffff"
unset key
# A contour line has a label at one of `every` points. turn() moves it from each level to the next.
every = int(label_every)
turn(level) = every/3*(int(floor(3*log10(level) + 0.5)) % 3)
labelled(level) = (int(column(0)) + turn(level)) % every == 5*every/12 ? 1 : NaN
splot \
  data index 1 using 1:2:3 with pm3d, \
  $contours using 1:2:(most) with lines linewidth 1 linecolor rgb "#ffffff", \
  data index 2 using 1:2:(most) with lines linewidth 2.4 linecolor rgb "#D55E00", \
  for [i = 3:all_blocks - 1] data index i using 1:2:(most) with lines linewidth 2.4 linecolor rgb "#000000", \
  $contours using (labelled(column(3))*column(1)):2:(most):(tick_text(column(3))) with labels boxed font tiny
