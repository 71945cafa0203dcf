// SPDX-License-Identifier: Apache-2.0
// Whole operating points (mixed_contact.hpp) in double, once for each instruction set, for one lane
// and for vectors: λ₀ → λ → inlet → shares, area, count, friction. Only what is asked is computed.
#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "engine.hpp"
#include "friction-inl.hpp"
#include "load_sharing_batch-inl.hpp"
#include "starvation-inl.hpp"
#include "stiffened_roots-inl.hpp"
#include "tribo/mixed_contact.hpp"

#if defined(TRIBO_OPERATING_POINT) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_OPERATING_POINT
#undef TRIBO_OPERATING_POINT
#else
#define TRIBO_OPERATING_POINT
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// The flooded film with its load shares, where they are needed.
template <class V>
struct Flooded {
  V speed, film_parameter;  // u, λ
  Shares<V> shares;         // A(λ), 1 − A(λ)
};

// λ₀ at a speed, from λ₀/u^a and a; NaN where the contact or the speed is beyond the kernels'
// range.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V flooded_film_parameter(D d, V film_at_unit_speed, const Exponent& a, V speed) {
  const V film = hn::Mul(film_at_unit_speed, decimal_power(d, speed, a));
  const auto is_within =
      hn::And(hn::Ge(speed, hn::Set(d, least_speed)), hn::Le(speed, hn::Set(d, greatest_speed)));
  return hn::IfThenElse(is_within, film, hn::Set(d, std::numeric_limits<double>::quiet_NaN()));
}

// h_oil/σ_s
template <class V>
HWY_INLINE V inlet_film_parameter(SupplyKind supply, const detail::ContactNumbers<V>& contact,
                                  V speed) {
  if (supply == SupplyKind::inlet_film_ratio) return contact.supply;
  const V film = supply == SupplyKind::inlet_flow ? hn::Div(contact.supply, speed) : contact.supply;
  return hn::Div(film, contact.summit_height_sd);
}

// The inlet's effect on a film of r = h_ff/h_oil at a speed.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Starvation<D> starvation(D d, const detail::ContactWords& words,
                                    const detail::ContactNumbers<V>& contact, V speed, V r,
                                    bool needs_deficit) {
  if (words.closure != StarvationClosure::solved)
    return starvation(d, inlet_law(words, contact), r, needs_deficit);
  const V s = log_speed_of(d, speed);
  const V log_load = hn::NegMulAdd(s, hn::Set(d, 0.75), contact.film.rigid);
  const V material = hn::Mul(contact.film.elastic, exponential(d, hn::Mul(s, hn::Set(d, 0.25))));
  const V exponent = solved_inlet_exponent(d, inlet_table(), log_load, material, logarithm(d, r));
  const auto is_known = hn::Eq(exponent, exponent);
  Starvation<D> state =
      damiens(d, r, hn::IfThenElse(is_known, exponent, hn::Set(d, 1.0)), needs_deficit);
  const V nan = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
  state.film_ratio = hn::IfThenElse(is_known, state.film_ratio, nan);
  state.deficit = hn::IfThenElse(is_known, state.deficit, nan);
  return state;
}

