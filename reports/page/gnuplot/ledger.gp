# SPDX-License-Identifier: Apache-2.0
# The common part of the figures of the ledger.

# Columns of data/ledger_surfaces.tsv.
surfaces = data."ledger_surfaces.tsv"
sd = 2
set style line 9 linecolor rgb "#222222" pointtype 8 pointsize 1.7*outline linewidth 1.6
set style fill solid 1 noborder
wide = 0xDCE6EE; narrow = 0x9FBAD0; edge = 0x6A8FB0   # plausible inputs, print precision
set grid noxtics
set bmargin at screen 150.0/tall
set key at screen 0.54, screen 4.0/tall center bottom vertical maxrows 3 Left reverse \
  samplen 3.5 spacing 1.25 font small
