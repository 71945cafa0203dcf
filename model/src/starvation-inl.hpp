// SPDX-License-Identifier: Apache-2.0
// The starved inlet (starvation.hpp) in double, once for each instruction set, for one lane and for
// vectors.
#include <hwy/highway.h>

#include "elementary-inl.hpp"
#include "stiffened_film-inl.hpp"
#include "tribo/solved_inlet.hpp"
#include "tribo/starvation.hpp"

#if defined(TRIBO_STARVATION) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_STARVATION
#undef TRIBO_STARVATION
#else
#define TRIBO_STARVATION
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

inline constexpr double linear_slope = 1.71887338539246962630;  // κ = 5.4/π; short inlets: y = κψ
inline constexpr double linear_slope_power = 1.9681348835114139;  // κ^{5/4}

// y(ψ) = (2/π) arctan(2.7ψ)
template <class D, class V = hn::Vec<D>>
HWY_INLINE V wolveridge_film_ratio(D d, V inlet_length) {
  return hn::Mul(hn::Set(d, two_over_pi<double>()),
                 arc_tangent(d, hn::Mul(hn::Set(d, wolveridge_factor<double>()), inlet_length)));
}

// 1/r at ψ = x², and its slope d ln(1/r)/d ln x.
template <class V>
struct InverseRatio {
  V value, slope;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE InverseRatio<V> inverse_ratio(D d, StarvationClosure closure, V x) {
  const V one = hn::Set(d, 1.0), two = hn::Set(d, 2.0), three = hn::Set(d, 3.0);
  const V psi = hn::Mul(x, x), v = hn::Mul(hn::Set(d, wolveridge_factor<double>()), psi);
  const V angle = arc_tangent(d, v);
  const V y = hn::Mul(hn::Set(d, two_over_pi<double>()), angle);
  const V y_slope = hn::IfThenElse(hn::Lt(v, hn::Set(d, 1e-100)), two,
                                   hn::Div(hn::Add(v, v), hn::Mul(hn::MulAdd(v, v, one), angle)));
  V term = hn::Div(hn::Mul(psi, x), hn::Set(d, crook_constant<double>())), term_slope = three;
  if (closure == StarvationClosure::printed_exponents) {
    term = hn::Div(term, hn::Mul(y, hn::Sqrt(hn::Sqrt(y))));
    term_slope = hn::NegMulAdd(hn::Set(d, 1.25), y_slope, three);
  }
  const V value = hn::Add(y, term);
  return {value, hn::Div(hn::MulAdd(y, y_slope, hn::Mul(term, term_slope)), value)};
}

// √ψ of an implicit closure at 1/r = g, by multiplicative steps of Halley's kind. They are of third
// order for a power of x, and 1/r is nearly such a power. The start is the root for the greater of
// the two terms of 1/r alone.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V root_of_inlet_length(D d, StarvationClosure closure, V g) {
  const V one = hn::Set(d, 1.0);
  const V long_inlet =
      decimal_power(d, hn::Mul(hn::Set(d, crook_constant<double>()), g), Fraction{1, 3});
  V short_inlet;
  if (closure == StarvationClosure::printed_exponents) {
    const V root =
        hn::Mul(hn::Set(d, crook_constant<double>() * linear_slope_power), g);  // c κ^{5/4} g
    short_inlet = hn::Mul(root, root);
  } else {
    short_inlet = hn::Sqrt(hn::Div(g, hn::Set(d, linear_slope)));
  }
  V x = hn::Min(long_inlet, short_inlet);
  // Where x³ or the inverse power of y comes near an overflow, one term of 1/r is the sum of both
  // to every digit.
  auto is_open = hn::And(hn::Gt(x, hn::Set(d, 1e-40)), hn::Lt(x, hn::Set(d, 1e90)));
  for (int steps = 0; steps < 30 && !hn::AllFalse(d, is_open); ++steps) {
    const InverseRatio<V> at = inverse_ratio(d, closure, x);
    // x(1 + change), change = 2(g − f)/((s+1)f + (s−1)g)
    const V s = at.slope;
    const V below = hn::MulAdd(hn::Add(s, one), at.value, hn::Mul(hn::Sub(s, one), g));
    const V change = hn::Div(hn::Mul(hn::Set(d, 2.0), hn::Sub(g, at.value)), below);
    const V bounded = hn::Min(hn::Max(change, hn::Set(d, -0.75)), hn::Set(d, 3.0));
    x = hn::IfThenElse(is_open, hn::MulAdd(x, bounded, x), x);
    is_open = hn::And(is_open, hn::Gt(hn::Abs(change), hn::Set(d, 1e-8)));
  }
  return x;
}

