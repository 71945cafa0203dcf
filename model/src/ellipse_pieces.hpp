// SPDX-License-Identifier: Apache-2.0
// The polynomials of Hertz' ellipse and how they are summed, for src/hertz_ellipse.cpp and for the
// proof of their error (verification/tests/analytic/ellipse_pieces_test.cpp).
#pragma once

#include <cstddef>

namespace tribo::ellipse_pieces {

#include "ellipse_pieces.inc"

using Piece = double[degree + 2];

// The three polynomials of axis_cube, axes_ratio and approach, in u = R_high/R_low/2^octave −
// centre_of(part).
inline const Piece* of(bool is_exchanged, int octave, int part) {
  return pieces +
         static_cast<std::ptrdiff_t>(3 * (((is_exchanged ? octaves : 0) + octave) * parts + part));
}
constexpr double centre_of(int part) { return 1 + (2 * part + 1) / (2.0 * parts); }

// A piece's polynomial at u without piece[0], to which it is added last. The even and the odd
// powers of what multiplies u are two chains.
template <class T>
T beyond_first(const Piece& piece, const T& u) {
  static_assert(degree % 2 == 1);
  const T square = u * u;
  T even = piece[degree - 1] + square * piece[degree + 1];
  T odd = piece[degree - 2] + square * piece[degree];
  for (int k = degree - 3; k > 2; k -= 2) {
    even = piece[k] + square * even;
    odd = piece[k - 1] + square * odd;
  }
  return piece[1] + u * (piece[2] + square * even + u * odd);
}

}  // namespace tribo::ellipse_pieces
