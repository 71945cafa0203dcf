// SPDX-License-Identifier: Apache-2.0
// What a pressure raises the film by, of an elastic half-plane: −(1/π) ∫ P(t) ln|x − t| dt,
// exactly, for pressure that is linear from node to node.
#pragma once

#include <cmath>
#include <numbers>

namespace tribo::ehl {

// ∬ ln|z|: its second derivative is ln|z|.
inline double twice_integrated_log(double z) {
  if (z == 0) return 0;
  return z * z * (std::log(std::fabs(z)) / 2 - 0.75);
}

// ∫ φ(s) ln|r − s| ds of the hat φ that rises from 0 at −left to 1 at 0 and falls to 0 at right.
// Error: 1e-13 of the hat's area and of the result. Near the hat its second differences are taken;
// far from it they would cancel, and its moments converge: (left^{k+1}(−1)^k +
// right^{k+1})/((k+1)(k+2)).
inline double log_potential_of_hat(double r, double left, double right) {
  const double half = (left + right) / 2;
  const double reach = std::fmax(left, right);
  if (std::fabs(r) < 8 * reach) {
    return (twice_integrated_log(r + left) - twice_integrated_log(r)) / left -
           (twice_integrated_log(r) - twice_integrated_log(r - right)) / right;
  }
  const double a = -left / r, b = right / r;
  double sum = half * std::log(std::fabs(r));
  double of_left = left, of_right = right;
  const double least = 1e-17 * half;
  for (int k = 1; k <= 16; ++k) {
    of_left *= a;
    of_right *= b;
    sum -= (of_left + of_right) / (k * (k + 1) * (k + 2));
    if (std::fabs(of_left) + std::fabs(of_right) < least) break;
  }
  return sum;
}

// The film at distance r from a hat's top, for 1 of pressure there.
inline double film_of_hat(double r, double left, double right) {
  return -log_potential_of_hat(r, left, right) / std::numbers::pi;
}

}  // namespace tribo::ehl
