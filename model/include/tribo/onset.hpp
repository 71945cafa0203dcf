// SPDX-License-Identifier: Apache-2.0
// The onset of starvation by four criteria (model/README.md, section 9):
//
//   film_maximum      h*(u) has a maximum. Constant h_oil: r from the closure, then explicitly
//                     λ = r h_oil/σ_s, λ₀ = λ(1−A)^{a−b} and u. Constant flow: greatest interior
//                     maximum, d ln h*/d ln u = s + (1 + s) d ln y/d ln r = 0, s = d ln λ/d ln u.
//   film_departure    h* = (1−ε) h_ff. Constant h_oil: r is explicit, the rest as above.
//                     Constant flow: one monotone scalar root.
//   friction_minimum  the lowest interior minimum of μ(u) over the scene's speeds
//   asperity_minimum  the minimum of A(u): at the film maximum, because A falls as the film grows
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tribo/interior_minimum.hpp"
#include "tribo/starvation.hpp"
#include "tribo/stribeck_walk.hpp"

namespace tribo {

enum class OnsetCriterion : std::uint8_t {
  film_maximum,
  film_departure,
  friction_minimum,
  asperity_minimum
};

struct CriterionInfo {
  OnsetCriterion criterion;
  std::string_view name;
  std::string_view meaning;
};

// In the order of OnsetCriterion.
inline constexpr auto onset_criteria = std::to_array<CriterionInfo>({
    {OnsetCriterion::film_maximum, "film_maximum", "the film no longer grows with speed"},
    {OnsetCriterion::film_departure, "film_departure",
     "the film is a part ε below the flooded one"},
    {OnsetCriterion::friction_minimum, "friction_minimum",
     "the lowest friction within the scene's speeds"},
    {OnsetCriterion::asperity_minimum, "asperity_minimum", "the least load on the asperities"},
});

inline constexpr auto onset_criterion_words = [] {
  std::array<std::string_view, onset_criteria.size()> words;
  std::transform(onset_criteria.begin(), onset_criteria.end(), words.begin(),
                 [](const CriterionInfo& info) { return info.name; });
  return words;
}();

constexpr std::string_view name(OnsetCriterion criterion) {
  return onset_criterion_words[static_cast<std::size_t>(criterion)];
}

inline constexpr double default_departure = 0.05;  // ε of film_departure

// The onsets of the inlet alone, at constant h_oil. They depend on the law of the inlet, and not on
// the contact.
template <class T>
struct InletOnsets {
  T film_maximum;           // r = h_ff/h_oil at the maximum of y r; NaN where there is none
  T film_ratio_at_maximum;  // y there
  T departure;              // ε
  T film_departure;         // r at which y = 1 − ε
};

// The onsets that `criterion` needs; the other onsets are NaN.
template <class T>
InletOnsets<T> inlet_onsets(const InletLaw<T>& law, const T& departure, OnsetCriterion criterion) {
  InletOnsets<T> onsets{quiet_nan<T>(), quiet_nan<T>(), departure, quiet_nan<T>()};
  if (law.closure == StarvationClosure::solved) return onsets;  // they depend on the contact
  if (criterion == OnsetCriterion::film_departure)
    onsets.film_departure = law.at_departure(departure);
  if (criterion != OnsetCriterion::film_maximum && criterion != OnsetCriterion::asperity_minimum)
    return onsets;
  onsets.film_maximum = law.at_film_maximum();
  if (onsets.film_maximum == onsets.film_maximum)
    onsets.film_ratio_at_maximum = law.film_ratio(onsets.film_maximum);
  return onsets;
}

template <class T>
struct Onset {
  OnsetCriterion criterion;
  bool exists;
  T speed;                  // u, m/s; 0 where there is no onset
  T film;                   // h*, m
  T film_parameter;         // h*/σ_s; NaN for smooth bodies
  std::string_view reason;  // why there is none; empty where there is one
};

namespace detail {

template <class T>
Onset<T> no_onset(OnsetCriterion criterion, std::string_view reason) {
  return {criterion, false, T(0), T(0), T(0), reason};
}

template <class T>
Onset<T> onset_at(OnsetCriterion criterion, const MixedContact<T>& contact,
                  const FloodedFilm<T>& flooded, const T& film_ratio) {
  const T film_parameter = flooded.shares.film_parameter * film_ratio;
  return {criterion,      true, flooded.speed, film_parameter * contact.summit_height_sd(),
          film_parameter, {}};
}

inline constexpr std::string_view fully_flooded = "the inlet is fully flooded: no supply is given";
inline constexpr std::string_view beyond_solved_films =
    "no film between solved ones meets it: closures.film and closures.starvation = \"solved\" have "
    "tables of M and L";

// The first and the last coordinate of the walk, to 1/50 in ln u, at which the film, starved or
// not, lies inside the tables of solved films; NaN where none does.
template <class T>
struct KnownWalk {
  T first, last;
};
template <class T>
KnownWalk<T> known_walk(const MixedContact<T>& contact, const StribeckWalk<T>& walk) {
  KnownWalk<T> known{quiet_nan<T>(), quiet_nan<T>()};
  if constexpr (std::is_same_v<T, double>) {
    // M falls as the speed or γ rises. So no film is known above the speed that has the table's
    // least M at γ = 1.
    const double m = contact.film().is_of_lines ? 0.5 : 0.75;
    const double fastest =
        (contact.numbers().film.rigid - film_table(contact.film()).first_load) / m;
    for (int i = 0; i < 5000 && is_finite(fastest); ++i) {
      const double s = fastest - 0.02 * i;
      const WalkPoint<double> point = walk.at(s);
      const double film = point.flooded.shares.film_parameter * point.inlet.film_ratio;
      if (film == film) {
        known.first = s;
        if (known.last != known.last) known.last = s;
      } else if (known.last == known.last) {
        break;
      }
    }
  }
  return known;
}

// The onset at constant h_oil, where the closure fixes r: λ = r h_oil/σ_s gives the shares and u.
template <class T>
Onset<T> onset_at_ratio(OnsetCriterion criterion, const MixedContact<T>& contact, const T& r,
                        const T& film_ratio) {
  const LoadSharing<T>& sharing = contact.sharing();
  const T lambda = r * contact.inlet_film_parameter(T(1));
  if (sharing.has_floor() && lambda <= sharing.floor())
    return no_onset<T>(criterion,
                       "the criterion's film lies below the floor that the asperities hold up");
  const LoadShares<T> shares = sharing.shares_above_floor(T(lambda - sharing.floor()));
  const T speed = contact.speed_at(shares);
  if (contact.film().is_solved() && speed != speed)
    return no_onset<T>(criterion, beyond_solved_films);
  return onset_at(criterion, contact, FloodedFilm<T>{speed, shares}, film_ratio);
}

// ln r at a point of the walk, under constant flow: r = h_ff u/q, increasing along the walk.
template <class T>
T log_flow_ratio(const MixedContact<T>& contact, const WalkPoint<T>& point) {
  using std::log;
  return log(point.flooded.shares.film_parameter) + log(contact.summit_height_sd()) +
         log(point.flooded.speed) - log(contact.inlet_flow());
}

template <>
double log_flow_ratio(const MixedContact<double>& contact, const WalkPoint<double>& point);

// The coordinate at which r has a given value, under constant flow; NaN where no film between
// solved ones has it.
template <class T>
T coordinate_at_flow_ratio(const MixedContact<T>& contact, const StribeckWalk<T>& walk,
                           const T& log_r) {
  using std::exp;
  using std::log;
  const auto excess = [&](const T& s) { return log_flow_ratio(contact, walk.at(s)) - log_r; };
  if (contact.film().is_solved()) {
    const KnownWalk<T> known = known_walk(contact, walk);
    return bracketed_root(excess, known.first, known.last, epsilon<T>());
  }
  // Without load sharing r = λ₀(1)σ_s u^{1+a}/q.
  const T log_speed = (log_r + log(contact.inlet_flow()) - log(contact.summit_height_sd()) -
                       log(contact.flooded_film_parameter(T(1)))) /
                      (1 + ratio<T>(contact.film().speed_exponent));
  T low = walk.near(T(exp(log_speed)));
  T high = low;
  T width = 1;
  while (excess(low) > 0 && width < 5000) low -= (width *= 2);
  width = 1;
  while (excess(high) < 0 && width < 5000) high += (width *= 2);
  return bracketed_root(excess, low, high, epsilon<T>());
}

// d ln h*/d ln u under constant flow.
template <class T>
T flow_film_slope(const MixedContact<T>& contact, const WalkPoint<T>& point) {
  using std::exp;
  if (point.inlet.collapsed) return T(-1);
  const T r = exp(log_flow_ratio(contact, point));
  const T slope = contact.inlet_law().slope(r);
  return point.film_slope + (1 + point.film_slope) * slope;
}

template <class T>
Onset<T> film_maximum_at_constant_flow(OnsetCriterion criterion, const MixedContact<T>& contact) {
  using std::exp;
  using std::log;
  const StribeckWalk<T> walk(contact);
  // At a maximum −d ln y/d ln r is s/(1 + s) ≤ a/(1 + a), about 0.4, so that r is below 10. The
  // arctan closures have −d ln y/d ln r < 1e-6 below r = 1e-9: a maximum there would need a film
  // slope s < 1e-6, which does not matter. (Damiens' closure can have one there if γ < 0.03.)
  const bool is_solved = contact.film().is_solved();
  const KnownWalk<T> known = is_solved ? known_walk(contact, walk) : KnownWalk<T>{};
  const T first =
      is_solved ? known.first : coordinate_at_flow_ratio(contact, walk, T(log(T(1e-9))));
  const T last_log_r =
      contact.inlet_law().closure == StarvationClosure::flooded_inlet ? T(0) : T(log(T(1e4)));
  const T step = ratio<T>(1, 50);
  Onset<T> best = no_onset<T>(
      criterion, is_solved ? beyond_solved_films : "the film falls with speed throughout");
  T s = first;
  WalkPoint<T> point = walk.at(s);
  T slope = flow_film_slope(contact, point);
  for (int i = 0; i < 5000 && log_flow_ratio(contact, point) < last_log_r; ++i) {
    const T s_next = s + step * point.rate;
    const WalkPoint<T> next = walk.at(s_next);
    const T slope_next = flow_film_slope(contact, next);
    if (slope > 0 && slope_next <= 0) {
      const T top = bracketed_root([&](const T& x) { return flow_film_slope(contact, walk.at(x)); },
                                   s, s_next, epsilon<T>());
      const WalkPoint<T> peak = walk.at(top);
      const Onset<T> found = onset_at(criterion, contact, peak.flooded, peak.inlet.film_ratio);
      if (!best.exists || found.film > best.film) best = found;
    }
    s = s_next;
    point = next;
    slope = slope_next;
  }
  return best;
}

// The greatest interior maximum of the film by the closure `solved`.
template <class T>
Onset<T> film_maximum_of_solved_inlet(OnsetCriterion criterion, const MixedContact<T>& contact) {
  const StribeckWalk<T> walk(contact);
  const KnownWalk<T> known = known_walk(contact, walk);
  if (known.first != known.first) return no_onset<T>(criterion, beyond_solved_films);
  constexpr int a_unit = 50;  // places for each factor e in speed
  int count = 4;
  while (count < 5000 && T(count) < a_unit * (known.last - known.first)) ++count;
  const auto thinness = [&](const T& s) {
    const WalkPoint<T> point = walk.at(s);
    return T(1 / (point.flooded.shares.film_parameter * point.inlet.film_ratio));
  };
  const T step = (known.last - known.first) / T(count);
  const T top = least_interior_minimum(
      thinness, known.first, count, [&](int i, const T&) { return T(known.first + T(i) * step); });
  if (top != top)
    return no_onset<T>(criterion, "the film has no maximum within the table of starved films");
  const WalkPoint<T> point = walk.at(top);
  return onset_at(criterion, contact, point.flooded, point.inlet.film_ratio);
}

template <class T>
Onset<T> film_maximum(OnsetCriterion criterion, const MixedContact<T>& contact,
                      const InletOnsets<T>& inlet) {
  if (contact.supply() == SupplyKind::flooded) return no_onset<T>(criterion, fully_flooded);
  if (contact.inlet_law().closure == StarvationClosure::solved)
    return film_maximum_of_solved_inlet(criterion, contact);
  if (contact.supply() == SupplyKind::inlet_flow)
    return film_maximum_at_constant_flow(criterion, contact);
  const T r = inlet.film_maximum;
  if (r != r)
    return no_onset<T>(criterion,
                       "with this closure the film rises towards h_oil without a maximum");
  return onset_at_ratio(criterion, contact, r, inlet.film_ratio_at_maximum);
}

template <class T>
Onset<T> film_departure(const MixedContact<T>& contact, const InletOnsets<T>& inlet) {
  using std::log;
  constexpr OnsetCriterion criterion = OnsetCriterion::film_departure;
  if (contact.supply() == SupplyKind::flooded) return no_onset<T>(criterion, fully_flooded);
  const T& r = inlet.film_departure;
  const T& departure = inlet.departure;
  if (contact.inlet_law().closure == StarvationClosure::solved) {
    const StribeckWalk<T> walk(contact);
    const KnownWalk<T> known = known_walk(contact, walk);
    const auto excess = [&](const T& s) {
      return T(walk.at(s).inlet.film_ratio - (1 - departure));
    };
    const T there = bracketed_root(excess, known.first, known.last, epsilon<T>());
    if (there != there) return no_onset<T>(criterion, beyond_solved_films);
    const WalkPoint<T> point = walk.at(there);
    return onset_at(criterion, contact, point.flooded, point.inlet.film_ratio);
  }
  if (contact.supply() != SupplyKind::inlet_flow)
    return onset_at_ratio(criterion, contact, r, T(1 - departure));
  const StribeckWalk<T> walk(contact);
  const T coordinate = coordinate_at_flow_ratio(contact, walk, T(log(r)));
  if (coordinate != coordinate) return no_onset<T>(criterion, beyond_solved_films);
  const WalkPoint<T> point = walk.at(coordinate);
  return onset_at(criterion, contact, point.flooded, T(1 - departure));
}

// The least and the greatest speed of a scene in m/s; both 0 where it has none.
struct SpeedSpan {
  double low, high;
};
inline SpeedSpan speed_span(const Speeds& speeds) {
  if (speeds.empty()) return {0, 0};
  if (speeds.list.empty()) return {speeds.from, speeds.to};
  const auto [low, high] = std::minmax_element(speeds.list.begin(), speeds.list.end());
  return {*low, *high};
}

template <class T>
Onset<T> friction_minimum(const MixedContact<T>& contact, const Scene& scene) {
  using std::log;
  constexpr OnsetCriterion criterion = OnsetCriterion::friction_minimum;
  if (!scene.lubricant.eyring_stress)
    return no_onset<T>(criterion, scene.friction.boundary_coefficient
                                      ? "friction needs lubricant.eyring_stress"
                                      : "friction needs lubricant.eyring_stress and "
                                        "friction.boundary_coefficient");
  if (!scene.friction.boundary_coefficient)
    return no_onset<T>(criterion, "friction needs friction.boundary_coefficient");
  const SpeedSpan span = speed_span(scene.speeds);
  if (!(span.low < span.high))
    return no_onset<T>(criterion, "the scene gives no range of speeds to look in");
  const StribeckWalk<T> walk(contact);
  OutputSet outputs;
  outputs.insert(Output::friction);
  const auto friction = [&](const T& s) {
    const WalkPoint<T> point = walk.at(s);
    return contact.complete(point.flooded, point.inlet, outputs).friction;
  };
  const T first = log(T(span.low)), last = log(T(span.high));
  // 50 points for each factor e in speed, far finer than any feature of the closed forms; but at
  // least 200 points, and at most 5000, where the range of speeds is absurdly wide.
  const double width = std::log(span.high) - std::log(span.low);
  const int count = std::clamp(static_cast<int>(50 * width), 200, 5000);
  const T step = (last - first) / T(count);
  const T lowest_at =
      least_interior_minimum(friction, walk.near(T(span.low)), count, [&](int i, const T& before) {
        return walk.walk_to(before, T(first + T(i) * step), T(step / 10));
      });
  if (lowest_at != lowest_at)
    return no_onset<T>(criterion, "friction has no interior minimum over the scene's speeds");
  const WalkPoint<T> point = walk.at(lowest_at);
  return onset_at(criterion, contact, point.flooded, point.inlet.film_ratio);
}

template <class T>
Onset<T> asperity_minimum(const MixedContact<T>& contact, const InletOnsets<T>& inlet) {
  constexpr OnsetCriterion criterion = OnsetCriterion::asperity_minimum;
  const Onset<T> maximum = film_maximum(criterion, contact, inlet);
  if (maximum.exists && contact.sharing().has_floor() &&
      maximum.film_parameter <= contact.sharing().floor())
    return no_onset<T>(criterion, "the asperities carry the whole load at every speed");
  return maximum;
}

template <class T>
Onset<T> onset_by(const MixedContact<T>& contact, const Scene& scene, OnsetCriterion criterion,
                  const InletOnsets<T>& inlet) {
  if (!is_finite(contact.sharing().stiffness()))
    return no_onset<T>(criterion,
                       "K, the stiffness of the asperities, is outside the range of double "
                       "precision");
  switch (criterion) {
    case OnsetCriterion::film_maximum:
      return film_maximum(criterion, contact, inlet);
    case OnsetCriterion::film_departure:
      return film_departure(contact, inlet);
    case OnsetCriterion::friction_minimum:
      return friction_minimum(contact, scene);
    case OnsetCriterion::asperity_minimum:
      return asperity_minimum(contact, inlet);
  }
  return no_onset<T>(criterion, "unknown criterion");
}

}  // namespace detail

// The onset by a criterion, from the onsets of the contact's inlet law: a caller with many
// contacts computes those only once. Error as below.
template <class T>
Onset<T> onset(const MixedContact<T>& contact, const Scene& scene, OnsetCriterion criterion,
               const InletOnsets<T>& inlet) {
  if (scene.lubricant.thermal != ThermalInlet::none &&
      criterion != OnsetCriterion::friction_minimum)
    return detail::no_onset<T>(
        criterion,
        "it is not computed of an inlet that shear heats, lubricant.thermal: "
        "`curve` shows where the film is starved");
  if (scene.surface.has_rq_alone() && (criterion == OnsetCriterion::friction_minimum ||
                                       criterion == OnsetCriterion::asperity_minimum))
    return detail::no_onset<T>(
        criterion,
        "Rq alone does not say what the summits carry where the faces touch: "
        "give summits or spectral moments");
  if (!scene.surface.is_smooth()) return detail::onset_by(contact, scene, criterion, inlet);
  if (criterion == OnsetCriterion::asperity_minimum)
    return detail::no_onset<T>(criterion, "the bodies are smooth: no load is on asperities");
  Onset<T> found = detail::onset_by(contact, scene, criterion, inlet);
  found.film_parameter = quiet_nan<T>();
  return found;
}

// `departure` is the ε of film_departure, 0 < ε < 1. Closures of r alone need no load-sharing root
// at constant h_oil, but for friction_minimum. Error of the speed in double: 1e-13 at
// well-conditioned points, for friction_minimum about √ε.
template <class T>
Onset<T> onset(const MixedContact<T>& contact, const Scene& scene, OnsetCriterion criterion,
               const T& departure) {
  return onset(contact, scene, criterion, inlet_onsets(contact.inlet_law(), departure, criterion));
}

}  // namespace tribo
