// SPDX-License-Identifier: Apache-2.0
// The polynomials of the vector kernels of F_n, and where all polynomials of F_n end.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tribo/gaussian_moment.hpp"

namespace tribo {

// The polynomials are of |d| < pieces_end; and the last double below that.
inline constexpr double pieces_end = 45, below_pieces_end = 0x1.67fffffffffffp5;

// Row k of order n: coefficient k of its 16 pieces for d ≥ 0; vector_side_stride doubles on, for
// d < 0.
const double* vector_rows(Order n);
inline constexpr std::size_t vector_side_stride = std::size_t{21} * 16;

}  // namespace tribo
