// SPDX-License-Identifier: Apache-2.0
// The shape of Hertz' ellipse in ball arithmetic, in two ways.
#pragma once

#include <stdexcept>

#include "generators/elliptic_integrals.hpp"
#include "generators/load_sharing_root.hpp"

namespace tribo::reference {

// The ellipse of α = the greater radius over the smaller one, α ≥ 1: its axes' ratio k ≥ 1, and
// the complete elliptic integrals of parameter q = 1 − 1/k².
struct EllipseShape {
  Ball k, first, second;  // k, K, E
};

// Bisection on (k²E − K)/(K − E) = α, integrals by arithmetic-geometric means.
inline EllipseShape shape_by_bisection(const Ball& alpha) {
  if (alpha == 1) return {Ball(1), ball_pi() / 2, ball_pi() / 2};
  const auto parameter = [](const Ball& k) { return 1 - 1 / (k * k); };
  const Ball k = bisect(
      [&](const Ball& x) {
        const Ball first = first_integral(parameter(x)), second = second_integral(parameter(x));
        const Ball excess = (x * x * second - first) / (first - second) - alpha;
        return excess < 0 ? -1 : excess > 0 ? 1 : 0;
      },
      Ball(1), alpha + 1);
  return {k, first_integral(parameter(k)), second_integral(parameter(k))};
}

// Newton's method on ln(k²B/D) = ln α in t = ln k, with a proof by signs.
inline Associated shape_by_newton(const Ball& alpha) {
  const Ball target = log(alpha), h = pow(Ball(2), Ball(-120));
  const auto excess = [&](const Ball& t) {
    const Associated at = associated(exp(t));
    return log(at.k * at.k * at.b / at.d) - target;
  };
  Ball t = (target * fraction(5, 8)).midpoint();
  for (int i = 0; i < 100; ++i) {
    const Ball value = excess(t);
    const Ball step = (value * h / (excess((t + h).midpoint()) - value)).midpoint();
    t = (t - step).midpoint();
    if (abs(step) < pow(Ball(2), Ball(-235))) break;
  }
  const Ball radius = pow(Ball(2), Ball(-230));
  if (!(excess((t - radius).midpoint()) < 0 && excess((t + radius).midpoint()) > 0))
    throw std::runtime_error("no sign proof for the shape of an ellipse");
  arb_add_error(t.get(), radius.get());
  return associated(exp(t));
}

}  // namespace tribo::reference
