// SPDX-License-Identifier: Apache-2.0
// The film that a pressure adds on an elastic half-plane: −(1/π) ∫ P(t) ln|x − t| dt, exactly, for
// pressure that is linear from node to node.
#pragma once

#include <cmath>
#include <numbers>

namespace tribo::ehl {

// ∬ ln|z|: its second derivative is ln|z|.
inline double twice_integrated_log(double z) {
  if (z == 0) return 0;
  return z * z * (std::log(std::fabs(z)) / 2 - 0.75);
}

// ∫ (1 − s/length) ln|r − s| ds from 0 to length. Near 0 by the integrals of the logarithm. Far
// away these would cancel, and the series of moments, length^{k+1}/((k+1)(k+2)), converges.
inline double log_potential_of_half_hat(double r, double length) {
  if (std::fabs(r) < 8 * length) {
    const double once = r == 0 ? 0 : r * (std::log(std::fabs(r)) - 1);
    return once - (twice_integrated_log(r) - twice_integrated_log(r - length)) / length;
  }
  double sum = length / 2 * std::log(std::fabs(r)), moment = length;
  for (int k = 1; k <= 16 && std::fabs(moment) > 1e-17 * length; ++k) {
    moment *= length / r;
    sum -= moment / (k * (k + 1) * (k + 2));
  }
  return sum;
}

// The film at distance r from the top of a hat of pressure that rises from 0 at −left to 1 at 0 and
// falls to 0 at right. Error: 1e-13 of the hat's area and of the result.
inline double film_of_hat(double r, double left, double right) {
  return -(log_potential_of_half_hat(-r, left) + log_potential_of_half_hat(r, right)) /
         std::numbers::pi;
}

}  // namespace tribo::ehl
