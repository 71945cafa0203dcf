// SPDX-License-Identifier: Apache-2.0
// Load shares and floors (load_sharing.hpp) in double, once for each instruction set, for one lane
// and for vectors of points.
#include <hwy/highway.h>

#include "contact_numbers-inl.hpp"
#include "load_sharing-inl.hpp"
#include "tribo/load_sharing.hpp"

#if defined(TRIBO_LOAD_SHARES) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_LOAD_SHARES
#undef TRIBO_LOAD_SHARES
#else
#define TRIBO_LOAD_SHARES
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

template <class V>
struct Shares {
  V asperity;  // A
  V fluid;     // 1 − A, without the cancellation
};

// A = (K F_p(d))^q, not clipped at 1.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V share_at(D d, Order order, V stiffness, V argument) {
  const bool is_root = order == Order::five_halves;
  const V product = hn::Mul(stiffness, scaled_moment_of(d, order, argument));
  const V at_zero = is_root ? hn::Sqrt(product) : product;
  const auto above_zero = hn::Gt(argument, hn::Zero(d));
  if (hn::AllFalse(d, above_zero)) return at_zero;
  // From this limit on A is set to 0: it is below 1e-300 there, whatever K is.
  const V limit = hn::Set(d, is_root ? 75.0 : 53.0);
  const V value = times_gaussian(d, Sum<V>{at_zero, hn::Zero(d)}, hn::Min(hn::Abs(argument), limit),
                                 is_root ? 0.25 : 0.5);
  const V above = hn::IfThenElseZero(hn::Lt(argument, limit), value);
  return hn::IfThenElse(above_zero, above, at_zero);
}

// ln(x/y): for x/y > 1/2 it is ln(1 + (x − y)/y), else the logarithm of the rounded quotient.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log_ratio(D d, V x, V y) {
  const V difference = hn::Div(hn::Sub(x, y), y);
  const auto is_near = hn::Gt(difference, hn::Set(d, -0.5));
  if (hn::AllTrue(d, is_near)) return logarithm_of_one_plus(d, difference);
  const V far = logarithm(d, hn::Div(x, y));
  if (hn::AllFalse(d, is_near)) return far;
  return hn::IfThenElse(is_near, logarithm_of_one_plus(d, difference), far);
}

template <class D, class V>
HWY_INLINE Shares<V> shares_above_floor(D d, Order order, const detail::SurfaceNumbers<V>& surface,
                                        V distance);

// The shares at λ = max(λ₀, λ_b), for a law with e = a − b = 0. The function is not inlined, so
// that the kernels of other laws keep their registers.
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE Shares<V> shares_without_exponent(D d, Order order,
                                               const detail::SurfaceNumbers<V>& surface,
                                               const V& flooded) {
  const V distance = hn::Sub(flooded, surface.floor);
  const auto is_above = hn::Or(hn::Gt(distance, hn::Zero(d)), hn::Le(surface.hazard, hn::Zero(d)));
  const Shares<V> above =
      shares_above_floor(d, order, surface, hn::IfThenElseZero(is_above, distance));
  return {hn::IfThenElse(is_above, above.asperity, hn::Set(d, 1.0)),
          hn::IfThenElseZero(is_above, above.fluid)};
}

// Is A more exact from 1 − A, the film's share of the load, than from the rounded λ? Yes, above a
// floor higher than 3, where q(λ − δ)λ is more than `least` times (1 − A)/A: an ulp of λ moves A by
// −d ln A/d ln λ ≥ q(λ − δ)λ ulp. Above lower floors it moves A by a few ulp at most.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_stiff(D d, Order order, const detail::SurfaceNumbers<V>& surface,
                                V lambda, const Shares<V>& shares, double least) {
  const auto is_high = hn::Gt(surface.floor, hn::Set(d, 3.0));
  if (HWY_LIKELY(hn::AllFalse(d, is_high))) return is_high;
  const V q_lambda = hn::Mul(lambda, hn::Set(d, order == Order::five_halves ? 0.5 : 1.0));
  const V moves = hn::Mul(hn::Mul(q_lambda, hn::Sub(lambda, surface.offset)), shares.asperity);
  // Where λ is above twice the floor, A is negligible.
  return hn::And(hn::And(is_high, hn::Lt(lambda, hn::Add(surface.floor, surface.floor))),
                 hn::Gt(moves, hn::Mul(shares.fluid, hn::Set(d, least))));
}

