// SPDX-License-Identifier: Apache-2.0
// The shape of Hertz' ellipse in ball arithmetic, in two ways that share no computation: the
// complete elliptic integrals come from Arb's arithmetic-geometric means in one way, and from
// Carlson's duplication in the other.
#pragma once

#include <acb_elliptic.h>

#include <stdexcept>

#include "generators/zeros.hpp"

namespace tribo::reference {

// The real part of a function of complex balls at a real ball.
template <class Function>
Ball at_real(Function&& function, const Ball& x) {
  acb_t argument, value;
  acb_init(argument);
  acb_init(value);
  acb_set_arb(argument, x.get());
  function(value, argument, ball_precision);
  Ball result;
  arb_set(result.get(), acb_realref(value));
  acb_clear(value);
  acb_clear(argument);
  return result;
}
inline Ball first_integral(const Ball& parameter) { return at_real(acb_elliptic_k, parameter); }
inline Ball second_integral(const Ball& parameter) { return at_real(acb_elliptic_e, parameter); }

// Carlson's R_D(0, y, z).
inline Ball carlson_rd(const Ball& y, const Ball& z) {
  acb_t zero, second, third, value;
  for (acb_ptr x : {zero, second, third, value}) acb_init(x);
  acb_set_arb(second, y.get());
  acb_set_arb(third, z.get());
  acb_elliptic_rj(value, zero, second, third, third, 0, ball_precision);
  Ball result;
  arb_set(result.get(), acb_realref(value));
  for (acb_ptr x : {zero, second, third, value}) acb_clear(x);
  return result;
}

// k, and two complete integrals by Carlson's R_D. The integrand of B is cos²/√(1 − q sin²), and
// that of D is sin²/√(1 − q sin²), with q = 1 − 1/k². Nothing cancels in α = k²B/D.
struct Associated {
  Ball k, b, d;
};
inline Associated associated(const Ball& k) {
  const Ball complement = 1 / (k * k);
  return {k, complement * carlson_rd(1, complement) / 3, carlson_rd(complement, 1) / 3};
}

// The ellipse at α ≥ 1, where α is the greater radius of the gap over the smaller one. k ≥ 1 is the
// ratio of its axes. K and E are the complete elliptic integrals of parameter q = 1 − 1/k².
struct EllipseShape {
  Ball k, first, second;  // k, K, E
};

// Solves (k²E − K)/(K − E) = α by bisection, with the integrals by arithmetic-geometric means.
inline EllipseShape shape_by_bisection(const Ball& alpha) {
  if (alpha == 1) return {Ball(1), ball_pi() / 2, ball_pi() / 2};
  const auto parameter = [](const Ball& k) { return 1 - 1 / (k * k); };
  const Ball k = zero_between(
      [&](const Ball& x) {
        const Ball first = first_integral(parameter(x)), second = second_integral(parameter(x));
        return (x * x * second - first) / (first - second) - alpha;
      },
      Ball(1), alpha + 1);
  return {k, first_integral(parameter(k)), second_integral(parameter(k))};
}

// Solves ln(k²B/D) = ln α by Newton's method in t = ln k. The function certainly has opposite
// signs at the two ends of the result, which proves it. Throws std::runtime_error otherwise.
inline Associated shape_by_newton(const Ball& alpha) {
  const Ball target = log(alpha);
  const std::optional<Ball> t = zero_by_newton(
      [&](const Ball& x) {
        const Associated at = associated(exp(x));
        return log(at.k * at.k * at.b / at.d) - target;
      },
      (target * fraction(5, 8)).midpoint(), {230});
  if (!t) throw std::runtime_error("no sign proof for the shape of an ellipse");
  return associated(exp(*t));
}

}  // namespace tribo::reference
