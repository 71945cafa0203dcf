// SPDX-License-Identifier: Apache-2.0
// The root of load sharing (load_sharing.hpp) in double, once for each instruction set, for one
// lane and for vectors of points.
//
// In y = ln(λ/λ₀), with U = ln A, A = (K F_p(λ−δ))^q, and w = e^{−py} = 1 − A at the root, p =
// 1/0.14,
//
//   where A ≤ w   g = p y + ln(1 − A)       where A > w   g = ln(1 − w) − U
//
// both increase and are nearly straight, so that Chebyshev's steps, of third order, reach the root
// in one to three from
//   λ₀                   where A(λ₀) < 1 and not next to it,
//   just above the floor where not: there U = −h(λ − λ_b), and 1 − w hardly changes.
// The floor is the surface's. Where A(0) is hardly below 1 there is none, but the same pole just
// below 0: it is found to a few digits from U and its derivatives at λ₀.
//
// A step is the last where it is below 2^−17 of the length over which g bends, 1/(p + λ|dU/dλ|) or
// 1/g′, where that is shorter (next to the pole of a logarithm): its error is cubic, below 2^−51 of
// that length. No iterate falls below λ₀, and a lane that is not there after max_sharing_steps is
// left to Newton's method on the convex form, which rises to the root from wherever it starts left
// of it.
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
  V slope;   // of the hazard, ≥ 0
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
  // h = −d ln F_n/dd and h′ = h² − dh − n
  const V h = hn::IfThenElse(below_zero, log_slope, hn::Sub(x, log_slope));
  const V less_d = hn::IfThenElse(below_zero, hn::Add(h, x), hn::Neg(log_slope));
  const V square = hn::IfThenZeroElse(below_zero, hn::Mul(x, x));
  const V gaussian = exponential(d, hn::Mul(hn::Mul(hn::Set(d, -0.5), exponent), square));
  const V share = hn::Mul(order == Order::five_halves ? hn::Sqrt(product) : product, gaussian);
  return {share, hn::Mul(exponent, h),
          hn::Mul(exponent, hn::Max(hn::MulSub(h, less_d, n), hn::Zero(d)))};
}

// A point on its way: λ and y = ln(λ/λ₀).
template <class V>
struct Iterate {
  V film_parameter, log_rise;
};

// x e^s, without the whole exponential where no lane needs it.
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

// A little above a floor, where A falls as e^{−hx} and (λ₀/λ)^p hardly changes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Iterate<V> above_floor(D d, V floor, V hazard, V flooded) {
  const V p = hn::Set(d, sharing_p), one = hn::Set(d, 1.0);
  const V log_rise = rough_logarithm(d, hn::Div(floor, flooded));
  const V w = hn::Mul(exponential(d, hn::Neg(hn::Mul(p, log_rise))), hn::Set(d, 0.999));
  const V rest = hn::Sub(one, w);
  const V rate = hn::MulAdd(p, hn::Div(w, rest), hn::Mul(hazard, floor));
  const V further = hn::Neg(hn::Div(rough_logarithm(d, rest), rate));
  return {times_exp(d, floor, further), hn::Add(log_rise, further)};
}

// A start from a λ₀ below the floor: where ln A, continued from there as a parabola, is 0, but not
// beyond δ + √(2 ln K F_p(0)), which no floor passes; and from there a little above.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Iterate<V> jump_above_floor(D d, Order order, const SharingInputs<V>& in,
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
  return above_floor(d, hn::Add(in.flooded, distance), hn::MulAdd(at.slope, distance, at.hazard),
                     in.flooded);
}

// A step is four functions of a point. A batch runs each over all its points before the next: the
// chain of all four is longer than a processor looks ahead.

// w = (λ₀/λ)^p
template <class D, class V = hn::Vec<D>>
HWY_INLINE V film_share(D d, V log_rise) {
  if (hn::AllTrue(d, hn::Eq(log_rise, hn::Zero(d)))) return hn::Set(d, 1.0);
  return exponential(d, hn::Mul(hn::Set(d, -sharing_p), log_rise));
}

// 1 − x, not below 2^−60
template <class D, class V = hn::Vec<D>>
HWY_INLINE V complement(D d, V x) {
  return hn::Max(hn::Sub(hn::Set(d, 1.0), x), hn::Set(d, 0x1p-60));
}

// ln(1 − A) where A ≤ w, ln((1 − w)/A) where not
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log_balance(D d, V share, V w) {
  const V rest = complement(d, hn::Min(share, w));
  return rough_logarithm(d, hn::IfThenElse(hn::Gt(share, w), hn::Div(rest, share), rest));
}

