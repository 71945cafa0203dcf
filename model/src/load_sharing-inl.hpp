// SPDX-License-Identifier: Apache-2.0
// The root of load sharing (load_sharing.hpp) in double, once for each instruction set, for one
// lane and for vectors of points.
//
// The unknown is y = ln(λ/λ₀). With A = (K F_p(λ−δ))^q, the film law's p = 1/(a−b) and w = e^{−py}
// the root has 1 − A = w. This equation is g = 0 in one of two forms:
//
//   the film's form    g = ln(1 − A) − ln w
//   the floor's form   g = ln(1 − w) − ln A, where A > w and λ|d ln A/dλ| A/(1 − A) > p
//
// Both forms increase with y, and each is nearly straight where it is taken. Steps of fourth order
// reach the root in one to three steps from
//   λ₀                   where A(λ₀) < 1 and λ₀ is not next to a floor,
//   just above the floor elsewhere: there ln A = −h(λ − λ_b), and 1 − w hardly changes.
// The floor is that of the surface. Where A(0) is slightly below 1 there is no floor, but the same
// pole of ln(1 − A) lies just below λ = 0: A and its derivatives at λ₀ give it to a few digits.
//
// A step is the last one where the estimate of its error in y is below 2^−55. The greatest error
// of 39 000 random steps was 1.09 times its estimate; in the 2400 steps of analytic.SharingStep no
// error exceeds its estimate. No iterate falls below λ₀. A lane that has not reached its root after
// max_sharing_steps is left to Newton's method on the convex function A + w − 1 (load_sharing.hpp),
// whose steps from any start below the root rise to the root.
#include <hwy/highway.h>

#include <limits>

#include "elementary-inl.hpp"
#include "gaussian_moment-inl.hpp"
#include "sharing_method.hpp"

#if defined(TRIBO_LOAD_SHARING) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_LOAD_SHARING
#undef TRIBO_LOAD_SHARING
#else
#define TRIBO_LOAD_SHARING
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// Points of load sharing: K, δ, λ₀.
template <class V>
struct SharingInputs {
  V stiffness, offset, flooded;
};

template <class V>
struct Asperities {
  V share;   // A
  V hazard;  // −d ln A/dλ
  V slope;   // d hazard/dλ ≥ 0
  V bend;    // d slope/dλ
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Asperities<V> asperities(D d, Order order, const SharingInputs<V>& in, V lambda) {
  const V exponent = hn::Set(d, order == Order::five_halves ? 0.5 : 1.0);
  const V n = hn::Set(d, 0.5 * twice(order));
  const V argument = hn::Sub(lambda, in.offset);
  const auto below_zero = hn::Lt(argument, hn::Zero(d));
  const V x = distance_in_pieces(d, argument);
  const auto [moment, log_slope] = moment_and_log_slope(d, order, below_zero, x);
  const V product = hn::Mul(in.stiffness, moment);
  // h = −d ln F_n/dd, h′ = h² − dh − n, h″ = (2h − d)h′ − h
  const V h = hn::IfThenElse(below_zero, log_slope, hn::Sub(x, log_slope));
  const V less_d = hn::IfThenElse(below_zero, hn::Add(h, x), hn::Neg(log_slope));
  const V square = hn::IfThenZeroElse(below_zero, hn::Mul(x, x));
  const V gaussian = exponential(d, hn::Mul(hn::Mul(hn::Set(d, -0.5), exponent), square));
  const V share = hn::Mul(order == Order::five_halves ? hn::Sqrt(product) : product, gaussian);
  const V slope = hn::Max(hn::MulSub(h, less_d, n), hn::Zero(d));
  return {share, hn::Mul(exponent, h), hn::Mul(exponent, slope),
          hn::Mul(exponent, hn::MulSub(hn::Add(h, less_d), slope, h))};
}

// An iterate of a point: λ and y = ln(λ/λ₀).
template <class V>
struct Iterate {
  V film_parameter, log_rise;
};

// x e^s, by a short series where |s| is small in all lanes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V times_exp(D d, V x, V s) {
  V sum = hn::MulAdd(s, hn::Set(d, 1.0 / 120), hn::Set(d, 1.0 / 24));
  sum = hn::MulAdd(sum, s, hn::Set(d, 1.0 / 6));
  sum = hn::MulAdd(sum, s, hn::Set(d, 0.5));
  const V near = hn::MulAdd(x, hn::MulAdd(hn::Mul(s, s), sum, s), x);
  const auto is_near = hn::Lt(hn::Abs(s), hn::Set(d, 0x1p-8));  // s⁶/720 < 2^−57
  if (hn::AllTrue(d, is_near)) return near;
  return hn::IfThenElse(is_near, near, hn::Mul(x, exponential(d, s)));
}

