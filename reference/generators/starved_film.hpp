// SPDX-License-Identifier: Apache-2.0
// y = h*/h_ff of the four closures of the inlet, in ball arithmetic and in two ways.
#pragma once

#include <array>
#include <stdexcept>

#include "generators/zeros.hpp"

namespace tribo::reference {

enum class Inlet { flooded_inlet, starved_inlet, printed_exponents, damiens };
inline constexpr std::array inlets{Inlet::flooded_inlet, Inlet::starved_inlet,
                                   Inlet::printed_exponents, Inlet::damiens};
inline const char* name(Inlet inlet) {
  constexpr std::array names{"flooded_inlet", "starved_inlet", "printed_exponents", "damiens"};
  return names[static_cast<std::size_t>(inlet)];
}

inline Ball crook() { return 4 * sqrt(Ball(2)) / 3; }  // 4√2/3 of eq. 1.10

// The solution ψ of y = (2/π) arctan(2.7ψ).
inline Ball inlet_length(const Ball& y) { return tan(ball_pi() * y / 2) / fraction(27, 10); }

// 1/r as a function of y, for the closures that have one; increasing in y.
inline Ball inverse_ratio(Inlet inlet, const Ball& y) {
  const Ball psi = inlet_length(y);
  const Ball psi32 = psi * sqrt(psi);
  if (inlet == Inlet::flooded_inlet) return 1 + crook() * psi32;
  if (inlet == Inlet::starved_inlet) return y + crook() * psi32;
  return y + crook() * psi32 / (y * sqrt(sqrt(y)));
}

inline Ball damiens_ratio(const Ball& r, const Ball& gamma) {
  return pow(1 + pow(r, gamma), -1 / gamma);
}

// The second way: bisection in y, by certain signs, until inverse_ratio() is 1/r. The lower end of
// the bracket is so small because y falls as fast as r^−4.
inline Ball film_ratio_by_bisection(Inlet inlet, const Ball& r, const Ball& gamma) {
  if (inlet == Inlet::damiens) return damiens_ratio(r, gamma);
  if (inlet == Inlet::flooded_inlet && r >= 1) return Ball(0);
  const Ball low = pow(r > 1 ? r : Ball(1), Ball(-4)) * pow(Ball(10), Ball(-6));
  const Ball high = 1 - pow(Ball(2), Ball(-250));
  return zero_between([&](const Ball& y) { return inverse_ratio(inlet, y) * r - 1; },
                      low.midpoint(), high.midpoint());
}

// The first way: explicit where that is possible (flooded_inlet by the arctangent, damiens by
// ρ = 1/r), else Newton's method in ln ψ with a proof by signs.
inline Ball film_ratio_by_inlet_length(Inlet inlet, const Ball& r, const Ball& gamma) {
  if (inlet == Inlet::damiens) {
    const Ball rho = 1 / r;
    return rho * pow(1 + pow(rho, gamma), -1 / gamma);
  }
  const auto ratio_at = [](const Ball& psi) {
    return 2 / ball_pi() * atan(fraction(27, 10) * psi);
  };
  if (inlet == Inlet::flooded_inlet) {
    if (r >= 1) return Ball(0);
    return ratio_at(pow((1 / r - 1) / crook(), fraction(2, 3)));
  }
  const auto excess = [&](const Ball& t) {  // ln(r G(ψ)), ψ = e^t
    const Ball psi = exp(t), y = ratio_at(psi);
    Ball term = crook() * psi * sqrt(psi);
    if (inlet == Inlet::printed_exponents) term = term / (y * sqrt(sqrt(y)));
    return log(r * (y + term));
  };
  // r may come from a root that is known only to the last of these numbers of bits.
  const std::optional<Ball> t = zero_by_newton(excess, (-log(r)).midpoint(), {240, 210, 170, 145});
  if (!t) throw std::runtime_error("no sign proof for a film ratio");
  return ratio_at(exp(*t));
}

}  // namespace tribo::reference
