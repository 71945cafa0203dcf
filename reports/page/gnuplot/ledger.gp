# SPDX-License-Identifier: Apache-2.0
# The common part of the figures of the ledger.

# Columns of data/ledger_surfaces.tsv.
surfaces = data."ledger_surfaces.tsv"
sd = 2
set style line 9 linecolor rgb "#222222" pointtype 8 pointsize 1.7*outline linewidth 1.6
set style fill solid 1 noborder
wide = 0xDCE6EE; narrow = 0x9FBAD0; edge = 0x6A8FB0   # plausible inputs, print precision
set ytics nomirror out scale 1,0.5
set xtics nomirror out scale 1,0.5
set border 3 linewidth 0.8
set grid ytics linetype 1 linecolor rgb "#e4e4e4" linewidth 0.6
set lmargin at screen 0.11
set rmargin at screen 0.97
set tmargin at screen 1 - 78.0/tall
set bmargin at screen 150.0/tall
set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 3 Left reverse \
  samplen 3.5 spacing 1.25 font small