// The shares at the root λ for λ₀: 1 − A = (λ₀/λ)^{1/e}, e = a − b. An ulp of λ moves this 1 − A by
// 1/e ulp. A is computed from it where it is below 1/2 or the film is stiff (is_stiff()), else from
// λ. For e = 0 the shares are those at the greater of λ₀ and the floor.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Shares<V> shares_at_root(D d, Order order, const FilmLaw& law,
                                    const detail::SurfaceNumbers<V>& surface, V flooded, V lambda) {
  const V one = hn::Set(d, 1.0), exponent = hn::Set(d, law.sharing_power.value);
  if (law.sharing_exponent.p == 0) [[unlikely]]
    return shares_without_exponent(d, order, surface, flooded);
  const V log_film = log_ratio(d, flooded, lambda);
  const V log_fluid = hn::Div(log_film, exponent);
  // `correction` takes off the errors of the quotient and of e, which grow with the logarithm.
  const Sum<V> exact = product(d, log_fluid, exponent);
  const V short_of = hn::Sub(hn::Sub(hn::Sub(log_film, exact.high), exact.low),
                             hn::Mul(log_fluid, hn::Set(d, law.sharing_power.residual)));
  const V rough = exponential(d, log_fluid);
  const V correction = hn::Mul(rough, hn::Div(short_of, exponent));
  // The correction is left out where it is NaN or not small, as for λ₀ = λ = 0.
  const V fluid =
      hn::IfThenElse(hn::Lt(hn::Abs(correction), one), hn::Add(rough, correction), rough);
  const V asperity = hn::Sub(one, fluid);
  auto by_film = hn::Lt(fluid, hn::Set(d, 0.5));
  if (hn::AllTrue(d, by_film)) return {asperity, fluid};
  by_film = hn::Or(
      by_film, is_stiff(d, order, surface, lambda, {asperity, fluid}, law.sharing_power.inverse));
  return {hn::IfThenElse(by_film, asperity,
                         share_at(d, order, surface.stiffness, hn::Sub(lambda, surface.offset))),
          fluid};
}

inline constexpr int floor_terms = 32;  // of FloorSeries
struct FloorFactors {
  double of_earlier[floor_terms], of_sum[floor_terms];  // (p−k)/(k+1) and 1/(k+2)
};
constexpr FloorFactors floor_factors(double p) {
  FloorFactors factors{};
  for (int k = 0; k < floor_terms; ++k) {
    factors.of_earlier[k] = (p - k) / (k + 1);
    factors.of_sum[k] = 1.0 / (k + 2);
  }
  return factors;
}
inline constexpr FloorFactors floor_factors_5_2 = floor_factors(2.5);
inline constexpr FloorFactors floor_factors_3_2 = floor_factors(1.5);

// The Taylor series Σ c_k x^k of F_p(d_b + x)/F_p(d_b) − 1 at a distance x above a floor. From
// F″ = pF − dF′ follows (k+1)(k+2) c_{k+2} = (p−k) c_k − (k+1) d_b c_{k+1}. Used for A ≥ 3/4 and
// d_b x ≥ −4. There 32 terms are enough, because |F_p(d_b + z)| ≤ F_p(d_b − ρ)e^{ρ²/2} for |z| = ρ.
template <class D>
class FloorSeries {
 public:
  using V = hn::Vec<D>;

  HWY_INLINE FloorSeries(D d, Order order, const detail::SurfaceNumbers<V>& surface) : d_(d) {
    const FloorFactors& factors =
        order == Order::five_halves ? floor_factors_5_2 : floor_factors_3_2;
    V earlier = hn::Set(d, 1.0);
    V current = hn::Mul(surface.hazard, hn::Set(d, order == Order::five_halves ? -2.0 : -1.0));
    for (int k = 0; k < floor_terms; ++k) {
      c_[k] = current;
      const V next = hn::Mul(hn::Sub(hn::Mul(earlier, hn::Set(d, factors.of_earlier[k])),
                                     hn::Mul(surface.floor_argument, current)),
                             hn::Set(d, factors.of_sum[k]));
      earlier = current;
      current = next;
    }
  }

