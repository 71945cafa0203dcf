// SPDX-License-Identifier: Apache-2.0
// A proof that the polynomials of Hertz' ellipse (model/src/hertz_ellipse.cpp) are within 1 ulp at
// every ratio of the radii up to 2^octaves. No number of test points can show this.
//
// The numbers of an ellipse follow from the parameter m = 1 − 1/k² of its elliptic integrals. No
// root has to be found: with y = 1 − m, K = B + D and E = B + yD,
//
//   α = B/(yD),   (a_x/a)³ = 4B√y/π,  k = 1/√y,  approach K/(2B)   where R_y ≥ R_x = R_y/α,
//                 (a_x/a)³ = 4D/π,    k = √y,    approach K/(2D)   where R_y < R_x = αR_y,
//   2yd(B + D)/dm = B,   2my dD/dm = B − yD,   B = D = π/4 at m = 0.
//
// The Taylor coefficients of B and D are positive at m = 0, as those of 1/√(1 − m sin²) are. So
// they are positive at each m ≥ 0 and grow with m, and those at the ends of an interval enclose
// those at all its points. The difference between a polynomial and its function is a series in
// m − m₀ with such balls as coefficients. By Taylor's theorem its last coefficient, the remainder,
// is that of the whole interval.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "generators/ball.hpp"
#include "generators/ellipse_shape.hpp"
#include "support/case_count.hpp"
#include "tribo/hertz_ellipse.hpp"

namespace tribo::verification {
namespace {

#include "ellipse_pieces.inc"

using detail::beyond_first;
using reference::Ball;
using Piece = double[degree + 2];

const Piece* pieces_of(bool is_exchanged, int octave, int part) {
  return pieces +
         static_cast<std::ptrdiff_t>(3 * (((is_exchanged ? octaves : 0) + octave) * parts + part));
}

constexpr std::size_t terms = 10;  // the last is that of the remainder
constexpr int intervals = 32;      // of m in a piece

// A power series in m − m₀ without the powers beyond the last term.
struct Series {
  std::array<Ball, terms> of;