template <class D>
struct Step {
  hn::Vec<D> log_rise;     // the next y
  hn::Vec<D> base, shift;  // the next λ = base e^shift
  hn::Mask<D> is_last;
};

// Chebyshev's step on g; `logarithm` is log_balance.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Step<D> sharing_step(D d, V flooded, const Iterate<V>& from, const Asperities<V>& at,
                                V w, V logarithm) {
  const V one = hn::Set(d, 1.0), p = hn::Set(d, sharing_p), zero = hn::Zero(d);
  const auto by_floor = hn::Gt(at.share, w);
  const V small = hn::Min(at.share, w);
  const V r = hn::Div(small, complement(d, small));
  // −dU/dy and −d²U/dy²
  const V a = hn::Mul(at.hazard, from.film_parameter);
  const V b = hn::MulAdd(hn::Mul(at.slope, from.film_parameter), from.film_parameter, a);
  const V r_bend = hn::MulAdd(r, r, r);
  const V g = hn::Add(logarithm, hn::IfThenZeroElse(by_floor, hn::Mul(p, from.log_rise)));
  const V g1 = hn::IfThenElse(by_floor, hn::MulAdd(p, r, a), hn::MulAdd(a, r, p));
  const V g2 = hn::IfThenElse(by_floor, hn::NegMulAdd(hn::Mul(p, p), r_bend, b),
                              hn::MulSub(r, b, hn::Mul(hn::Mul(a, a), r_bend)));
  const V inverse = hn::Div(one, g1);
  const V newton = hn::Neg(hn::Mul(g, inverse));
  // 1 − t + t² for Halley's 1/(1 + t): of the same order
  const V t = hn::Mul(hn::Mul(hn::Set(d, 0.5), newton), hn::Mul(g2, inverse));
  const V stretch = hn::Add(hn::MulSub(t, t, t), one);
  const V step = hn::Mul(newton, hn::Min(hn::Max(stretch, hn::Set(d, 0.5)), hn::Set(d, 2.0)));
  const V bounded =
      hn::Min(hn::Max(step, hn::Set(d, sharing_least_step)), hn::Set(d, sharing_greatest_step));
  const V rise = hn::Max(hn::Add(from.log_rise, bounded), zero);
  const auto is_near = hn::Lt(rise, hn::Set(d, sharing_near_rise));
  return {rise, hn::IfThenElse(is_near, flooded, from.film_parameter),
          hn::IfThenElse(is_near, rise, bounded),  // rise − log_rise, unrounded
          hn::Lt(hn::Mul(hn::Abs(newton), hn::Max(hn::Add(p, a), g1)), hn::Set(d, 0x1p-17))};
}

// λ = λ₀ hardly above a floor or below it: a jump, not a step.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_below_floor(D d, const Asperities<V>& at, const Iterate<V>& now) {
  const V near = hn::Set(d, sharing_pole_nearness);
  const V a = hn::Mul(at.hazard, now.film_parameter);
  return hn::And(hn::Ge(hn::MulAdd(a, at.share, hn::Mul(near, at.share)), near),
                 hn::Eq(now.log_rise, hn::Zero(d)));
}

// A vector of points to their roots; NaN where one is not there in max_sharing_steps. `steps` is of
// the slowest lane.
template <class V>
struct Roots {
  V film_parameter;
  int steps;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE Roots<V> roots_from(D d, Order order, const SharingInputs<V>& in, Iterate<V> now) {
  auto is_open = hn::Eq(in.flooded, in.flooded);
  V root = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
  for (int steps = 1; steps <= max_sharing_steps; ++steps) {
    const Asperities<V> at = asperities(d, order, in, now.film_parameter);
    const V w = film_share(d, now.log_rise);
    const Step<D> step = sharing_step(d, in.flooded, now, at, w, log_balance(d, at.share, w));
    const auto below = is_below_floor(d, at, now);
    now = {times_exp(d, step.base, step.shift), step.log_rise};
    auto arrives = hn::And(step.is_last, is_open);
    if (HWY_UNLIKELY(!hn::AllFalse(d, below))) {
      const Iterate<V> above = jump_above_floor(d, order, in, at);
      now.film_parameter = hn::IfThenElse(below, above.film_parameter, now.film_parameter);
      now.log_rise = hn::IfThenElse(below, above.log_rise, now.log_rise);
      arrives = hn::AndNot(below, arrives);
    }
    root = hn::IfThenElse(arrives, now.film_parameter, root);
    is_open = hn::AndNot(arrives, is_open);
    if (hn::AllFalse(d, is_open)) return {root, steps};
  }
  return {root, max_sharing_steps};
}

// e + 1 of 2^e ≤ x < 2^{e+1}.
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