// ψ at r > 0; flooded_inlet needs r < 1, too.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V inlet_length(D d, StarvationClosure closure, V r) {
  const V one = hn::Set(d, 1.0);
  if (closure == StarvationClosure::flooded_inlet)
    return decimal_power(d,
                         hn::Mul(hn::Div(hn::Sub(one, r), r), hn::Set(d, crook_constant<double>())),
                         Fraction{2, 3});
  const V root = root_of_inlet_length(d, closure, hn::Div(one, r));
  return hn::Mul(root, root);
}

// The effect of the inlet on the flooded film: y, 1 − y without cancellation, and whether the film
// has collapsed.
template <class D>
struct Starvation {
  hn::Vec<D> film_ratio, deficit;
  hn::Mask<D> is_collapsed;
};

// Damiens' y = (1 + r^γ)^{−1/γ}.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Starvation<D> damiens(D d, V r, V exponent, bool needs_deficit) {
  const V one = hn::Set(d, 1.0);
  const auto is_starved = hn::Gt(r, one);
  const V small = hn::IfThenElse(is_starved, hn::Div(one, r), r);
  const V power = exponential(d, hn::Mul(exponent, logarithm(d, small)));
  const V log_ratio = hn::Neg(hn::Div(logarithm_of_one_plus(d, power), exponent));
  const V ratio = exponential(d, log_ratio);
  Starvation<D> state{hn::IfThenElse(is_starved, hn::Div(ratio, r), ratio), hn::Zero(d),
                      hn::Lt(one, hn::Zero(d))};
  if (needs_deficit)
    state.deficit = hn::IfThenElse(is_starved, hn::Sub(one, state.film_ratio),
                                   hn::Neg(exponential_less_one(d, log_ratio)));
  return state;
}

// At r = h_ff/h_oil > 0: the effect of the inlet by a law.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Starvation<D> starvation(D d, const InletLaw<V>& law, V r, bool needs_deficit) {
  const StarvationClosure closure = law.closure;
  if (closure == StarvationClosure::damiens) return damiens(d, r, law.exponent, needs_deficit);
  const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
  auto collapsed = hn::Lt(one, zero);
  if (closure == StarvationClosure::flooded_inlet) collapsed = hn::Ge(r, one);
  const V psi = inlet_length(d, closure, hn::IfThenElse(collapsed, one, r));
  Starvation<D> state{hn::IfThenZeroElse(collapsed, wolveridge_film_ratio(d, psi)), zero,
                      collapsed};
  if (needs_deficit) {
    const V inverse = hn::Div(one, hn::Mul(hn::Set(d, wolveridge_factor<double>()), psi));
    state.deficit = hn::IfThenElse(
        collapsed, one, hn::Mul(hn::Set(d, two_over_pi<double>()), arc_tangent(d, inverse)));
  }
  return state;
}

// γ from the table of solved starved films (solved_inlet.hpp); NaN where M or L is beyond it.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V solved_inlet_exponent(D d, const InletTable& table, V log_load, V material,
                                   V log_ratio) {
  const auto within = [&](V at, double low, double high) HWY_ATTR {
    return hn::Min(hn::Max(at, hn::Set(d, low)), hn::Set(d, high));
  };
  const V x = within(log_load, table.first_load, table.last_load());
  const V y = within(material, table.first_material, table.last_material());
  const V z = within(log_ratio, table.first_ratio, table.last_ratio());
  const auto steps = [&](V at, double first, double step) HWY_ATTR {
    return hn::Mul(hn::Sub(at, hn::Set(d, first)), hn::Set(d, 1 / step));
  };
  const V in_load = steps(x, table.first_load, table.load_step),
          in_material = steps(y, table.first_material, table.material_step),
          in_ratio = steps(z, table.first_ratio, table.ratio_step);
  const V i = step_of(d, in_load, table.load_steps);
  const V j = step_of(d, in_material, table.material_steps);
  const V k = step_of(d, in_ratio, table.ratio_steps);
  const auto whole = [&](std::size_t n) HWY_ATTR { return hn::Set(d, static_cast<double>(n)); };
  const auto index = whole_number(
      d, hn::MulAdd(hn::MulAdd(i, whole(table.material_steps), j), whole(table.ratio_steps), k));
  const auto between = [&](V part, V low, V high)
                           HWY_ATTR { return hn::MulAdd(hn::Sub(high, low), part, low); };
  const auto at_load = [&](Integers<D> row) HWY_ATTR {
    V g[4];
    load_rows(d, table.nodes[0], row, g);
    const V part = hn::Sub(in_ratio, k);
    return between(hn::Sub(in_material, j), between(part, g[0], g[1]), between(part, g[2], g[3]));
  };
  const hn::RebindToUnsigned<D> bits;
  const auto next =
      hn::Add(index, hn::Set(bits, std::uint64_t{table.material_steps * table.ratio_steps}));
  const V exponent = between(hn::Sub(in_load, i), at_load(index), at_load(next));
  const auto is_known = hn::And(hn::Eq(x, log_load), hn::Eq(y, material));
  return hn::IfThenElse(is_known, exponent, hn::Set(d, std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