  struct Change {
    V value, slope;
  };
  HWY_INLINE Change change(V x) const {
    V sum = c_[floor_terms - 1], slope = hn::Zero(d_);
    for (int k = floor_terms - 2; k >= 0; --k) {
      slope = hn::MulAdd(slope, x, sum);
      sum = hn::MulAdd(sum, x, c_[k]);
    }
    return {hn::Mul(sum, x), hn::MulAdd(slope, x, sum)};
  }

 private:
  D d_;
  V c_[floor_terms];
};

// 1 − A at a distance x above the floor, for A ≥ 3/4 and d_b x ≥ −4.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V fluid_near_floor(D d, Order order, const FloorSeries<D>& series, V distance) {
  const V less = hn::Neg(series.change(distance).value);
  if (order != Order::five_halves) return less;
  // 1 − √(1 − less)
  const V one = hn::Set(d, 1.0);
  return hn::Div(less, hn::Add(one, hn::Sqrt(hn::Sub(one, less))));
}

// The distance above the floor at which the fluid carries the share w < 1/4. 1 − A is concave
// there, so that Newton's method approaches this distance from below.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V distance_above_floor(D d, Order order, const FloorSeries<D>& series, V hazard, V w) {
  V change = hn::Neg(w);
  if (order == Order::five_halves) change = hn::Mul(change, hn::Sub(hn::Set(d, 2.0), w));
  const double doubled = order == Order::five_halves ? 2 : 1;
  V x = hn::Neg(hn::Div(change, hn::Mul(hazard, hn::Set(d, doubled))));
  auto is_open = hn::And(hn::Gt(x, hn::Zero(d)), hn::Gt(hazard, hn::Zero(d)));
  for (int steps = 0; steps < 12 && !hn::AllFalse(d, is_open); ++steps) {
    const auto there = series.change(x);
    const V step = hn::Div(hn::Sub(change, there.value), there.slope);
    x = hn::IfThenElse(is_open, hn::Add(x, step), x);
    is_open = hn::And(is_open, hn::Gt(hn::Abs(step), hn::Mul(x, hn::Set(d, 0x1p-50))));
  }
  return x;
}

// The shares at a distance above the floor, λ = λ_b + distance; λ_b = 0 where there is no floor.
// Near a floor 1 − A comes from the Taylor series, so that no digits cancel.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Shares<V> shares_above_floor(D d, Order order, const detail::SurfaceNumbers<V>& surface,
                                        V distance) {
  const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
  const auto has_floor = hn::Gt(surface.hazard, zero);
  const V argument = hn::IfThenElse(has_floor, hn::Add(surface.floor_argument, distance),
                                    hn::Sub(distance, surface.offset));
  const V asperity = share_at(d, order, surface.stiffness, argument);
  const V rest = hn::Sub(one, asperity);
  Shares<V> shares{asperity, hn::IfThenZeroElse(hn::Lt(rest, zero), rest)};
  const auto is_near = hn::And(hn::And(has_floor, hn::Ge(asperity, hn::Set(d, 0.75))),
                               hn::Ge(hn::Mul(surface.floor_argument, distance), hn::Set(d, -4.0)));
  if (hn::AllFalse(d, is_near)) return shares;
  const V fluid = fluid_near_floor(d, order, FloorSeries<D>(d, order, surface), distance);
  return {hn::IfThenElse(is_near, hn::Sub(one, fluid), shares.asperity),
          hn::IfThenElse(is_near, fluid, shares.fluid)};
}

