// SPDX-License-Identifier: Apache-2.0
// A smooth positive function of one variable as polynomials in pieces, built from its values.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace tribo {

// f(x) for x in [from, to], 0 < from < to. Each binade of x is halved until the interpolant of
// degree 10 through f's Chebyshev nodes there agrees with f to `tolerance`, relative, at 12 points
// between them and at the ends. A piece that does not after 8 halvings (a kink, or f's own noise)
// is left out: there, and outside the range, value() is NaN. No pieces, unless 0 < from ≤ to.
class ProxyPieces {
 public:
  // Fills the second span with f of the first.
  using Function = std::function<void(std::span<const double>, std::span<double>)>;

  ProxyPieces() = default;
  ProxyPieces(const Function& function, double from, double to, double tolerance);

  double value(double x) const {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t cell = (bits >> kept_bits) - first_cell_;
    if (cell >= piece_of_cell_.size()) return std::numeric_limits<double>::quiet_NaN();
    return value_in(pieces_[piece_of_cell_[cell]], x);
  }
  // Of many; false if any is NaN. With fused multiply-add where the processor has it.
  bool values(std::span<const double> x, std::span<double> result) const;

  std::size_t piece_count() const { return pieces_.empty() ? 0 : pieces_.size() - 1; }
  // Evaluations of f that building took.
  std::size_t evaluations() const { return evaluations_; }
  // Part of the cells (each 1/256 of a binade) that are left out.
  double left_out() const;

 private:
  static constexpr int halvings = 8;
  static constexpr int kept_bits = 52 - halvings;
  static constexpr int degree = 10;
  struct Piece {
    double centre;
    double coefficients[degree + 1];  // in t = x − centre
  };
  // Cells [first, first + count) of the table.
  struct Interval {
    std::size_t first, count;
    double low, high;
  };

  struct Plain {
    static double multiply_add(double a, double b, double c) { return a * b + c; }
  };
  // Inlined even into what is compiled for other processors.
  template <class Arithmetic = Plain>
  [[gnu::always_inline]] static double value_in(const Piece& piece, double x) {
    const double* c = piece.coefficients;
    const double t = x - piece.centre, square = t * t;
    double even = c[10], odd = c[9];
    for (int k = 8; k >= 2; k -= 2) {
      even = Arithmetic::multiply_add(even, square, c[k]);
      if (k > 2) odd = Arithmetic::multiply_add(odd, square, c[k - 1]);
    }
    const double slope = Arithmetic::multiply_add(Arithmetic::multiply_add(odd, t, even), t, c[1]);
    return Arithmetic::multiply_add(slope, t, c[0]);
  }
  template <class Arithmetic>
  bool fill(std::span<const double> x, std::span<double> result) const;
  bool fill_fused(std::span<const double> x, std::span<double> result) const;
  static Piece fit(const Interval& interval, const double* sampled);
  static bool holds(const Piece& piece, const double* places, const double* sampled,
                    double tolerance);
  void sample(const Function& function, const std::vector<Interval>& intervals,
              std::vector<double>& places, std::vector<double>& values);

  std::uint64_t first_cell_ = 0;
  std::vector<std::uint32_t> piece_of_cell_;  // 0: left out
  std::vector<Piece> pieces_;                 // the first is NaN
  std::size_t evaluations_ = 0;
};

}  // namespace tribo