  Series(const Ball& constant = 0) { of[0] = constant; }  // NOLINT: converts like a number
  Series(double constant) { of[0] = constant; }           // NOLINT
  friend Series operator+(Series a, const Series& b) {
    for (std::size_t n = 0; n < terms; ++n) a.of[n] += b.of[n];
    return a;
  }
  friend Series operator-(Series a, const Series& b) {
    for (std::size_t n = 0; n < terms; ++n) a.of[n] -= b.of[n];
    return a;
  }
  friend Series operator*(const Series& a, const Series& b) {
    Series product;
    for (std::size_t n = 0; n < terms; ++n)
      for (std::size_t k = 0; k <= n; ++k)
        arb_addmul(product.of[n].get(), a.of[k].get(), b.of[n - k].get(),
                   reference::ball_precision);
    return product;
  }
  friend Series operator/(Series a, const Series& b) {
    for (std::size_t n = 0; n < terms; ++n) {
      for (std::size_t k = 0; k < n; ++k) a.of[n] -= a.of[k] * b.of[n - k];
      a.of[n] /= b.of[0];
    }
    return a;
  }
};

Series scaled(const Ball& factor, Series series) {
  for (Ball& one : series.of) one *= factor;
  return series;
}

// The series of √(1 − m) about m₀, which is the argument `m` and may be a ball.
Series root_of_complement(const Ball& m) {
  Series root;
  root.of[0] = sqrt(1 - m);
  for (std::size_t n = 1; n < terms; ++n) {
    const auto k = static_cast<int>(n);
    root.of[n] = root.of[n - 1] * (Ball(k - 1) - reference::fraction(1, 2)) / k / (1 - m);
  }
  return root;
}

// The series of B and D about m₀ = `m`, by their differential equations.
struct Integrals {
  Series b, d;
};
Integrals integrals(const Ball& m) {
  const Ball y = 1 - m;
  const bool is_start = m == 0;
  const reference::Associated first = reference::associated(1 / sqrt(y));
  Integrals all{{first.b}, {first.d}};
  auto& b = all.b.of;
  auto& d = all.d.of;
  for (std::size_t n = 0; n + 1 < terms; ++n) {
    const auto k = static_cast<int>(n);
    const Ball before = n > 0 ? d[n - 1] : Ball(0);
    const Ball sum = (b[n] / 2 + k * (b[n] + d[n])) / (y * (k + 1));
    d[n + 1] = is_start ? (sum + (2 * k + 1) * d[n]) / (2 * k + 4)
                        : ((b[n] - y * d[n] + before) / 2 - (y - m) * k * d[n] + (k - 1) * before) /
                              (m * y * (k + 1));
    b[n + 1] = sum - d[n + 1];
  }
  return all;
}
Ball hull(const Ball& a, const Ball& b) {
  Ball all;
  arb_union(all.get(), a.get(), b.get(), reference::ball_precision);
  return all;
}
Integrals hull(const Integrals& low, const Integrals& high) {
  Integrals all;
  for (std::size_t n = 0; n < terms; ++n) {
    all.b.of[n] = hull(low.b.of[n], high.b.of[n]);
    all.d.of[n] = hull(low.d.of[n], high.d.of[n]);
  }
  return all;
}

// R_high/R_low, and axis_cube, axes_ratio and approach of both orders of the radii.
struct Ellipses {
  Series ratio;
  std::array<std::array<Series, 3>, 2> numbers;
};
Ellipses ellipses(const Integrals& at, const Ball& m) {
  const Series root = root_of_complement(m), complement = root * root;
  const Series both = scaled(reference::fraction(1, 2), at.b + at.d);
  const Ball scale = 4 / reference::ball_pi();
  return {at.b / (complement * at.d),
          {{{scaled(scale, at.b * root), Series(1) / root, both / at.b},
            {scaled(scale, at.d), root, both / at.d}}}};
}

// A number of the computation in double: it is at most `magnitude`, and off by at most `error`.
struct Rounded {
  double magnitude, error;

  Rounded(double constant) : magnitude(std::abs(constant)), error(0) {}  // NOLINT
  Rounded(double largest, double off) : magnitude(largest), error(off) {}
  friend Rounded operator+(const Rounded& a, const Rounded& b) {
    return after_rounding(a.magnitude + b.magnitude, a.error + b.error);
  }
  friend Rounded operator*(const Rounded& a, const Rounded& b) {
    return after_rounding(a.magnitude * b.magnitude,
                          a.error * (b.magnitude + b.error) + b.error * a.magnitude);
  }

