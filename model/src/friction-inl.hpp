// SPDX-License-Identifier: Apache-2.0
// Friction (friction.hpp) in double, once for each instruction set, for one lane and for vectors.
#include <hwy/highway.h>

#include "elementary-inl.hpp"
#include "tribo/contact_numbers.hpp"
#include "tribo/friction.hpp"

#if defined(TRIBO_FRICTION) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_FRICTION
#undef TRIBO_FRICTION
#else
#define TRIBO_FRICTION
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// ln(η/η₀) at pressure p ≥ 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log_viscosity_ratio(D d, ViscosityLaw law, const detail::ContactNumbers<V>& contact,
                                 V pressure) {
  if (law == ViscosityLaw::ambient) return hn::Zero(d);
  if (law == ViscosityLaw::barus) return hn::Mul(contact.pressure_viscosity, pressure);
  const V relative = hn::Div(pressure, hn::Set(d, roelands_pressure<double>()));
  const V log_pressure = logarithm_of_one_plus(d, relative);
  return hn::Mul(contact.roelands_scale,
                 exponential_less_one(d, hn::Mul(contact.roelands_exponent, log_pressure)));
}

// asinh x = ln(1 + x + x²/(1 + √(1 + x²))), 0 ≤ x < 2^53. SLEEF's asinh is hardly faster for
// vectors than for single numbers.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V inverse_hyperbolic_sine(D d, V x) {
  const V one = hn::Set(d, 1.0), square = hn::Mul(x, x);
  const V root = hn::Sqrt(hn::Add(one, square));
  return logarithm_of_one_plus(d, hn::Add(x, hn::Div(square, hn::Add(one, root))));
}

// τ/τ₀: the shear stress of a film over eyring_stress, at a separation > 0 in m and a sliding speed
// ≥ 0 in m/s.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V relative_shear_stress(D d, FluidShear law, const detail::ContactNumbers<V>& contact,
                                   V log_thickening, V sliding_speed, V separation) {
  const V zero = hn::Zero(d), most = hn::Set(d, 0x1p52);
  const V stress = contact.eyring_stress;
  V x = hn::Div(hn::Mul(hn::Div(contact.viscosity, stress), sliding_speed), separation);
  const auto is_ambient = hn::Eq(log_thickening, zero);
  if (!hn::AllTrue(d, is_ambient)) x = hn::Mul(x, exponential(d, log_thickening));
  V log_x = zero;
  const auto is_still = hn::Eq(sliding_speed, zero);
  const auto is_ordinary = hn::Or(hn::And(hn::Gt(x, zero), hn::Lt(x, most)), is_still);
  if (HWY_UNLIKELY(!hn::AllTrue(d, is_ordinary))) {  // a factor may be beyond double where x is not
    log_x = hn::Sub(hn::Add(hn::Sub(logarithm(d, contact.viscosity), logarithm(d, stress)),
                            logarithm(d, sliding_speed)),
                    hn::Sub(logarithm(d, separation), log_thickening));
    x = hn::IfThenElse(is_ordinary, x, exponential(d, log_x));
  }
  V relative;
  if (law == FluidShear::limiting) {
    relative = hn::Neg(exponential_less_one(d, hn::Neg(x)));
  } else {
    const auto is_moderate = hn::Lt(x, most);
    relative = inverse_hyperbolic_sine(d, hn::Min(x, most));
    if (HWY_UNLIKELY(!hn::AllTrue(d, is_moderate)))
      relative =
          hn::IfThenElse(is_moderate, relative, hn::Add(hn::Set(d, 0.69314718055994530942), log_x));
  }
  return hn::IfThenZeroElse(is_still, relative);
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
