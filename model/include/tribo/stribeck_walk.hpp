// SPDX-License-Identifier: Apache-2.0
// The Stribeck curve without a root: walk the flooded film instead of the speed (model/README.md,
// section 6). λ gives A, λ₀ = λ(1−A)^{a−b} and u explicitly. The coordinate of the walk is
//
//   s = ln(λ − λ_b)    in general, so that a floor λ_b is approached without cancellation;
//   ψ = e^{−s}, or ψ = ψ_b/(1 + e^s) above a floor,
//                      for an implicit closure at constant h_oil: r(ψ) is explicit, y(r) is not.
//
// An implicit closure at constant flow needs one scalar root y(r) for each point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tribo/mixed_contact.hpp"
#include "tribo/operating_points.hpp"

namespace tribo {

template <class T>
struct WalkPoint {
  FloodedFilm<T> flooded;
  InletState<T> inlet;
  T film_slope{};  // d ln λ/d ln u, from 0 on a floor to a
  T rate{};        // ds/d ln u
};

namespace detail {

// d ln λ/d ln u = a/(1 − (a−b) λA′/(1−A)), from λA′/A; 0 on a floor.
template <class T>
T film_slope(const FilmExponents<T>& film, const LoadShares<T>& shares,
             const T& asperity_share_slope) {
  if (shares.fluid == 0) return T(0);
  const T stiffening = -film.sharing * shares.asperity * asperity_share_slope;
  return film.speed * shares.fluid / (shares.fluid + stiffening);
}

}  // namespace detail

// This template takes only laws of fixed exponents with a − b > 0; double has its own walk below.
template <class T>
class StribeckWalk {
 public:
  explicit StribeckWalk(const MixedContact<T>& contact)
      : contact_(contact),
        sharing_(contact.sharing()),
        by_inlet_length_(is_implicit(contact.inlet_law().closure) &&
                         contact.supply() != SupplyKind::flooded &&
                         contact.supply() != SupplyKind::inlet_flow),
        above_floor_(sharing_.floor() > 0) {
    using std::exp;
    using std::log;
    if (above_floor_) {
      log_floor_ = log(sharing_.floor());
      log_rate_at_floor_ = sharing_.log_fluid_rate_at_floor();
    }
    if (!by_inlet_length_) return;
    inlet_film_parameter_ = contact.inlet_film_parameter(T(1));
    if (above_floor_) {
      log_inlet_length_at_floor_ =
          curve().log_inlet_length(T(sharing_.floor() / inlet_film_parameter_));
      log_inverse_r_at_floor_ = curve().log_inverse_r(log_inlet_length_at_floor_);
    }
  }

  // The point at coordinate s. It is explicit, except y of an implicit closure at constant flow.
  WalkPoint<T> at(const T& s) const {
    using std::exp;
    WalkPoint<T> point;
    T film_rate;  // d ln λ/ds
    T log_distance = s;
    if (by_inlet_length_) {
      const T t = log_inlet_length(s);
      log_distance = log_distance_by_inlet_length(s, t);
      point.flooded = film_at(log_distance);
      point.inlet = {exp(curve().log_film_ratio(t)), exp(T(-curve().log_inverse_r(t))), false};
      film_rate = curve().slope_of_log_inverse_r(t) * (above_floor_ ? logistic(s) : T(1));
    } else {
      point.flooded = film_at(s);
      point.inlet = contact_.inlet(point.flooded);
      film_rate = above_floor_ ? T(1 / (1 + exp(T(log_floor_ - s)))) : T(1);
    }
    const LoadShares<T>& shares = point.flooded.shares;
    point.film_slope = detail::film_slope(
        contact_.film_exponents(point.flooded), shares,
        shares.asperity > 0 ? sharing_.asperity_share_slope_above_floor(T(exp(log_distance)))
                            : T(0));
    // At the floor film_slope and film_rate both vanish; the rate is the limit of their ratio.
    point.rate = is_at_floor(point.flooded)
                     ? T(ratio<T>(film().speed_exponent) / ratio<T>(film().sharing_exponent))
                     : T(point.film_slope / film_rate);
    return point;
  }