 private:
  // Half the last place of the greatest result; the factor covers the roundings of these bounds.
  static Rounded after_rounding(double exact, double error) {
    const double greatest = std::max((exact + error) * (1 + 0x1p-50), 0x1p-900);
    return {greatest, error * (1 + 0x1p-40) + std::ldexp(1, std::ilogb(greatest) - 53)};
  }
};

// The error that a piece's number may have, in ulp. The last sum is rounded to the nearest double,
// which is half an ulp; where the sum alone is in another binade than the number, this rounding
// leads at most to the power of two between both.
double error_bound(const Piece& piece, int octave, int part, std::size_t number, bool is_exchanged,
                   const Ball& radius, const Ellipses& middle, const Ellipses& all) {
  const auto difference = [&](const Ellipses& at, Ball* u_at, Ball* value) {
    const Series u =
        scaled(Ball(std::ldexp(1, -octave)), at.ratio) - Series(1 + (2 * part + 1) / (2.0 * parts));
    const Series& right = at.numbers[is_exchanged ? 1 : 0][number];
    if (u_at != nullptr) *u_at = u.of[0], *value = right.of[0];
    return Series(piece[0]) + beyond_first(piece, u) - right;
  };
  Ball u, value;
  const Series here = difference(middle, nullptr, nullptr), there = difference(all, &u, &value);
  Ball sum, power = 1;
  for (std::size_t n = 0; n < terms; ++n) {
    sum += abs(n + 1 < terms ? here.of[n] : there.of[n]) * power;
    power *= radius;
  }
  const double argument = abs(u).upper_bound();
  // u is a rounded sum. The remainder of the division in it has an error below 2^−104.
  const Rounded computed = beyond_first(piece, Rounded(argument, 0x1p-53 * argument + 0x1p-104));
  const double least = -(-abs(value)).upper_bound();
  const double ulp = std::ldexp(1, std::ilogb(least) - 52);
  return 0.5 + (sum.upper_bound() + computed.error) / ulp;
}

// The greatest error bound of each number over a whole piece, for R_y ≥ R_x and then for R_y < R_x.
// `spoil` may change the coefficients.
template <class Spoil>
std::array<std::array<double, 3>, 2> greatest_bounds(int octave, int part, Spoil&& spoil) {
  const double low = std::ldexp(1 + part / double{parts}, octave);
  const double high = std::ldexp(1 + (part + 1) / double{parts}, octave);
  // A ratio that is rounded to the end of a piece may be beyond it by an ulp.
  const auto parameter = [](const Ball& ratio) {
    const Ball k = reference::shape_by_newton(ratio).k;
    return (1 - 1 / (k * k)).midpoint();
  };
  const Ball first = low == 1 ? Ball(0) : parameter(Ball(low) * (1 - Ball(0x1p-50)));
  const Ball last = parameter(Ball(high) * (1 + Ball(0x1p-50)));
  std::array<std::array<double, 3>, 2> greatest{};
  Integrals before = integrals(first);
  EXPECT_TRUE(low == 1 || ellipses(before, first).ratio.of[0] <= low);
  Ball from = first;
  for (int i = 1; i <= intervals; ++i) {
    const Ball to = i == intervals
                        ? last
                        : (first + (last - first) * reference::fraction(i, intervals)).midpoint();
    const Ball centre = ((from + to) / 2).midpoint(), radius = hull(to - centre, centre - from);
    const Integrals after = integrals(to);
    const Ellipses middle = ellipses(integrals(centre), centre);
    const Ellipses all = ellipses(hull(before, after), hull(from, to));
    for (const bool is_exchanged : {false, true})
      for (std::size_t number = 0; number < 3; ++number) {
        Piece piece;
        std::copy_n(pieces_of(is_exchanged, octave, part)[number], degree + 2, piece);
        spoil(piece);
        double& most = greatest[is_exchanged ? 1 : 0][number];
        most = std::max(
            most, error_bound(piece, octave, part, number, is_exchanged, radius, middle, all));
      }
    from = to;
    before = after;
  }
  EXPECT_TRUE(ellipses(before, last).ratio.of[0] >= high);
  return greatest;
}

TEST(EllipsePieces, AreWithinAnUlpAtEachRatioOfTheRadii) {
  double most = 0;
  for (int octave = 0; octave < octaves; ++octave)
    for (int part = 0; part < parts; ++part) {
      const auto bounds = greatest_bounds(octave, part, [](Piece&) {});
      for (const auto& order : bounds)
        for (const double bound : order) {
          EXPECT_LT(bound, 1) << "octave " << octave << ", part " << part;
          record_part_of_bound(bound);
          most = std::max(most, bound);
        }
    }
  // The proven bound is close to the greatest error seen at random ratios, 0.72 ulp.
  EXPECT_GT(most, 0.7);
}

TEST(EllipsePieces, WithoutTheirLastPowerAreNotWithinAnUlp) {
  for (const auto& order : greatest_bounds(0, 0, [](Piece& piece) { piece[degree + 1] = 0; }))
    for (const double bound : order) EXPECT_GT(bound, 1);
}

}  // namespace
}  // namespace tribo::verification