// An iterate a little above a floor λ_b. At λ_b + x A is e^{−hx}; (λ₀/λ)^p hardly changes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Iterate<V> above_floor(D d, V film_power, V floor, V hazard, V flooded) {
  const V p = film_power, one = hn::Set(d, 1.0);
  const V log_rise = rough_logarithm(d, hn::Div(floor, flooded));
  const V w = hn::Mul(exponential(d, hn::Neg(hn::Mul(p, log_rise))), hn::Set(d, 0.999));
  const V rest = hn::Sub(one, w);
  const V rate = hn::MulAdd(p, hn::Div(w, rest), hn::Mul(hazard, floor));
  const V further = hn::Neg(hn::Div(rough_logarithm(d, rest), rate));
  return {times_exp(d, floor, further), hn::Add(log_rise, further)};
}

// A start for a λ₀ below the floor or hardly above it. It lies a little above the zero of the
// parabola that has the value, slope and curvature of ln A at λ₀. This zero is taken as at most
// δ + √(2 ln(K F_p(0))), which no floor exceeds.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Iterate<V> jump_above_floor(D d, Order order, V film_power, const SharingInputs<V>& in,
                                       const Asperities<V>& at) {
  const V one = hn::Set(d, 1.0), two = hn::Set(d, 2.0);
  const V log_share = rough_logarithm(d, hn::Max(at.share, one));
  const V root =
      hn::Sqrt(hn::MulAdd(hn::Mul(two, at.slope), log_share, hn::Mul(at.hazard, at.hazard)));
  V distance = hn::Div(hn::Mul(two, log_share), hn::Add(at.hazard, root));
  const V at_zero = hn::Mul(in.stiffness, hn::Set(d, sharing_moment_at_zero(order)));
  const V limit =
      hn::Add(in.offset, hn::Sqrt(hn::Mul(two, rough_logarithm(d, hn::Max(at_zero, one)))));
  distance = hn::Min(distance, hn::Max(hn::Sub(limit, in.flooded), hn::Zero(d)));
  return above_floor(d, film_power, hn::Add(in.flooded, distance),
                     hn::MulAdd(at.slope, distance, at.hazard), in.flooded);
}

// A step consists of four functions of a point; film_power is p. A batch calls each for all its
// points before the next: a processor does not look ahead over the chain of four.

// w = (λ₀/λ)^p
template <class D, class V = hn::Vec<D>>
HWY_INLINE V film_share(D d, V film_power, V log_rise) {
  if (hn::AllTrue(d, hn::Eq(log_rise, hn::Zero(d)))) return hn::Set(d, 1.0);
  return exponential(d, hn::Neg(hn::Mul(film_power, log_rise)));
}

// 1 − x, not below 2^−60
template <class D, class V = hn::Vec<D>>
HWY_INLINE V complement(D d, V x) {
  return hn::Max(hn::Sub(hn::Set(d, 1.0), x), hn::Set(d, 0x1p-60));
}

// Is the floor's form taken? It is taken where it is straighter. Near the root g″/g′ of the film's
// form is about (c/p)² times that of the floor's form, with c = λ|d ln A/dλ| A/(1 − A).
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_by_floor(D d, V film_power, const Iterate<V>& from,
                                   const Asperities<V>& at, V w) {
  const V a = hn::Mul(at.hazard, from.film_parameter);
  return hn::And(hn::Gt(at.share, w),
                 hn::Gt(hn::Mul(a, at.share), hn::Mul(film_power, complement(d, at.share))));
}

