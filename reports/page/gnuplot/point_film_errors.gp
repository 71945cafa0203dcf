# SPDX-License-Identifier: Apache-2.0
# Errors of the formulas for the film of a circle over the numbers of load and of material, in two liquids: panels of
# cells with one scale of colours.
table = data."point_film_errors.blocks.tsv"
array title_of[9] = ["Hamrock, Dowson: central", "Nijenbanning et al.: x = EI/RI, 3/2 (default)", \
  "Chittenden et al.: central, 4.31", "Nijenbanning et al.: x = EI/RI, 3s/2", \
  "Chittenden et al.: central, 4.30", "Nijenbanning et al.: x = EI/EP, 3/2", \
  "Hamrock, Dowson: minimum", "Nijenbanning et al.: x = EI/EP, 3s/2", "Chittenden et al.: minimum, 3.68"]
# The blocks have the order of the formulas in `tribocheck film`.
array block_of[9] = [0, 2, 3, 6, 4, 7, 1, 8, 5]

# As in line_film_errors.gp: colours by the logarithm of the error.
shade(error) = sgn(error)*log(1 + abs(error)/2)
set palette defined (-1 "#4f86c6", -0.55 "#8db5e0", -0.2 "#cfe0f2", 0 "#ffffff", 0.2 "#fdeacb", 0.55 "#f9cf8a", 1 "#f0a030")
set cbrange [shade(-120):shade(120)]
# Cells meet halfway between M = 1, 2 and 5 of each decade. Rows count from below; the second liquid stands above a gap.
materials = "2.5 5 10 15"
row_of(material) = sum [k=1:words(materials)] k*(abs(word(materials, k) - material) < 1e-6)
up(liquid, material) = row_of(material) + (liquid eq "Roelands" ? 3.4 : 0)
digit(load) = load/10**floor(log10(load) + 1e-9)
left(load) = load*(digit(load) > 4 ? 0.641 : 0.715); right(load) = load*(digit(load) > 1.5 && digit(load) < 4 ? 1.56 : 1.4)
words_of(error) = abs(error) < 0.5 ? "0" : (error < 0 ? "−" : "+").sprintf("%.0f", abs(error))
shown(error) = abs(error) <= 10 ? "{/:Bold ".words_of(error)."}" : words_of(error)
tick_words = kind eq "svg" ? ",14" : ",10.5"
cell_words = kind eq "svg" ? ",14" : ",10"

set style fill solid noborder
unset key
unset colorbox
set border 0 linewidth 1
unset grid
set logscale x 10
set xrange [3.1:3200]
set yrange [0.4:6.95]
top = 1 - 112.0/tall; bottom = 84.0/tall; gap = 66.0/tall
panel = (top - bottom - 4*gap)/5
unset title
set multiplot
set label 1 head."\n{/*0.8 ".subhead."}" at screen 0.5, screen 1 - 24.0/tall center
set label 2 "liquid, and material number L (–)" at screen 0.02, screen 0.5 center rotate by 90
do for [i=1:9] {
  row = (i - 1)/2; place = (i - 1) % 2
  set lmargin at screen 0.15 + 0.435*place
  set rmargin at screen 0.56 + 0.435*place
  set tmargin at screen top - row*(panel + gap)
  set bmargin at screen top - row*(panel + gap) - panel
  set title title_of[i] offset 0, (kind eq "svg" ? -1.1 : -0.9)
  set xtics ("5" 5, "10" 10, "20" 20, "50" 50, "100" 100, "200" 200, "500" 500, "1000" 1000, "2000" 2000) nomirror out scale 0.5,0 \
    offset 0, (kind eq "svg" ? 0.4 : 0.3) font tick_words
  if (place == 0) {
    set ytics nomirror out scale 0.5,0 ("Barus 2.5" 1, "Barus 5" 2, "Barus 10" 3, "Barus 15" 4, "Roelands 5" 5.4, "Roelands 10" 6.4) font tick_words
  } else {
    unset ytics
  }
  unset xlabel
  if (i > 7) { set xlabel "load number M (–)" offset 0, x_words }
  if (i == 9) {
    set colorbox horizontal user origin screen 0.60, screen 196.0/tall size screen 0.36, screen 18.0/tall
    set cbtics () scale 0.5
    do for [one in "-100 -30 -10 -3 0 3 10 30 100"] {
      set cbtics add ((real(one) > 0 ? "+" : real(one) < 0 ? "−" : "").sprintf("%g", abs(real(one))) shade(real(one)))
    }
    set cblabel "error of the formula's film (%)" offset 0, (kind eq "svg" ? 0.6 : 0)
  }
  plot table index block_of[i] using 1:(up(strcol(3), $2)):(left($1)):(right($1)):(up(strcol(3), $2) - 0.47): \
      (up(strcol(3), $2) + 0.47):(shade($4)) with boxxyerror fillcolor palette notitle, \
    table index block_of[i] using (sqrt(left($1)*right($1))):(up(strcol(3), $2)):(shown($4)) with labels font cell_words notitle
  unset label 1
  unset label 2
}
unset multiplot