  // A coordinate whose speed is roughly u: explicit, from the film's two limits, at the floor and
  // far above it. On the paper's surfaces that speed lies between u/6 and u.
  T near(const T& speed) const {
    using std::exp;
    using std::log;
    const T log_film = log(contact_.flooded_film_parameter(speed));
    T log_distance = log_film;
    if (above_floor_) {
      // 1 − A = (λ₀/λ_b)^p = e^rate (λ − λ_b) at the floor, λ = λ₀ far above it.
      const T p = 1 / ratio<T>(film().sharing_exponent);
      const T knee = (p * log_floor_ + log_rate_at_floor_) / (p - 1);
      log_distance -= (p - 1) * log_one_plus_exp(T(knee - log_film));
    }
    if (!by_inlet_length_) return log_distance;
    const T log_lambda = above_floor_
                             ? T(log_distance + log_one_plus_exp(T(log_floor_ - log_distance)))
                             : log_distance;
    const T t = rough_log_inlet_length(T(log_lambda - log(inlet_film_parameter_)));
    if (!above_floor_) return -t;
    const T near_floor =
        log_distance - log_floor_ - log(curve().slope_of_log_inverse_r(log_inlet_length_at_floor_));
    if (near_floor < 0) return near_floor;
    const T ratio_of_lengths = log_inlet_length_at_floor_ - t;
    return ratio_of_lengths > 1 ? ratio_of_lengths : near_floor;
  }

  // Walks from coordinate s to one whose ln u is within `tolerance` of log_speed, in steps of at
  // most 2 upwards in ln u and 10 in s. A NaN speed (overflow) stops the walk.
  T walk_to(T s, const T& log_speed, const T& tolerance) const {
    using std::abs;
    using std::log;
    for (int steps = 0; steps < 500; ++steps) {
      const WalkPoint<T> point = at(s);
      T left = log_speed - log(point.flooded.speed);
      if (!(abs(left) > tolerance)) break;
      if (left > 2) left = 2;
      const T step = left * point.rate;
      s += step > 10 ? T(10) : step < -10 ? T(-10) : step;
    }
    return s;
  }

 private:
  InletCurve<T> curve() const { return contact_.inlet_law().curve(); }
  const FilmLaw& film() const { return contact_.film(); }

  // ln(1 + e^x) without overflow.
  static T log_one_plus_exp(const T& x) {
    using std::exp;
    using std::log1p;
    return x > 0 ? T(x + log1p(exp(T(-x)))) : T(log1p(exp(x)));
  }
  static T logistic(const T& x) {
    using std::exp;
    return 1 / (1 + exp(T(-x)));
  }

  // Is the film so near the floor that 1 − A is proportional to the distance?
  bool is_at_floor(const FloodedFilm<T>& film) const {
    return above_floor_ && film.shares.fluid < epsilon<T>() / 4;
  }

  // The film at λ = λ_b + e^log_distance.
  FloodedFilm<T> film_at(const T& log_distance) const {
    using std::exp;
    using std::log;
    const T log_fluid = log_rate_at_floor_ + log_distance;
    if (above_floor_ && log_fluid < log(T(epsilon<T>() / 4))) {
      const T fluid = exp(log_fluid);
      const T film0 = sharing_.floor() * exp(T(ratio<T>(film().sharing_exponent) * log_fluid));
      return {contact_.speed_at(film0), {sharing_.floor(), 1 - fluid, fluid, 0}};
    }
    const LoadShares<T> shares = sharing_.shares_above_floor(T(exp(log_distance)));
    return {contact_.speed_at(shares), shares};
  }

  // Walk by inlet length: t = ln ψ.
  T log_inlet_length(const T& s) const {
    return above_floor_ ? T(log_inlet_length_at_floor_ - log_one_plus_exp(s)) : T(-s);
  }

  // ln(λ − λ_b) there: λ/λ_b = G(ψ_b)/G(ψ), G = 1/r. Near the floor the difference of G is used.
  T log_distance_by_inlet_length(const T& s, const T& t) const {
    using std::exp;
    using std::expm1;
    using std::log;
    if (!above_floor_) return log(inlet_film_parameter_) - curve().log_inverse_r(t);
    if (s > -1)
      return log_floor_ + log(expm1(T(log_inverse_r_at_floor_ - curve().log_inverse_r(t))));
    return log_floor_ + log_of_relative_change(s, t);
  }