// g = ln(1 + s), with s = (1 − A − w)/w in the film's form and (1 − A − w)/A in the floor's form;
// by a short series where |s| is small in all lanes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log_balance(D d, V share, V w, hn::Mask<D> by_floor) {
  const V one = hn::Set(d, 1.0);
  const V rest = hn::Sub(hn::Sub(one, hn::Max(share, w)), hn::Min(share, w));
  const V s = hn::Div(rest, hn::IfThenElse(by_floor, share, w));
  V sum = hn::MulAdd(s, hn::Set(d, -1.0 / 6), hn::Set(d, 1.0 / 5));
  sum = hn::MulAdd(sum, s, hn::Set(d, -1.0 / 4));
  sum = hn::MulAdd(sum, s, hn::Set(d, 1.0 / 3));
  sum = hn::MulAdd(sum, s, hn::Set(d, -0.5));
  const V near = hn::MulAdd(hn::Mul(s, s), sum, s);
  const auto is_near = hn::Lt(hn::Abs(s), hn::Set(d, 0x1p-8));  // |s|⁷/7 < 2^−58
  if (hn::AllTrue(d, is_near)) return near;
  return hn::IfThenElse(is_near, near, rough_logarithm(d, hn::Add(one, s)));
}

template <class D>
struct Step {
  hn::Vec<D> log_rise;     // the next y
  hn::Vec<D> base, shift;  // the next λ = base e^shift
  hn::Mask<D> is_last;
};

// The derivatives of −ln A by y, where λ is proportional to e^y.
template <class V>
struct Rises {
  V first, second, third;
};
template <class V>
HWY_INLINE Rises<V> rises_of(const Asperities<V>& at, V lambda) {
  const V a1 = hn::Mul(at.hazard, lambda);
  const V bent = hn::Mul(hn::Mul(at.slope, lambda), lambda);
  const V a2 = hn::Add(a1, bent);
  const V a3 = hn::Add(
      a2, hn::MulAdd(hn::Mul(hn::Mul(at.bend, lambda), lambda), lambda, hn::Add(bent, bent)));
  return {a1, a2, a3};
}
// The same derivatives at y = 0, for a λ proportional to e^{y + cy²/2}.
template <class V>
HWY_INLINE Rises<V> bent(const Rises<V>& a, V c) {
  const V by_first = hn::Mul(a.first, c), by_second = hn::Mul(a.second, c);
  return {a.first, hn::Add(a.second, by_first),
          hn::Add(a.third, hn::Add(by_second, hn::Add(by_second, by_second)))};
}

// A step of fourth order on g, by the inverse of its Taylor series. g = ln(1 − e^{−v}) + u, with v
// and u ≥ 0: in the film's form v = −ln A and u = −ln w = py, in the floor's form v = −ln w = py
// and u = −ln A.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Step<D> step_by(D d, V film_power, V flooded, const Iterate<V>& from,
                           const Rises<V>& of_share, V share, V w, hn::Mask<D> by_floor,
                           V balance) {
  const V one = hn::Set(d, 1.0), p = film_power, zero = hn::Zero(d);
  const V lambda = from.film_parameter;
  const auto& [a1, a2, a3] = of_share;
  const V v1 = hn::IfThenElse(by_floor, p, a1), u1 = hn::IfThenElse(by_floor, a1, p);
  const V v2 = hn::IfThenZeroElse(by_floor, a2), u2 = hn::IfThenElseZero(by_floor, a2);
  const V v3 = hn::IfThenZeroElse(by_floor, a3), u3 = hn::IfThenElseZero(by_floor, a3);
  // g′ = u′ + r v′ with r = e^{−v}/(1 − e^{−v}); r′ = −r s with s = (1 + r)v′
  const V small = hn::IfThenElse(by_floor, w, share);
  const V r = hn::Div(small, complement(d, small));
  const V s = hn::MulAdd(v1, r, v1), s_v1 = hn::Mul(s, v1);
  const V g1 = hn::MulAdd(r, v1, u1);
  const V g2 = hn::MulAdd(r, hn::Sub(v2, s_v1), u2);
  const V inner3 = hn::MulAdd(hn::Mul(s_v1, v1), hn::MulAdd(r, hn::Set(d, 2.0), one),
                              hn::NegMulAdd(hn::Mul(s, hn::Set(d, 3.0)), v2, v3));
  const V g3 = hn::MulAdd(r, inner3, u3);
  const V inverse = hn::Div(one, g1);
  const V newton = hn::Neg(hn::Mul(balance, inverse));
  const V scale = hn::Mul(newton, inverse);
  const V t2 = hn::Mul(hn::Mul(hn::Set(d, 0.5), scale), g2);
  const V t3 = hn::Mul(hn::Mul(hn::Mul(hn::Set(d, 1.0 / 6), scale), newton), g3);
  const V stretch = hn::Add(hn::MulSub(hn::Add(t2, t2), t2, t2), hn::Sub(one, t3));
  const V step = hn::Mul(newton, hn::Min(hn::Max(stretch, hn::Set(d, 0.5)), hn::Set(d, 2.0)));
  const V bounded =
      hn::Min(hn::Max(step, hn::Set(d, sharing_least_step)), hn::Set(d, sharing_greatest_step));
  const V rise = hn::Max(hn::Add(from.log_rise, bounded), zero);
  const auto is_near = hn::Lt(rise, hn::Set(d, sharing_near_rise));
  // The first term that is left out is |5t₂³ − 5t₂t₃ + t₄|·newton. `estimate` has its size unless
  // the terms of t₄ cancel: each derivative of v and of ln(1 − e^{−v}) is at most about (1 + s)
  // times the derivative before it.
  const V reach = hn::Mul(newton, hn::Add(one, s)), reach2 = hn::Mul(reach, reach);
  const V bends = hn::Mul(hn::MulAdd(r, hn::Add(v2, s_v1), u2), inverse);
  const V estimate = hn::Mul(hn::Mul(reach2, hn::Mul(newton, newton)), bends);
  return {rise, hn::IfThenElse(is_near, flooded, lambda),
          hn::IfThenElse(is_near, rise, bounded),  // rise − log_rise, unrounded
          hn::And(hn::Lt(reach2, hn::Set(d, 0x1p-4)), hn::Lt(estimate, hn::Set(d, 0x1p-55)))};
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE Step<D> sharing_step(D d, V film_power, V flooded, const Iterate<V>& from,
                                const Asperities<V>& at, V w, hn::Mask<D> by_floor, V balance) {
  return step_by(d, film_power, flooded, from, rises_of(at, from.film_parameter), at.share, w,
                 by_floor, balance);
}

// Is λ still λ₀, and below a floor or hardly above it? Then a jump takes the place of the step.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_below_floor(D d, const Asperities<V>& at, const Iterate<V>& now) {
  const V near = hn::Set(d, sharing_pole_nearness);
  const V a = hn::Mul(at.hazard, now.film_parameter);
  return hn::And(hn::Ge(hn::MulAdd(a, at.share, hn::Mul(near, at.share)), near),
                 hn::Eq(now.log_rise, hn::Zero(d)));
}