// The inlet's effect on a film, and r = h_ff/h_oil.
template <class D>
struct InletLanes {
  Starvation<D> starvation;
  hn::Vec<D> flooded_over_inlet;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE InletLanes<D> inlet_of(D d, const detail::ContactWords& words,
                                  const detail::ContactNumbers<V>& contact, V speed,
                                  V film_parameter, bool needs_deficit) {
  const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
  if (words.supply == SupplyKind::flooded) return {{one, zero, hn::Lt(one, zero)}, zero};
  const V r = hn::Div(film_parameter, inlet_film_parameter(words.supply, contact, speed));
  return {starvation(d, words, contact, speed, r, needs_deficit), r};
}

// From this value of q(λ − δ)λ A/(1 − A) on, moments and starved shares follow from A, not from the
// rounded λ. An ulp of λ moves A by a = −d ln A/d ln λ ulp. The condition number of A is at least
// a/(1 + e a A/(1 − A)). Up to this value a is 1 + 6e times that, 5 times for soft bodies.
inline constexpr double stiff_film = 6;

// A at the film λ − `fall`, from A at λ; `argument` is d = λ − δ ≥ 0. With d* = d − `fall` the
// ratio of the two F_p is known to more digits than each F_p, because d² − d*² = `fall`·(d + d*).
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE V share_below(D d, Order order, const V& asperity, const V& argument, const V& fall) {
  const V less = hn::Min(fall, argument), lower = hn::Sub(argument, less);
  const bool is_root = order == Order::five_halves;
  const V gain = hn::Mul(hn::Mul(less, hn::Set(d, is_root ? 0.25 : 0.5)), hn::Add(argument, lower));
  const V ratio = hn::Div(scaled_moment_of(d, order, lower), scaled_moment_of(d, order, argument));
  return hn::Mul(hn::Mul(asperity, exponential(d, gain)), is_root ? hn::Sqrt(ratio) : ratio);
}

// The shares at the starved film λ*: A(λ*), or 1 at the floor and below. Near a floor λ* − λ_b is
// the distance of the flooded film from the floor, computed from its fluid share, minus λ(1 − y).
// This avoids a difference of nearly equal numbers.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Shares<V> starved_shares(D d, Order order, const detail::SurfaceNumbers<V>& surface,
                                    const Flooded<V>& flooded, const Starvation<D>& inlet,
                                    V starved_film) {
  const V zero = hn::Zero(d);
  const auto has_floor = hn::Gt(surface.hazard, zero);
  V distance = hn::Sub(starved_film, surface.floor);
  const auto is_near = hn::And(has_floor, hn::Lt(flooded.shares.fluid, hn::Set(d, 0.25)));
  if (!hn::AllFalse(d, is_near)) {
    const FloorSeries<D> series(d, order, surface);
    const V w = hn::IfThenElseZero(is_near, flooded.shares.fluid);
    const V flooded_distance = distance_above_floor(d, order, series, surface.hazard, w);
    const auto by_series = hn::And(
        is_near, hn::Ge(hn::Mul(surface.floor_argument, flooded_distance), hn::Set(d, -4.0)));
    const V exact = hn::Sub(flooded_distance, hn::Mul(flooded.film_parameter, inlet.deficit));
    distance = hn::IfThenElse(by_series, exact, distance);
  }
  const auto is_on_floor = hn::AndNot(hn::Gt(distance, zero), has_floor);
  Shares<V> shares =
      shares_above_floor(d, order, surface, hn::IfThenZeroElse(is_on_floor, distance));
  shares.asperity = hn::IfThenElse(is_on_floor, hn::Set(d, 1.0), shares.asperity);
  shares.fluid = hn::IfThenZeroElse(is_on_floor, shares.fluid);
  // Farther from a high floor A(λ*) follows from A(λ).
  auto by_share = is_stiff(d, order, surface, flooded.film_parameter, flooded.shares, stiff_film);
  if (HWY_LIKELY(hn::AllFalse(d, by_share))) return shares;
  by_share = hn::AndNot(is_near, by_share);
  const V of = flooded.shares.asperity;  // a copy, so that the others stay in registers
  const V asperity = share_below(d, order, of, hn::Sub(flooded.film_parameter, surface.offset),
                                 hn::Mul(flooded.film_parameter, inlet.deficit));
  const auto is_above = hn::Lt(asperity, hn::Set(d, 1.0));
  const V rest = hn::IfThenElseZero(is_above, hn::Sub(hn::Set(d, 1.0), asperity));
  return {hn::IfThenElse(by_share, hn::IfThenElse(is_above, asperity, hn::Set(d, 1.0)),
                         shares.asperity),
          hn::IfThenElse(by_share, rest, shares.fluid)};
}

