// SPDX-License-Identifier: Apache-2.0
// What the scalar kernels in double share: the polynomials of F_n in pieces, and arithmetic with
// and without fused multiply-add. A kernel's text is compiled for both and chosen at run time.
#pragma once

#include <bit>
#include <cstdint>

#include "gaussian_moment_rows.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::scalar {

#include "gaussian_moment_pieces.inc"

// A number as the unrounded sum of two doubles.
struct Sum {
  double high, low;
};

struct Fused {
  [[gnu::always_inline]] static double multiply_add(double a, double b, double c) {
    return __builtin_fma(a, b, c);
  }
  [[gnu::always_inline]] static Sum product(double a, double b) {
    const double high = a * b;
    return {high, __builtin_fma(a, b, -high)};
  }
  // a·b + c, |c| far below |a·b|, rounded once or nearly so.
  [[gnu::always_inline]] static double product_and_sum(double a, double b, double c) {
    return __builtin_fma(a, b, c);
  }
};

struct Unfused {
  [[gnu::always_inline]] static double multiply_add(double a, double b, double c) {
    return a * b + c;
  }
  // Dekker's product; |a|, |b| < 2^995.
  [[gnu::always_inline]] static Sum product(double a, double b) {
    const double high = a * b;
    const Sum x = halves(a), y = halves(b);
    return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
  }
  [[gnu::always_inline]] static double product_and_sum(double a, double b, double c) {
    const Sum exact = product(a, b);
    return exact.high + (exact.low + c);
  }

 private:
  [[gnu::always_inline]] static Sum halves(double a) {
    const double scaled = 134217729 * a;
    const double high = scaled - (scaled - a);
    return {high, a - high};
  }
};

// a + b for |a| ≥ |b|.
[[gnu::always_inline]] inline Sum ordered_sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

// A polynomial of S_n at |d| = x < pieces_end for d ≥ 0, of F_n for d < 0: its coefficients c0
// high, c0 low, c1, c2, …, and the distance t of x from its centre.
struct Piece {
  const double* coefficients;
  double t;
};
[[gnu::always_inline]] inline Piece piece_at(Order n, bool below_zero, double x) {
  constexpr int kept = 48;  // bits below those that number the pieces of x + 3
  const auto bits = std::bit_cast<std::uint64_t>(x + 3.0);
  constexpr auto first = std::bit_cast<std::uint64_t>(3.0) >> kept;
  const double centre =
      std::bit_cast<double>((bits >> kept << kept) | (std::uint64_t{1} << (kept - 1))) - 3.0;
  return {pieces[twice(n)][below_zero ? 1 : 0][(bits >> kept) - first], x - centre};
}

// Σ c_k t^k from k = 1 on over t, by even and odd powers.
template <class Arithmetic>
[[gnu::always_inline]] inline double slope_polynomial(const double* c, double t) {
  const double square = t * t;
  double odd = c[11], even = c[10];  // of c_12 and c_11
  for (int k = 9; k >= 1; k -= 2) {
    odd = Arithmetic::multiply_add(odd, square, c[k]);
    even = Arithmetic::multiply_add(even, square, c[k - 1]);
  }
  return Arithmetic::multiply_add(odd, t, even);
}

// S_n at |d| = x < pieces_end for d ≥ 0, F_n for d < 0. The low part is at most an eighth of the
// high one, and its rounding is what the sum is off by.
template <class Arithmetic>
[[gnu::always_inline]] inline Sum in_pieces(Order n, bool below_zero, double x) {
  const auto [c, t] = piece_at(n, below_zero, x);
  return {c[0], Arithmetic::multiply_add(t, slope_polynomial<Arithmetic>(c + 2, t), c[1])};
}

}  // namespace tribo::scalar
