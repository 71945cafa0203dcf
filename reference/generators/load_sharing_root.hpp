// SPDX-License-Identifier: Apache-2.0
// The root of ln λ − ln λ₀ + e ln(1 − A(λ)) = 0 with A = (K F_p(λ−δ))^q; e is 0.14, or that of
// another film law. The first way is Newton's method with a proof by signs, the second way is
// bisection in ball arithmetic.
#pragma once

#include <functional>
#include <stdexcept>

#include "generators/moments.hpp"
#include "generators/zeros.hpp"

namespace tribo::reference {

enum class Rough { tripp, williamson };

using Moment = std::function<Ball(int twice_n, const Ball& d)>;

struct RoughContact {
  Rough model;
  Ball stiffness, offset;  // K, δ
  Moment moment = moment_by_hypergeometric;
  Ball exponent = fraction(14, 100);  // e

  Ball share(const Ball& lambda) const {  // A
    const int order = model == Rough::tripp ? 5 : 3;
    Ball load = stiffness * moment(order, lambda - offset);
    // where F_p underflows, its ball lies around 0
    arb_nonnegative_part(load.get(), load.get());
    return model == Rough::tripp ? unary(arb_sqrtpos, load) : load;
  }
  Ball share_slope(const Ball& lambda) const {  // d ln A/dλ
    const int order = model == Rough::tripp ? 5 : 3;
    const Ball d = lambda - offset;
    const Ball q = model == Rough::tripp ? fraction(1, 2) : Ball(1);
    return -q * fraction(order, 2) * moment(order - 2, d) / moment(order, d);
  }
};

// The certain sign of the residual, −1 or 1 (−1 also where A ≥ 1). 0 if it is undecided.
inline int sign_at(const RoughContact& contact, const Ball& lambda0, const Ball& lambda) {
  const Ball share = contact.share(lambda);
  if (share >= 1) return -1;
  if (!(share < 1)) return 0;
  return sign(log(lambda) - log(lambda0) + contact.exponent * log1p(-share));
}

// Whether it is certain that the residual changes its sign between λ(1 − 2^−bits) and
// λ(1 + 2^−bits).
inline bool is_proven(const RoughContact& contact, const Ball& lambda0, const Ball& lambda,
                      int bits) {
  const Ball step = pow(Ball(2), Ball(-bits));
  return sign_at(contact, lambda0, (lambda * (1 - step)).midpoint()) < 0 &&
         sign_at(contact, lambda0, (lambda * (1 + step)).midpoint()) > 0;
}

// An upper end of the root's bracket: A ≤ 1/2 there, because F_p(d) ≤ F_p(0) e^{−d²/2}.
inline Ball upper_bound(const RoughContact& contact, const Ball& lambda0) {
  const Ball load = contact.stiffness * 4;
  const Ball by_floor = contact.offset + 1 + (load > 1 ? sqrt(2 * log(load)) : Ball(0));
  const Ball by_film = lambda0 * 2;
  return (by_floor > by_film ? by_floor : by_film).midpoint();
}

inline Ball root_by_bisection(const RoughContact& contact, const Ball& lambda0) {
  return bisect([&](const Ball& x) { return sign_at(contact, lambda0, x); },
                (lambda0 * fraction(1, 2)).midpoint(), upper_bound(contact, lambda0));
}

// Newton's method on midpoints finds the zero of A + w − 1 with w = (λ₀/λ)^{1/e}, from λ₀, or from
// the floor where A(λ₀) ≥ 1. Where the floor is the root to working precision, the steps end there.
// A proof by signs follows; throws std::runtime_error where there is none.
inline Ball root_by_newton(const RoughContact& contact, const Ball& lambda0) {
  Ball lambda = lambda0.midpoint();
  if (contact.share(lambda) >= 1)  // below the floor: start from the floor
    lambda = bisect([&](const Ball& x) { return contact.share(x) >= 1 ? -1 : 1; }, lambda,
                    upper_bound(contact, lambda0))
                 .midpoint();
  for (int i = 0; i < 500; ++i) {
    const Ball share = contact.share(lambda);
    const Ball fluid = pow(lambda0 / lambda, 1 / contact.exponent);
    const Ball asperity_slope =
        share < pow(Ball(2), Ball(-400)) ? Ball(0) : contact.share_slope(lambda) * share;
    const Ball slope = asperity_slope - fluid / lambda / contact.exponent;
    const Ball step = ((share + fluid - 1) / slope).midpoint();
    lambda = (lambda - step).midpoint();
    if (abs(step) < lambda * pow(Ball(2), Ball(-260))) break;
  }
  for (const int bits : {250, 220, 180, 145})
    if (is_proven(contact, lambda0, lambda, bits)) return with_relative_radius(lambda, bits);
  throw std::runtime_error("no sign proof for a load-sharing root");
}

}  // namespace tribo::reference