  // ln(G(ψ_b)/G(ψ) − 1) for ψ = ψ_b/(1+ξ), ξ = e^s < 1, by differences that do not cancel.
  T log_of_relative_change(const T& s, const T& t) const {
    using std::atan;
    using std::exp;
    using std::expm1;
    using std::log;
    using std::log1p;
    const T xi = exp(s);
    const T psi_b = exp(log_inlet_length_at_floor_);
    const T psi = exp(t);
    const T factor = wolveridge_factor<T>();
    const T fall_of_psi = psi_b / (1 + 1 / xi);  // ψ_b − ψ
    const T fall_of_y =
        2 / pi<T>() * atan(T(factor * fall_of_psi / (1 + factor * psi * factor * psi_b)));
    const T y_b = wolveridge_film_ratio(psi_b);
    T log_of_crook = -ratio<T>(3, 2) * log1p(xi);
    T crook_b = exp(curve().log_crook_term(log_inlet_length_at_floor_, T(log(y_b))));
    if (contact_.inlet_law().closure == StarvationClosure::printed_exponents)
      log_of_crook -= ratio<T>(5, 4) * log1p(T(-fall_of_y / y_b));
    const T fall = fall_of_y - crook_b * expm1(log_of_crook);
    if (!(fall > 0))  // ξ has underflowed: G falls in proportion to it
      return s + log(curve().slope_of_log_inverse_r(log_inlet_length_at_floor_));
    return log(fall) - curve().log_inverse_r(t);
  }

  // t from ln r by the greater term of G: a start, not a solution.
  T rough_log_inlet_length(const T& log_r) const {
    using std::log;
    const T log_c = log(crook_constant<T>());
    const T log_linear = log(T(2 * wolveridge_factor<T>() / pi<T>()));
    const T long_inlet = ratio<T>(2, 3) * (log_c - log_r);
    const T short_inlet = contact_.inlet_law().closure == StarvationClosure::printed_exponents
                              ? T(4 * (log_c - log_r) + 5 * log_linear)
                              : T(-log_r - log_linear);
    return short_inlet < long_inlet ? short_inlet : long_inlet;
  }

  const MixedContact<T>& contact_;  // must outlive the walk
  const LoadSharing<T>& sharing_;
  bool by_inlet_length_;
  bool above_floor_;
  T log_floor_{};
  T log_rate_at_floor_{};
  T inlet_film_parameter_{};
  T log_inlet_length_at_floor_{};
  T log_inverse_r_at_floor_{};
};

// In double the coordinate is ln u itself, since the engine solves for the root anyway.
template <>
class StribeckWalk<double> {
 public:
  explicit StribeckWalk(const MixedContact<double>& contact) : contact_(contact) {}

  WalkPoint<double> at(double log_speed) const;
  double near(double speed) const;
  double walk_to(double, double log_speed, double) const { return log_speed; }

 private:
  const MixedContact<double>& contact_;  // must outlive the walk
};

// Visits `count` ≥ 2 points whose speeds ascend from about `from` to about `to` (0 < from < to,
// m/s): within a quarter of a step of the logarithmic grid, and within 1e-9 at the ends. Each point
// is exact for its own speed, which the walk chooses. visit(point) gets an OperatingPoint<T>. No
// load-sharing root is solved.
template <class T, class Visitor>
void stribeck_curve(const MixedContact<T>& contact, const T& from, const T& to, std::size_t count,
                    OutputSet outputs, Visitor&& visit) {
  using std::log;
  const StribeckWalk<T> walk(contact);
  const T first = log(from);
  const T step = (log(to) - first) / T(count - 1);
  T s = walk.near(from);
  for (std::size_t i = 0; i < count; ++i) {
    const bool at_end = i == 0 || i + 1 == count;
    s = walk.walk_to(s, T(first + T(i) * step), at_end ? ratio<T>(1, 1000000000) : T(step / 4));
    const WalkPoint<T> point = walk.at(s);
    visit(contact.complete(point.flooded, point.inlet, outputs));
  }
}

// In double the points are at the speeds of the logarithmic grid itself, those of a scene's range.
template <class Visitor>
void stribeck_curve(const MixedContact<double>& contact, double from, double to, std::size_t count,
                    OutputSet outputs, Visitor&& visit) {
  const Speeds range{{}, from, to, count, Spacing::log};
  std::vector<double> speeds(std::min<std::size_t>(count, 512));  // a block that fits in the caches
  OperatingPoints points;
  points.resize(speeds.size(), outputs);
  for (std::size_t first = 0; first < count; first += speeds.size()) {
    speeds.resize(std::min(speeds.size(), count - first));
    range.fill(first, speeds);
    solve(contact, speeds, outputs, points);
    for (std::size_t i = 0; i < speeds.size(); ++i) visit(points[i]);
  }
}

}  // namespace tribo