// factor · F_n(λ − δ). ln F_n falls as (λ − δ)²/2, so that the rounding of λ moves F_n by up to
// λ²/2 ulp: a few at a floor of 3, dozens at higher ones. In the lanes of by_share F_n follows from
// A (`share`), which is more exact than λ: F_p is A^{1/q}/K, and F_n/F_p hardly depends on d.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V moment_at(D d, Order load, Order n, const detail::SurfaceNumbers<V>& surface, V factor,
                       V film_parameter, V share, hn::Mask<D> by_share) {
  const V argument = hn::Sub(film_parameter, surface.offset);
  const auto below_zero = hn::Lt(argument, hn::Zero(d));
  const V scaled = hn::Mul(factor, scaled_moment_of(d, n, argument));
  V value = scaled;
  if (!hn::AllTrue(d, below_zero)) {
    const V limit = hn::Set(d, 40.0);
    const V above =
        times_gaussian(d, Sum<V>{scaled, hn::Zero(d)}, hn::Min(hn::Abs(argument), limit));
    value = hn::IfThenElse(below_zero, scaled, hn::IfThenElseZero(hn::Lt(argument, limit), above));
  }
  if (HWY_LIKELY(hn::AllFalse(d, by_share))) return value;
  const V of_load = load == Order::five_halves ? hn::Mul(share, share) : share;
  const V ratio = hn::Div(scaled_moment_of(d, n, argument), scaled_moment_of(d, load, argument));
  return hn::IfThenElse(
      by_share, hn::Mul(hn::Mul(factor, hn::Div(of_load, surface.stiffness)), ratio), value);
}

// Is A < 2^−54, half an ulp of 1 − A? At film_from a bound of A is 2^−54/e, e = a − b. Beyond
// film_from this bound falls as e^{−d²/4}, d = λ − δ.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_free_of_asperities(D d, const FilmLaw& law,
                                             const detail::SurfaceNumbers<V>& surface, V film) {
  if (law.sharing_exponent.p == 0) [[unlikely]]
    return hn::Lt(film, film);  // film_from tells nothing of A
  const V x = hn::Sub(film, surface.offset), limit = hn::Sub(surface.film_from, surface.offset);
  const V beyond =
      hn::MulAdd(limit, limit, hn::Set(d, square_beyond_free(law.sharing_power.value)));
  return hn::And(hn::Gt(x, hn::Zero(d)), hn::Gt(hn::Mul(x, x), beyond));
}

// The parts of the computation that a set of outputs needs.
struct NeededParts {
  explicit NeededParts(OutputSet outputs, SupplyKind supply)
      : is_starved(supply != SupplyKind::flooded),
        inlet(!(outputs == of({Output::film_flooded}))),
        area(outputs.contains_any(of({Output::real_area_ratio, Output::friction}))),
        count(outputs.contains(Output::summit_count)),
        sharing(outputs.contains_any(balance_outputs())),
        exact_share(area || count || outputs.contains(Output::asperity_load_share)) {}

  static constexpr OutputSet of(std::initializer_list<Output> outputs) {
    OutputSet set;
    for (const Output output : outputs) set.insert(output);
    return set;
  }

  bool is_starved, inlet, area, count, sharing, exact_share;
};

// Adds a mask's lanes to a count of work, where work is counted.
template <class D, class Counter>
HWY_INLINE void count_lanes([[maybe_unused]] D d, [[maybe_unused]] Counter& work,
                            [[maybe_unused]] Work what, [[maybe_unused]] hn::Mask<D> lanes) {
  if constexpr (Counter::counts) work.add(what, hn::CountTrue(d, lanes));
}

// Stores codes from 0 to 255 as the words of an enumeration.
template <class D, class Word>
HWY_INLINE void store_words(D, hn::Vec<D> codes, Word* to, std::size_t count) {
  static_assert(sizeof(Word) == 1);
  const hn::Rebind<std::int32_t, D> integers;
  const hn::Rebind<std::uint8_t, D> bytes;
  const auto words = hn::DemoteTo(bytes, hn::DemoteTo(integers, codes));
  auto* const first = reinterpret_cast<std::uint8_t*>(to);
  if (count >= hn::Lanes(bytes)) return hn::StoreU(words, bytes, first);
  HWY_ALIGN std::uint8_t buffer[hn::MaxLanes(bytes)];
  hn::Store(words, bytes, buffer);
  std::copy_n(buffer, count, first);
}

