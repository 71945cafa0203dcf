// SPDX-License-Identifier: Apache-2.0
// The film that a pressure adds on an elastic half-plane: −(1/π) ∫ P(t) ln|x − t| dt, exactly, for
// pressure that is linear from node to node.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace tribo::ehl {

// A function whose second derivative is ln|z|.
inline double twice_integrated_log(double z) {
  if (z == 0) return 0;
  return z * z * (std::log(std::fabs(z)) / 2 - 0.75);
}

// Σ t^k/(k(k+1)(k+2)) over k from 1 on, for |t| ≤ 1/8. Error: 1e-16. Even and odd powers have a sum
// each, because every step of a sum waits for the step before.
inline double sum_of_moments(double t) {
  constexpr auto share = [] {
    std::array<double, 14> shares{};
    for (std::size_t k = 1; k < shares.size(); ++k)
      shares[k] = 1 / static_cast<double>(k * (k + 1) * (k + 2));
    return shares;
  }();
  const double square = t * t;
  double odd = share[13], even = share[12];
  for (std::size_t k = 11; k > 1; k -= 2) {
    odd = odd * square + share[k];
    even = even * square + share[k - 1];
  }
  return (odd * square + share[1]) * t + even * square;
}

// From this many lengths on the closed integrals would lose digits; the series converges there.
inline constexpr double far_lengths = 8;

// ∫ (1 − s/length) ln|r − s| ds from 0 to length.
inline double log_potential_of_half_hat(double r, double length) {
  if (std::fabs(r) >= far_lengths * length)
    return length * (std::log(std::fabs(r)) / 2 - sum_of_moments(length / r));
  const double once = r == 0 ? 0 : r * (std::log(std::fabs(r)) - 1);
  return once - (twice_integrated_log(r) - twice_integrated_log(r - length)) / length;
}

// The film at distance r from the top of a hat of pressure that rises from 0 at −left to 1 at 0 and
// falls to 0 at right. Error: 1e-13 of the hat's area and of the result.
inline double film_of_hat(double r, double left, double right) {
  if (std::fabs(r) >= far_lengths * std::fmax(left, right))
    return (left * sum_of_moments(-left / r) + right * sum_of_moments(right / r) -
            (left + right) / 2 * std::log(std::fabs(r))) /
           std::numbers::pi;
  return -(log_potential_of_half_hat(-r, left) + log_potential_of_half_hat(r, right)) /
         std::numbers::pi;
}

}  // namespace tribo::ehl
