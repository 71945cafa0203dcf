// SPDX-License-Identifier: Apache-2.0
#include "tribo/hertz_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribo {
namespace {

#include "ellipse_pieces.inc"

}  // namespace

template <>
EllipseOfCircle<double> ellipse_of_circle(const double& radius_x, const double& radius_y) {
  const double low = std::min(radius_x, radius_y), high = std::max(radius_x, radius_y);
  const double ratio = high / low;
  // Below this radius the remainder of the division may be subnormal.
  if (!(ratio < std::exp2(octaves) && low > 1e-280)) {
    const auto ellipse = detail::wide_ellipse(radius_x, radius_y);
    return {static_cast<double>(ellipse.axis_cube), static_cast<double>(ellipse.axes_ratio),
            static_cast<double>(ellipse.approach)};
  }
  int exponent;
  const double mantissa = 2 * std::frexp(ratio, &exponent);  // from 1 to 2
  const int part = static_cast<int>((mantissa - 1) * parts);
  const double rest = std::ldexp(std::fma(-ratio, low, high) / low, 1 - exponent);
  const double centre = 1 + (2 * part + 1) / (2.0 * parts);
  const double u = (mantissa - centre) + rest;
  const int row = ((radius_y < radius_x ? octaves : 0) + exponent - 1) * parts + part;
  const auto* const piece = pieces + static_cast<std::ptrdiff_t>(3 * row);
  const auto value = [&](int k) { return piece[k][0] + detail::beyond_first(piece[k], u); };
  return {value(0), value(1), value(2)};
}

}  // namespace tribo
