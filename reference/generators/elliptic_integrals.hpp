// SPDX-License-Identifier: Apache-2.0
// The complete elliptic integrals of an ellipse of contact, in ball arithmetic, by two ways that
// share nothing: Arb's arithmetic-geometric means, and Carlson's duplication.
#pragma once

#include <acb_elliptic.h>

#include "generators/ball.hpp"

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

// Carlson's integrals at κ = 1/k²: with B and D, the integrals of cos²/√(1 − q sin²) and of
// sin²/√(1 − q sin²), α = k²B/D. Nothing cancels.
struct Associated {
  Ball k, b, d;
};
inline Associated associated(const Ball& k) {
  const Ball complement = 1 / (k * k);
  return {k, complement * carlson_rd(1, complement) / 3, carlson_rd(complement, 1) / 3};
}

}  // namespace tribo::reference
