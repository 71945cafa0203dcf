// SPDX-License-Identifier: Apache-2.0
#include "tribo/hertz_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribo {
namespace {

#include "ellipse_pieces.inc"

// A piece's polynomial at u. The even and the odd powers of what multiplies u are two chains.
double value_of(const double (&piece)[degree + 2], double u) {
  static_assert(degree % 2 == 1);
  const double square = u * u;
  double even = piece[degree + 1], odd = piece[degree];
  for (int k = degree - 1; k > 2; k -= 2) {
    even = even * square + piece[k];
    odd = odd * square + piece[k - 1];
  }
  return piece[0] + (piece[1] + u * (even * square + piece[2] + u * odd));
}

}  // namespace

template <>
EllipseOfCircle<double> ellipse_of_circle(const double& radius_x, const double& radius_y) {
  const double low = std::min(radius_x, radius_y), high = std::max(radius_x, radius_y);
  const double ratio = high / low;
  // Below this radius the remainder of the division may be no number of full precision.
  if (!(ratio < std::exp2(octaves) && low > 1e-280)) {
    const auto ellipse = detail::wide_ellipse(radius_x, radius_y);
    return {static_cast<double>(ellipse.axis_cube), static_cast<double>(ellipse.axes_ratio),
            static_cast<double>(ellipse.approach)};
  }
  int exponent;
  const double mantissa = 2 * std::frexp(ratio, &exponent);  // from 1 to 2
  const int part = static_cast<int>((mantissa - 1) * parts);
  const double centre = 1 + (2 * part + 1) / (2.0 * parts);
  const double rest = std::ldexp(std::fma(-ratio, low, high) / low, 1 - exponent);
  const double u = (mantissa - centre) + rest;
  const int row = ((radius_y < radius_x ? octaves : 0) + exponent - 1) * parts + part;
  const auto* const piece = pieces + static_cast<std::ptrdiff_t>(3 * row);
  return {value_of(piece[0], u), value_of(piece[1], u), value_of(piece[2], u)};
}

}  // namespace tribo