// The numbers of a surface without those of its floor.
template <class D, class V = hn::Vec<D>>
HWY_INLINE detail::SurfaceNumbers<V> surface_without_floor(D d, const FilmLaw& law, V stiffness,
                                                           V offset, V film_at_unit_speed) {
  const V zero = hn::Zero(d);
  const V square = hn::MulAdd(exponent_plus_one(d, stiffness), hn::Set(d, free_square_slope),
                              hn::Set(d, free_square_of(law.sharing_power.value)));
  const V film_from = hn::Add(offset, hn::Sqrt(hn::Max(square, zero)));
  return {stiffness, offset, zero, zero, zero, zero, film_from, film_at_unit_speed};
}

// The numbers of a surface with its floor λ_b, where A = 1. ln A is concave and decreasing: steps
// of third order go to its zero from the right. K and δ have to be in the kernels' range.
template <class D, class V = hn::Vec<D>>
HWY_INLINE detail::SurfaceNumbers<V> surface_of(D d, Order order, const FilmLaw& law, V stiffness,
                                                V offset, V film_at_unit_speed) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
  const bool is_root = order == Order::five_halves;
  const V q = hn::Set(d, is_root ? 0.5 : 1.0), n = hn::Set(d, 0.5 * twice(order));
  const V lowest = hn::Neg(offset);
  auto surface = surface_without_floor(d, law, stiffness, offset, film_at_unit_speed);
  const auto has_floor = hn::Ge(hn::Mul(stiffness, moment_of(d, order, lowest)), one);
  if (hn::AllFalse(d, has_floor)) {
    if (law.sharing_exponent.p == 0) [[unlikely]]
      surface.film_from = zero;
    return surface;
  }
  // The start follows from F_p(x) ≤ F_p(0) e^{−x²/2} for x ≥ 0.
  const V at_zero = hn::Mul(stiffness, hn::Set(d, sharing_moment_at_zero(order)));
  V x = hn::Sqrt(hn::Mul(hn::Set(d, 2.0), logarithm(d, hn::Max(at_zero, one))));
  // h = −d ln F/dx
  const auto hazard_at = [&](V at) HWY_ATTR {
    const auto below_zero = hn::Lt(at, zero);
    const V log_slope =
        moment_and_log_slope(d, order, below_zero, distance_in_pieces(d, at)).log_slope;
    return hn::IfThenElse(below_zero, log_slope, hn::Sub(hn::Abs(at), log_slope));
  };
  auto is_open = has_floor;
  for (int steps = 0; steps < 60 && !hn::AllFalse(d, is_open); ++steps) {
    const V log_share = logarithm(d, hn::Mul(stiffness, moment_of(d, order, x)));  // of A^{1/q}
    const V h = hazard_at(x);
    const V slope = hn::Sub(hn::Mul(h, hn::Sub(h, x)), n);  // h′ = h² − xh − n
    const V newton = hn::Div(log_share, h);
    const V bend = hn::MulAdd(hn::Mul(half, hn::Div(newton, h)), slope, one);
    const V step = hn::Div(newton, hn::Max(bend, half));
    x = hn::IfThenElse(is_open, hn::Max(hn::Add(x, step), lowest), x);
    is_open = hn::And(is_open, hn::Gt(hn::Mul(h, hn::Abs(step)), hn::Set(d, 1e-6)));
  }
  surface.floor_argument = hn::IfThenElseZero(has_floor, x);
  surface.floor = hn::IfThenElseZero(has_floor, hn::Add(offset, x));
  surface.hazard = hn::IfThenElseZero(has_floor, hn::Mul(q, hazard_at(x)));
  // ln A is concave: above the floor A ≤ e^{−h(λ−λ_b)}, λ − λ_b ≤ −ln(1 − (λ₀/λ_b)^{1/e})/h.
  const V part = hn::Mul(hn::Set(d, 0.99 * 0x1p-54), hn::Mul(surface.hazard, surface.floor));
  if (law.sharing_exponent.p == 0) [[unlikely]] {  // λ is the greater of λ₀ and the floor
    surface.floor_up_to = surface.film_from = surface.floor;
    return surface;
  }
  surface.floor_up_to = hn::Mul(surface.floor, decimal_power(d, part, law.sharing_power));
  return surface;
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
