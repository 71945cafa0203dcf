// SPDX-License-Identifier: Apache-2.0
// The film laws in whole numbers, for ball arithmetic.
#pragma once

#include <cstdint>

namespace tribo::reference {

// h/R = C U^a G^b W^c (1 − m e^{−nk}), in whole numbers: C is `constant`/1000, the exponents are
// a/q, b/q and c/q, and m and n are in hundredths.
struct Law {
  const char *name, *definition, *id;
  bool is_of_lines;
  int constant, q, a, b, c, m, n;
  std::uint64_t seed;
  int rows;
};
// The laws that scenes can name come first, in the order of film_formula_words
// (tribo/film_laws.hpp).
inline constexpr Law laws[] = {
    {"hamrock_dowson_central", "h0 = 2.69 R U^0.67 G^0.53 W^-0.067 (1 - 0.61 exp(-0.73k))", "f",
     false, 2690, 1000, 670, 530, -67, 61, 73, 505, 120},
    {"hamrock_dowson_minimum", "hmin = 3.63 R U^0.68 G^0.49 W^-0.073 (1 - exp(-0.68k))", "fm",
     false, 3630, 1000, 680, 490, -73, 100, 68, 1505, 60},
    {"hamrock_dowson_soft_central", "h0 = 7.32 R U^0.64 W^-0.22 (1 - 0.72 exp(-0.28k))", "fs",
     false, 7320, 1000, 640, 0, -220, 72, 28, 1506, 60},
    {"hamrock_dowson_soft_minimum", "hmin = 7.43 R U^0.65 W^-0.21 (1 - 0.85 exp(-0.31k))", "ft",
     false, 7430, 1000, 650, 0, -210, 85, 31, 1507, 60},
    {"dowson_higginson_minimum", "hmin = 2.65 R U^0.7 G^0.54 W^-0.13", "fh", true, 2650, 1000, 700,
     540, -130, 0, 0, 1508, 60},
    {"dowson_toyoda_central", "h0 = 3.06 R U^0.69 G^0.56 W^-0.1", "fc", true, 3060, 1000, 690, 560,
     -100, 0, 0, 1509, 60},
    {"pan_hamrock_minimum", "hmin = 1.714 R U^0.694 G^0.568 W^-0.128", "fp", true, 1714, 1000, 694,
     568, -128, 0, 0, 1510, 60},
    {"pan_hamrock_central", "h0 = 2.922 R U^0.692 G^0.47 W^-0.166", "fq", true, 2922, 1000, 692,
     470, -166, 0, 0, 1511, 60},
    {"ertel_grubin", "h0 = 1.95 R (GU)^(8/11) W^(-1/11)", "fe", true, 1950, 11, 8, 8, -1, 0, 0,
     1512, 60}};

}  // namespace tribo::reference