// Computes the outputs of a vector of points from a known film and inlet, and writes the first
// `count` of them to `to` from point i on.
template <class D, class Counter, class V = hn::Vec<D>>
HWY_INLINE void complete(D d, const detail::ContactWords& words,
                         const detail::ContactNumbers<V>& contact, const NeededParts& needs,
                         bool needs_shares, const Flooded<V>& flooded, const Starvation<D>& inlet,
                         const detail::Destination& to, std::size_t i, std::size_t count,
                         Counter& work) {
  const Order order = load_order(words.model);
  const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
  const auto& surface = contact.surface;
  const auto present = hn::FirstN(d, count);
  const auto add = [&](Work what, hn::Mask<D> lanes)
                       HWY_ATTR { count_lanes(d, work, what, hn::And(lanes, present)); };
  const auto put = [&](Output output, V value) HWY_ATTR {
    double* const array = to.numbers[static_cast<std::size_t>(output)];
    if (array != nullptr) store(d, value, array + i, count);
  };
  const V lambda = hn::Mul(flooded.film_parameter, inlet.film_ratio);
  const V apart = hn::IfThenElse(hn::Lt(lambda, surface.floor), surface.floor, lambda);
  put(Output::film_flooded, hn::Mul(flooded.film_parameter, contact.summit_height_sd));
  put(Output::film, hn::Mul(lambda, contact.summit_height_sd));
  put(Output::separation, hn::Mul(apart, contact.summit_height_sd));
  put(Output::film_parameter, lambda);
  if (to.inlet != nullptr) {
    const auto is_flooded = hn::Ge(inlet.film_ratio, hn::Set(d, 0.95));
    store_words(
        d, hn::IfThenElse(inlet.is_collapsed, hn::Set(d, 2.0), hn::IfThenZeroElse(is_flooded, one)),
        to.inlet + i, count);
  }

  Shares<V> shares{zero, zero};
  if (needs_shares) {
    auto is_free = hn::Lt(one, zero);
    if (!needs.exact_share) is_free = is_free_of_asperities(d, *words.film, surface, lambda);
    if (!hn::AllTrue(d, is_free))
      shares = needs.is_starved ? starved_shares(d, order, surface, flooded, inlet, lambda)
                                : flooded.shares;
    shares.asperity = hn::IfThenZeroElse(is_free, shares.asperity);
    shares.fluid = hn::IfThenElse(is_free, one, shares.fluid);
    add(Work::share_is_nothing, is_free);
    add(Work::share, hn::Not(is_free));
  } else {
    add(Work::share_not_asked, present);
  }
  // Without a film and a floor nothing balances the load.
  const auto has_collapsed = hn::And(inlet.is_collapsed, hn::Eq(apart, zero));
  const V nan = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
  if (to.regime != nullptr) {
    put(Output::asperity_load_share, hn::IfThenElse(has_collapsed, nan, shares.asperity));
    put(Output::fluid_load_share, hn::IfThenElse(has_collapsed, nan, shares.fluid));
    const V little = hn::Set(d, 0.01);
    const V by_shares =
        hn::IfThenZeroElse(hn::Lt(shares.fluid, little),
                           hn::IfThenElse(hn::Lt(shares.asperity, little), hn::Set(d, 2.0), one));
    store_words(d, hn::IfThenElse(has_collapsed, hn::Set(d, 3.0), by_shares), to.regime + i, count);
  }
  // The lanes whose area and count follow from A.
  auto by_share = hn::Lt(one, zero);
  if (needs.area || needs.count) {
    by_share = hn::Gt(surface.floor, hn::Set(d, 3.0));
    if (HWY_UNLIKELY(!hn::AllFalse(d, by_share)))
      by_share = hn::And(by_share, hn::Or(hn::Gt(shares.asperity, hn::Set(d, 0.75)),
                                          is_stiff(d, order, surface, flooded.film_parameter,
                                                   flooded.shares, stiff_film)));
  }
  V area = zero;
  if (needs.area) {
    add(Work::moment, present);
    area = moment_at(d, order, area_order(words.model), surface, contact.area_factor, apart,
                     shares.asperity, by_share);
    put(Output::real_area_ratio, area);
  }
  if (needs.count) {
    add(Work::moment, present);
    put(Output::summit_count, moment_at(d, order, count_order(words.model), surface,
                                        contact.count_factor, apart, shares.asperity, by_share));
  }
  // Only friction is left: every other output has to be written above this line.
  if (to.numbers[static_cast<std::size_t>(Output::friction)] == nullptr) return;
  // μ = μ_b A + τ (1 − A_r/A_nom)/p̄
  add(Work::shear_stress, present);
  const V solid = hn::Mul(contact.boundary_coefficient, shares.asperity);
  const V fluid_area = hn::Sub(one, area);
  const V log_thickening = log_viscosity_ratio(d, words.viscosity, contact,
                                               hn::Mul(shares.fluid, contact.mean_pressure));
  const V relative = relative_shear_stress(d, words.fluid, contact, log_thickening,
                                           hn::Mul(contact.slide_roll_ratio, flooded.speed),
                                           hn::Mul(apart, contact.summit_height_sd));
  const V at_eyring_stress =
      hn::Div(hn::Mul(contact.eyring_stress, fluid_area), contact.mean_pressure);
  const V fluid = hn::IfThenElseZero(hn::Gt(fluid_area, zero), hn::Mul(relative, at_eyring_stress));
  put(Output::friction, hn::IfThenElse(has_collapsed, nan, hn::Add(solid, fluid)));
}

