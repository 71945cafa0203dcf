# SPDX-License-Identifier: Apache-2.0
# How time and memory of the film solver grow with the cells of the grid: two panels over one axis, with the fitted
# exponents in the legends. Blocks, one for each solver: solver, cells, ns for the matrix of influences, ns for a step of
# Newton's method, bytes; and of the exponents: solver, quantity, exponent, uncertainty.
load scripts."work.gp"
# NAME is line_film_growth or point_film_growth. Their exponents stand in line_film_exponents or point_film_exponents.
table = data.prefix.".blocks.tsv"
exponents = data.(prefix[1:strstrt(prefix, "_growth")])."exponents.blocks.tsv"
stats table using 2 nooutput name "cells"
solvers = cells_blocks
array exponent[3*solvers]
array solver[solvers]
do for [s=0:solvers-1] {
  do for [q=0:2] {
    stats exponents index s using (strcol(2) eq word("kernel_ns step_ns bytes", q + 1) ? \
      (solver[s + 1] = strcol(1), power = $3, spread = $4, 0) : NaN) nooutput
    exponent[3*s + q + 1] = sprintf("N^%.2f ± %.1g", power, spread)
  }
}
tint(s) = colour(family_of(solver[s + 1]))
set logscale xy 10
set format y "10^{%T}"
set ytics 10
set mxtics 10
set xtics ("" 128, "" 256, "" 512, "" 1024, "" 2048, "" 4096, "" 8192, "" 16384, "" 32768, "" 65536)
set xrange [cells_min/1.15:cells_max*1.15]
top = 1 - 78.0/tall; bottom = 76.0/tall; gap = 26.0/tall
panel = (top - bottom - gap)/2
set multiplot
set tmargin at screen top
set bmargin at screen top - panel
set ylabel "CPU time (s)" offset y_shift, 0
plot for [s=0:solvers-1] table index s using 2:($4*1e-9) with linespoints pointtype 7 pointsize point \
    linewidth 2.2 linecolor rgb tint(s) title solver[s + 1]." step: ".exponent[3*s + 2], \
  for [s=0:solvers-1] table index s using 2:($3*1e-9) with linespoints pointtype 4 pointsize point \
    linewidth 1.4 dashtype (8,5) linecolor rgb tint(s) title solver[s + 1]." matrix: ".exponent[3*s + 1]
unset title
set tmargin at screen bottom + panel
set bmargin at screen bottom
set key at screen 0.62, screen bottom + panel
set xtics ("128" 128, "256" 256, "512" 512, "1024" 1024, "2048" 2048, "4096" 4096, "8192" 8192, "16384" 16384, "32768" 32768, "65536" 65536) font legend
set xlabel "cells N of the grid" offset 0, x_words
set ylabel "memory (MB)" offset y_shift, 0
plot for [s=0:solvers-1] table index s using 2:($5*1e-6) with linespoints pointtype 7 pointsize point \
    linewidth 2.2 linecolor rgb tint(s) title solver[s + 1].": ".exponent[3*s + 3]
unset multiplot
