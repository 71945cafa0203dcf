// SPDX-License-Identifier: Apache-2.0
// The table of polynomials of F_n in double, and what lies beyond it.
#pragma once

#include <cstddef>

#include "tribo/gaussian_moment.hpp"

namespace tribo {

#include "gaussian_moment_pieces.inc"

// The polynomials are for |d| < pieces_end; below_pieces_end is the last double below it.
inline constexpr double pieces_end = 45, below_pieces_end = 0x1.67fffffffffffp5;
inline constexpr std::size_t pieces_a_side = std::size(pieces[0][0]);
inline constexpr std::size_t piece_numbers = std::size(pieces[0][0][0]);
inline constexpr int powers_a_binade = std::size(powers_of_two);

// S_n(d) for |d| ≥ pieces_end, which is F_n(d) below zero; NaN gives NaN.
double moment_beyond_pieces(Order n, double d);

}  // namespace tribo