// Do outputs depend on the load shares? Near a high floor the moments do too.
template <class D, class V = hn::Vec<D>>
HWY_INLINE bool needs_shares(D d, const NeededParts& needs,
                             const detail::SurfaceNumbers<V>& surface) {
  return needs.sharing ||
         ((needs.area || needs.count) && !hn::AllFalse(d, hn::Gt(surface.floor, hn::Set(d, 3.0))));
}

// Where the film ratio of `printed_exponents` comes near the least double: it falls as r⁻⁴.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_next_to_nothing(D d, const detail::ContactWords& words,
                                          const Starvation<D>& inlet) {
  const V zero = hn::Zero(d);
  if (words.closure != StarvationClosure::printed_exponents) return hn::Lt(zero, zero);
  return hn::Lt(inlet.film_ratio, hn::Set(d, least_film_ratio));
}

// As complete(), from the root λ and λ₀ (`flooded_film`), which is ln γ for a law without fixed
// exponents. Returns the root; NaN where the point is beyond the kernels' range.
template <class D, class Counter, class V = hn::Vec<D>>
HWY_INLINE V complete_root(D d, const detail::ContactWords& words,
                           const detail::ContactNumbers<V>& contact, const NeededParts& needs,
                           V speed, V flooded_film, V film_parameter, const detail::Destination& to,
                           std::size_t i, std::size_t count, Counter& work) {
  const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
  const auto present = hn::FirstN(d, count);
  const bool has_floor = !hn::AllFalse(d, hn::Gt(contact.surface.hazard, zero));
  const bool shares = needs_shares(d, needs, contact.surface);
  Flooded<V> flooded{speed, film_parameter, {zero, one}};
  // A starved film has shares of its own. They need those of the flooded film only with a floor.
  if (shares && (!needs.is_starved || has_floor))
    flooded.shares = words.film->has_fixed_exponents()
                         ? shares_at_root(d, load_order(words.model), *words.film, contact.surface,
                                          flooded_film, film_parameter)
                         : shares_at_stiffening(d, load_order(words.model), contact.surface,
                                                flooded_film, film_parameter);
  Starvation<D> inlet{one, zero, hn::Lt(one, zero)};
  if (needs.inlet) {
    inlet = inlet_of(d, words, contact, speed, film_parameter, shares && has_floor).starvation;
    if (needs.is_starved)
      count_lanes(d, work, Work::starvation, hn::AndNot(inlet.is_collapsed, present));
    else
      count_lanes(d, work, Work::supply_is_flooded, present);
  }
  complete(d, words, contact, needs, shares, flooded, inlet, to, i, count, work);
  return hn::IfThenElse(is_next_to_nothing(d, words, inlet),
                        hn::Set(d, std::numeric_limits<double>::quiet_NaN()), film_parameter);
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
