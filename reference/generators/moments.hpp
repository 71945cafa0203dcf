// SPDX-License-Identifier: Apache-2.0
// F_n(d) = ∫_d^∞ (s−d)ⁿ φ(s) ds in ball arithmetic, in two ways: by hypergeometric functions and by
// quadrature.
#pragma once

#include <acb_calc.h>
#include <arb_hypgeom.h>

#include <cmath>
#include <stdexcept>

#include "generators/ball.hpp"

namespace tribo::reference {

// The moment over a ball from its value at the midpoint, because a series whose argument is a ball
// would cancel: F(d ± ρ) = F(d) e^{±hρ} with h = −F′/F ≤ max(d, 0) + n + 2. Proof:
// h′ = h² − dh − n; if h − d reached n + 2, it would grow for ever, but h → d. Below 0, h is less
// than at 0, because F is log-concave.
inline Ball widened(Ball value, int twice_n, const Ball& ball) {
  Ball radius;
  arb_get_rad_arb(radius.get(), ball.get());
  const Ball d = ball.midpoint();
  const Ball slope = (d > 0 ? d : Ball(0)) + fraction(twice_n, 2) + 2;
  const Ball widening = abs(value) * expm1(slope * radius);
  arb_add_error(value.get(), widening.get());
  return value;
}

// F_n at d > 10000: it is at most e^{−d²/2}, so that a ball around 0 encloses it.
inline Ball nothing() {
  Ball result;
  const Ball bound = exp(Ball(-50000000));
  arb_add_error(result.get(), bound.get());
  return result;
}

// e^{d²/2} F_n(d), d without a radius, n = twice_n/2, by confluent hypergeometric functions. Up to
// d = 25, F_n(d) = Γ(n+1)/√(2π) 2^{(n+1)/2} e^{−d²/2} H_{−n−1}(d/√2) with the Hermite function,
// whose two series cancel by e^{d²}. Beyond, F_n(d) = Γ(n+1)/√(2π) 2^{−(n+1)/2} e^{−d²/2}
// U((n+1)/2, 1/2, d²/2) with the asymptotic series of U.
inline Ball scaled_moment_by_hypergeometric(int twice_n, const Ball& d) {
  const Ball n = fraction(twice_n, 2);
  const Ball half = (n + 1) / 2;
  Ball function;
  if (d > 25) {
    const Ball b = fraction(1, 2), z = d * d / 2;
    arb_hypgeom_u(function.get(), half.get(), b.get(), z.get(), ball_precision + 60);
    function *= pow(Ball(2), -half);
  } else {
    const double size = d.nearest();
    const slong working =
        ball_precision + 60 + (size > 0 ? static_cast<slong>(1.5 * size * size) : 0);
    const Ball order = -n - 1;
    Ball argument;
    arb_sqrt_ui(argument.get(), 2, working);
    arb_div(argument.get(), d.get(), argument.get(), working);
    arb_hypgeom_hermite_h(function.get(), order.get(), argument.get(), working);
    function *= pow(Ball(2), half);
  }
  return gamma(n + 1) / sqrt(2 * ball_pi()) * function;
}

inline Ball moment_by_hypergeometric(int twice_n, const Ball& ball) {
  const Ball d = ball.midpoint();
  if (d > 10000) return nothing();
  return widened(exp(-d * d / 2) * scaled_moment_by_hypergeometric(twice_n, d), twice_n, ball);
}

namespace detail {

struct Integrand {
  int power;  // 2n+1
  const Ball* shift;
};

// 2 x^{2n+1} e^{−(x²+d)²/2}: entire, so acb_calc_integrate bounds it everywhere.
inline int integrand(acb_ptr result, const acb_t x, void* parameters, slong, slong precision) {
  const auto* p = static_cast<const Integrand*>(parameters);
  acb_t square;
  acb_init(square);
  acb_mul(square, x, x, precision);
  acb_add_arb(square, square, p->shift->get(), precision);
  acb_mul(square, square, square, precision);
  acb_mul_2exp_si(square, square, -1);
  acb_neg(square, square);
  acb_exp(square, square, precision);
  acb_pow_ui(result, x, static_cast<ulong>(p->power), precision);
  acb_mul(result, result, square, precision);
  acb_mul_2exp_si(result, result, 1);
  acb_clear(square);
  return 0;
}

}  // namespace detail

// The moment by rigorous quadrature with s − d = x², over panels up to x² = t. There (t+d)²/2 is
// above 600, or the integrand has fallen by e^−600 from its start. The error includes the rest:
// ∫_t^∞ v^n e^{−(v+d)²/2} dv is at most t^n e^{−(t+d)²/2}/((t+d) − n/t).
inline Ball moment_by_quadrature(int twice_n, const Ball& ball) {
  const Ball d = ball.midpoint();
  if (d > 10000) return nothing();
  const double start = d.nearest();
  const double reach = start < 0 ? 35 - start : std::sqrt(start * start + 1200) - start;
  const int panels = 24 + static_cast<int>(8 * std::sqrt(reach));
  const Ball end = sqrt(Ball(reach));
  detail::Integrand parameters{twice_n + 1, &d};
  // The error allowed in a panel is 2^−200 of the whole, or of the panel.
  mag_t tolerance;
  mag_init(tolerance);
  const Ball size = moment_by_hypergeometric(twice_n, d) * pow(Ball(2), Ball(-200));
  arb_get_mag(tolerance, size.get());
  acb_t low, high, value;
  acb_init(low), acb_init(high), acb_init(value);
  Ball integral;
  bool converged = true;
  for (int i = 0; i < panels; ++i) {
    const Ball a = end * i / panels, b = end * (i + 1) / panels;
    acb_set_arb(low, a.get());
    acb_set_arb(high, b.get());
    converged = acb_calc_integrate(value, detail::integrand, &parameters, low, high, 200, tolerance,
                                   nullptr, ball_precision) == ARB_CALC_SUCCESS &&
                converged;
    arb_add(integral.get(), integral.get(), acb_realref(value), ball_precision);
  }
  acb_clear(low), acb_clear(high), acb_clear(value);
  mag_clear(tolerance);
  if (!converged) throw std::runtime_error("quadrature did not converge at d = " + d.decimal(20));
  const Ball n = fraction(twice_n, 2), t = end * end;
  const Ball tail = pow(t, n) * exp(-(t + d) * (t + d) / 2) / ((t + d) - n / t);
  arb_add_error(integral.get(), tail.get());
  return widened(integral / sqrt(2 * ball_pi()), twice_n, ball);
}

}  // namespace tribo::reference