// The roots of a vector of points, from the start `now` and A there; NaN where a root is not
// reached in max_sharing_steps. `steps` is the number of steps of the slowest lane.
template <class V>
struct Roots {
  V film_parameter;
  int steps;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE Roots<V> roots_from(D d, Order order, V film_power, const SharingInputs<V>& in,
                               Iterate<V> now, Asperities<V> at) {
  auto is_open = hn::Eq(in.flooded, in.flooded);
  V root = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
  for (int steps = 1; steps <= max_sharing_steps; ++steps) {
    const V w = film_share(d, film_power, now.log_rise);
    const auto by_floor = is_by_floor(d, film_power, now, at, w);
    const Step<D> step = sharing_step(d, film_power, in.flooded, now, at, w, by_floor,
                                      log_balance(d, at.share, w, by_floor));
    const auto below = is_below_floor(d, at, now);
    now = {times_exp(d, step.base, step.shift), step.log_rise};
    auto arrives = hn::And(step.is_last, is_open);
    if (HWY_UNLIKELY(!hn::AllFalse(d, below))) {
      const Iterate<V> above = jump_above_floor(d, order, film_power, in, at);
      now.film_parameter = hn::IfThenElse(below, above.film_parameter, now.film_parameter);
      now.log_rise = hn::IfThenElse(below, above.log_rise, now.log_rise);
      arrives = hn::AndNot(below, arrives);
    }
    root = hn::IfThenElse(arrives, now.film_parameter, root);
    is_open = hn::AndNot(arrives, is_open);
    if (hn::AllFalse(d, is_open)) return {root, steps};
    at = asperities(d, order, in, now.film_parameter);
  }
  return {root, max_sharing_steps};
}

// e + 1, for 2^e ≤ x < 2^{e+1}.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exponent_plus_one(D d, V x) {
  const hn::RebindToUnsigned<D> bits;
  const auto biased = hn::ShiftRight<52>(hn::BitCast(bits, x));
  const V with_bias = hn::BitCast(d, hn::Or(biased, hn::BitCast(bits, hn::Set(d, 0x1p52))));
  return hn::Sub(with_bias, hn::Set(d, 0x1p52 + 1022));
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
