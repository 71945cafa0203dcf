// SPDX-License-Identifier: Apache-2.0
// How asperities and film share the load (model/README.md, section 6; paper, eqs 1.17 to 1.19 and
// 1.32). Source: K. L. Johnson, J. A. Greenwood, S. Y. Poon: A simple theory of asperity contact in
// elastohydrodynamic lubrication. Wear 19 (1972) 91, doi 10.1016/0043-1648(72)90445-0; E. R. M.
// Gelinck, D. J. Schipper: Calculation of Stribeck curves for line contacts. Tribol. Int. 33 (2000)
// 175. With λ₀ = h₀/σ_s:
//
//   A(λ) = (K F_p(λ−δ))^q,                     the load share of the asperities
//   ln λ − ln λ₀ + e ln(1 − A(λ)) = 0          on {A < 1}: exactly one root λ.
//
// e = a − b belongs to the film law (film_thickness.hpp): 0.14 for the default law. Where e = 0, λ
// is the greater of λ₀ and λ_b. For a law without fixed exponents its film λ(γ) at γU and G/γ, with
// γ = 1/(1−A), replaces λ₀(1−A)^{−e} (moes_film.hpp). The floor λ_b solves A(λ_b) = 1. It exists
// where A(0) ≥ 1 and is 0 otherwise. At the root w = (λ₀/λ)^{1/e} is the load share of the film.
// The excess A + w − 1 is decreasing and convex in λ (A″ ≥ 0 by Cauchy and Schwarz), and ≥ 0 at
// max(λ₀, λ_b). Newton's steps from there rise monotonically to the root and never fail.
#pragma once

#include "tribo/asperity_contact.hpp"
#include "tribo/bracketed_root.hpp"
#include "tribo/contact_numbers.hpp"
#include "tribo/contract.hpp"
#include "tribo/film_thickness.hpp"

namespace tribo {

// The contract of the root λ.
inline constexpr Contract load_sharing_contract{4, 8.5};

// The greatest number of steps to a root in double.
inline constexpr int max_sharing_steps = 16;

// The state of load sharing at one film.
template <class T>
struct LoadShares {
  T film_parameter;  // λ
  T asperity;        // A
  T fluid;           // 1 − A, without the cancellation
  int iterations;    // steps to the root that were taken
};

namespace detail {

// −d ln F_n/dd = n F_{n−1}/F_n, n ≥ 1, from S_n(d): the scaled moments have the same ratio. Where
// S_n nears underflow, the result is d to every digit.
template <class T>
T moment_hazard(Order n, const T& scaled, const T& d) {
  if (!(scaled > 0 && d < 1 / (epsilon<T>() * epsilon<T>()))) return d;
  return value_of<T>(n) * (scaled_gaussian_moment(lower(n), d) / scaled);
}

}  // namespace detail

// A root λ, and the steps to it.
template <class T>
struct SharingRoot {
  T film_parameter;
  int iterations;
};

template <class T>
class MixedContact;

template <class T>
class LoadSharing {
 public:
  // stiffness K ≥ 0, offset δ ≥ 0. The address of the law is kept.
  LoadSharing(AsperityModel model, const T& stiffness, const T& offset,
              const FilmLaw& film = hamrock_dowson_central_law)
      : film_(&film),
        order_(load_order(model)),
        exponent_(sharing_exponent<T>(model)),
        stiffness_(stiffness),
        offset_(offset) {
    find_floor();
  }
  LoadSharing(AsperityModel, const T&, const T&, FilmLaw&&) = delete;

  const T& stiffness() const { return stiffness_; }
  const T& offset() const { return offset_; }
  const FilmLaw& film() const { return *film_; }
  bool has_floor() const { return has_floor_; }
  // λ_b, 0 where there is none. Error: 20 ε × condition, which grows as A(0) → 1.
  const T& floor() const { return floor_; }

  // A(λ) = (K F_p(λ−δ))^q, not clipped at 1. Error: 500 ε.
  T asperity_share(const T& film_parameter) const { return share_at(T(film_parameter - offset_)); }

  // d ln A/d ln λ ≤ 0.
  T asperity_share_slope(const T& film_parameter) const {
    return film_parameter * asperities(T(film_parameter - offset_)).log_slope;
  }

  // d ln A/d ln λ at a distance above the floor (λ = λ_b + distance).
  T asperity_share_slope_above_floor(const T& distance) const {
    return (floor_ + distance) * asperities(argument_above_floor(distance)).log_slope;
  }

  // The shares at a distance above the floor (λ = λ_b + distance; λ_b = 0 where there is no floor).
  // Near a floor 1 − A comes from the Taylor series of F_p there, so that it does not cancel.
  LoadShares<T> shares_above_floor(const T& distance) const {
    const T lambda = floor_ + distance;
    const T asperity = share_at(argument_above_floor(distance));
    if (!has_floor_ || asperity < ratio<T>(3, 4))
      return {lambda, asperity, asperity >= 1 ? T(0) : T(1 - asperity), 0};
    const T fluid = fluid_share_near_floor(distance);
    return {lambda, 1 - fluid, fluid, 0};
  }

  // The distance above the floor at which the fluid carries the share 0 < w < 1/4. 1 − A is concave
  // there, so that Newton's method rises to it from w/(d(1−A)/dλ). Error: a few ε.
  T distance_above_floor(const T& fluid) const {
    T distance = fluid / -floor_log_slope_;
    for (int i = 0; i < 100; ++i) {
      const T here = fluid_share_near_floor(distance);
      const T slope = -(1 - here) * asperities(T(floor_argument_ + distance)).log_slope;
      const T step = (fluid - here) / slope;
      if (!(step > 0)) break;
      distance += step;
      if (step < 2 * epsilon<T>() * distance) break;
    }
    return distance;
  }

  // Is the film above a high floor so stiff that 1 − A, the film's share of the load, gives more
  // digits of A than the rounded λ? An ulp of λ moves A by −d ln A/d ln λ ≥ q(λ − δ)λ ulp. The
  // answer is yes where q(λ − δ)λ is above `least` times (1 − A)/A. With floors below 3 an ulp of λ
  // moves A by a few ulp at most. Where λ is above twice the floor, A is negligible.
  bool is_stiff(const LoadShares<T>& at, const T& least) const {
    const T& lambda = at.film_parameter;
    if (!has_floor_ || !(floor_ > 3) || !(lambda < 2 * floor_)) return false;
    return exponent_ * lambda * (lambda - offset_) * at.asperity > least * at.fluid;
  }

  // A at the film λ − `fall`, from A at λ ≥ δ. With d = λ − δ and d* = d − `fall`, the ratio of the
  // two F_p is known to more digits than each F_p, because d² − d*² is the fall times d + d*.
  T share_below(const LoadShares<T>& at, const T& fall) const {
    using std::exp;
    using std::sqrt;
    const T d = at.film_parameter - offset_;
    const T less = fall < d ? fall : d, lower = d - less;
    const T moments = scaled_gaussian_moment(order_, lower) / scaled_gaussian_moment(order_, d) *
                      exp(T(less * (d + lower) / 2));
    return at.asperity * (order_ == Order::five_halves ? T(sqrt(moments)) : moments);
  }

  // r = ln of d(1−A)/dλ at the floor: 1 − A = e^r · distance while the distance is small.
  T log_fluid_rate_at_floor() const {
    using std::log;
    return log(T(-floor_log_slope_));
  }

  // λ₀ of a film: λ(1−A)^e, from λ and its fluid share.
  T flooded_film_parameter(const T& film_parameter, const T& fluid_share) const {
    return film_parameter * decimal_power(fluid_share, film_exponent());
  }

  // The root, with its load shares. λ₀ > 0, or 0 by an underflow. The error of λ is
  // load_sharing_contract; that of the shares near a floor is operating_point_contract. λ₀ = ∞ or K
  // = ∞ gives λ = ∞, NaN gives NaN. Otherwise λ is finite, at least max(λ₀, λ_b), and 0 ≤ A ≤ 1.
  LoadShares<T> solve(const T& flooded_film_parameter) const {
    return shares_at(flooded_film_parameter, root(flooded_film_parameter));
  }

  // The root λ alone.
  T film_parameter(const T& flooded_film_parameter) const {
    return root(flooded_film_parameter).film_parameter;
  }

  using Root = SharingRoot<T>;
  Root root(const T& flooded_film_parameter) const {
    const T& lambda0 = flooded_film_parameter;
    if (lambda0 != lambda0 || floor_ != floor_) return {quiet_nan<T>(), 0};
    if (!is_finite(lambda0)) return {lambda0, 0};
    if (!is_finite(floor_)) return {floor_, 0};
    if (lambda0 == 0 && !has_floor_) return {lambda0, 0};
    if (film_exponent().p == 0) return {lambda0 < floor_ ? floor_ : lambda0, 0};
    return newton_root(lambda0);
  }

  // The shares for a law without fixed exponents, at the root of ln λ − ln λ(γ), 1/γ = 1 − A(λ).
  // film(γ) gives λ(γ) as film_parameter, d ln λ(γ)/d ln γ as sharing_exponent, and is_known. The
  // root is sought in s = ln(λ − λ_b), so that 1 − A keeps its digits next to a floor. There is one
  // root where λ(γ) rises (moes_film.hpp). λ₀ = ∞ and NaN are treated as in solve(). All shares are
  // NaN where the film at the root is not known.
  template <class Film>
  LoadShares<T> solve_by(const Film& film) const {
    using std::exp;
    using std::log;
    const auto free_film = film(T(1));
    const T& lambda0 = free_film.film_parameter;
    if (!is_finite(lambda0) || !is_finite(floor_)) return at_infinity(lambda0);
    if (lambda0 == 0) return shares_above_floor(T(0));
    int iterations = 1;
    const auto excess = [&](const T& s) {
      ++iterations;
      const LoadShares<T> shares = shares_above_floor(T(exp(s)));
      if (!(shares.fluid > 0)) return T(-1);  // λ(γ) is above any λ
      return log(T(shares.film_parameter / film(T(1 / shares.fluid)).film_parameter));
    };
    if (lambda0 > floor_) {
      const LoadShares<T> free = shares_above_floor(T(lambda0 - floor_));
      if (free.fluid == 1)
        return free_film.is_known ? LoadShares<T>{lambda0, free.asperity, free.fluid, iterations}
                                  : at_infinity(quiet_nan<T>());
    }
    // At λ = λ₀ the excess is below 0. At a film so thick that no summit touches, it is above 0.
    T low = log(lambda0 > floor_ ? T(lambda0 - floor_) : floor_);
    T high = low;
    for (T width = ratio<T>(1, 16); excess(low) > 0 && iterations < 100; width *= 2) low -= width;
    for (T width = ratio<T>(1, 16); excess(high) < 0 && iterations < 200; width *= 2) high += width;
    const T s = low < high ? bracketed_root(excess, low, high, epsilon<T>()) : low;
    // A last step of Newton's method gives the result its derivatives, where T is a type that has
    // derivatives.
    const T distance = exp(s);
    const LoadShares<T> near = shares_above_floor(distance);
    const auto there = film(T(1 / near.fluid));
    if (!there.is_known) return at_infinity(quiet_nan<T>());
    const T slope = 1 - there.sharing_exponent * near.asperity / near.fluid *
                            asperity_share_slope_above_floor(distance);
    const T step = log(T(near.film_parameter / there.film_parameter)) / slope;
    LoadShares<T> shares = shares_above_floor(T(distance - near.film_parameter * step));
    shares.iterations = iterations;
    return shares;
  }

  // The load shares at the root of a λ₀.
  LoadShares<T> shares_at(const T& flooded_film_parameter, const Root& root) const {
    if (!is_finite(flooded_film_parameter) || !is_finite(floor_))
      return at_infinity(flooded_film_parameter);
    if (flooded_film_parameter == 0 && !has_floor_) return shares_above_floor(T(0));
    if (film_exponent().p == 0) {
      if (!(flooded_film_parameter > floor_)) return {floor_, T(1), T(0), 0};
      return shares_above_floor(T(flooded_film_parameter - floor_));
    }
    return shares(flooded_film_parameter, root.film_parameter, root.iterations);
  }

  // Where A stays near 1, a Newton step multiplies λ by about 1 + e, and w by about 1/2.7: up to 45
  // steps in double, 130 in 50 digits. After that the steps converge quadratically.
  static constexpr int max_iterations = 1000;

 private:
  // Newton's method on the convex excess, from max(λ₀, λ_b) up to the root.
  Root newton_root(const T& lambda0) const {
    using std::expm1;
    const T p = 1 / ratio<T>(film_exponent());
    T lambda = lambda0 < floor_ ? floor_ : lambda0;
    int iterations = 0;
    while (iterations < max_iterations) {
      ++iterations;
      const T d = lambda - offset_;
      const Asperities at = asperities(d);
      const T fluid_less_one = expm1(T(p * log_ratio(lambda0, lambda)));
      const T excess = at.share + fluid_less_one;
      const T slope = p * (1 + fluid_less_one) - lambda * at.share * at.log_slope;
      const T step = lambda * (excess / slope);
      if (!(step > 0)) break;
      lambda += step;
      if (step < 2 * epsilon<T>() * lambda) break;
    }
    return {lambda, iterations};
  }

  // 1 − A = −expm1(q ln f), f = F_p(λ_b−δ+distance)/F_p(λ_b−δ) = Σ c_k distance^k. F″ = pF − dF′
  // gives (k+1)(k+2) c_{k+2} = (p−k) c_k − (k+1) d c_{k+1}.
  // For d < 0 rounding errors bring in the other solution of the recurrence, which grows as
  // e^{−d·distance}. So for d·distance < −4 the series is not used: there 1 − A no longer cancels.
  T fluid_share_near_floor(const T& distance) const {
    using std::abs;
    using std::expm1;
    using std::log1p;
    const T& d = floor_argument_;
    if (d * distance < -4) return 1 - share_at(T(d + distance));
    T earlier = 1;
    T current = floor_log_slope_ / exponent_;
    T power = distance;
    T change = current * power;
    T last = change;
    for (int k = 0; k < 400; ++k) {
      const T next = ((value_of<T>(order_) - T(k)) * earlier / T(k + 1) - d * current) / T(k + 2);
      earlier = current;
      current = next;
      power *= distance;
      const T term = current * power;
      change += term;
      // One small term does not end the sum: its coefficient may be changing sign.
      if (abs(term) + abs(last) < epsilon<T>() / 8 * abs(change)) break;
      last = term;
    }
    return -expm1(T(exponent_ * log1p(change)));
  }

  // λ − δ at λ = λ_b + distance, without the rounding of λ.
  T argument_above_floor(const T& distance) const {
    return has_floor_ ? T(floor_argument_ + distance) : T(distance - offset_);
  }

  struct Asperities {
    T share;      // A = (K F_p(d))^q
    T log_slope;  // d ln A/dd
  };
  Asperities asperities(const T& d) const {
    const T scaled = scaled_gaussian_moment(order_, d);
    const T hazard = detail::moment_hazard(order_, scaled, d);
    return {share_from(scaled, d), -exponent_ * hazard};
  }
  T share_at(const T& d) const { return share_from(scaled_gaussian_moment(order_, d), d); }
  T share_from(const T& scaled, const T& d) const {
    using std::sqrt;
    const auto product = factored_product(stiffness_, scaled, d);
    if (order_ == Order::five_halves) return sqrt(product.first) * sqrt(product.second);
    return product.first * product.second;
  }

  static T log_ratio(const T& x, const T& y) {
    using std::log;
    using std::log1p;
    const T difference = (x - y) / y;
    return difference > -ratio<T>(1, 2) ? T(log1p(difference)) : T(log(T(x / y)));
  }

  LoadShares<T> shares(const T& lambda0, const T& lambda, int iterations) const {
    using std::exp;
    using std::expm1;
    const T log_film = log_ratio(lambda0, lambda);
    const T exponent = ratio<T>(film_exponent());
    const T log_fluid = log_film / exponent;
    T fluid = exp(log_fluid);
    // Corrects for the rounding of the quotient and of e, which a large logarithm enlarges.
    if constexpr (std::is_floating_point_v<T>)
      fluid += fluid * ((std::fma(-log_fluid, exponent, log_film) -
                         log_fluid * ratio_residual<T>(film_exponent())) /
                        exponent);
    const LoadShares<T> by_film{lambda, T(-expm1(log_fluid)), fluid, iterations};
    if (fluid < ratio<T>(1, 2) || is_stiff(by_film, T(1 / exponent))) return by_film;
    return {lambda, asperity_share(lambda), fluid, iterations};
  }

  LoadShares<T> at_infinity(const T& lambda0) const {
    if (lambda0 != lambda0 || floor_ != floor_)
      return {quiet_nan<T>(), quiet_nan<T>(), quiet_nan<T>(), 0};
    if (is_finite(lambda0)) return {floor_, T(1), T(0), 0};
    return {lambda0, T(0), T(1), 0};
  }

  // ln(K F_p(d)) is concave and decreasing, so that Newton's method falls to its zero from the
  // right, monotonically. F_p(d) ≤ F_p(0) e^{−d²/2} for d ≥ 0 gives a start.
  void find_floor() {
    using std::log;
    using std::sqrt;
    const T at_contact = moment_product(stiffness_, order_, T(-offset_));
    has_floor_ = at_contact >= 1;
    floor_ = 0;
    if (!has_floor_) {
      if (at_contact != at_contact) floor_ = at_contact;
      return;
    }
    if (!is_finite(stiffness_)) {
      floor_ = stiffness_;
      return;
    }
    const T log_at_zero = log(stiffness_) + log_gaussian_moment(order_, T(0));
    T d = log_at_zero > 0 ? T(sqrt(2 * log_at_zero)) : T(0);
    for (int iterations = 0; iterations < max_iterations; ++iterations) {
      const Asperities at = asperities(d);
      const T step = log(at.share) / -at.log_slope;
      if (!(step < 0)) break;
      d += step;
      if (-step < epsilon<T>() * (d < 0 ? T(-d) : d)) break;
    }
    floor_argument_ = d > -offset_ ? d : T(-offset_);
    floor_ = offset_ + floor_argument_;
    floor_log_slope_ = asperities(floor_argument_).log_slope;
  }

  const Fraction& film_exponent() const { return film_->sharing_exponent; }  // e

  const FilmLaw* film_;
  Order order_;
  T exponent_;  // q
  T stiffness_;
  T offset_;
  T floor_{};
  T floor_argument_{};   // λ_b − δ, without the rounding of the difference
  T floor_log_slope_{};  // d ln A/dλ there
  bool has_floor_ = false;
};

// In double the numbers come from the engine (src/engine.hpp). Errors and failures are those of the
// template; roots keep load_sharing_contract.
template <>
class LoadSharing<double> {
 public:
  using Root = SharingRoot<double>;

  LoadSharing(AsperityModel model, double stiffness, double offset,
              const FilmLaw& film = hamrock_dowson_central_law);
  LoadSharing(AsperityModel, double, double, FilmLaw&&) = delete;

  double stiffness() const { return surface_.stiffness; }
  double offset() const { return surface_.offset; }
  bool has_floor() const { return surface_.hazard > 0; }
  double floor() const { return surface_.floor; }
  double asperity_share(double film_parameter) const;
  double asperity_share_slope(double film_parameter) const;
  LoadShares<double> shares_above_floor(double distance) const;
  double distance_above_floor(double fluid) const;
  double flooded_film_parameter(double film_parameter, double fluid_share) const;
  LoadShares<double> solve(double flooded_film_parameter) const;
  double film_parameter(double flooded_film_parameter) const;
  Root root(double flooded_film_parameter) const;
  LoadShares<double> shares_at(double flooded_film_parameter, const Root& root) const;

  AsperityModel model() const { return model_; }
  const FilmLaw& film() const { return *film_; }
  const detail::SurfaceNumbers<double>& surface() const { return surface_; }

 private:
  friend class MixedContact<double>;
  LoadSharing(AsperityModel model, const detail::SurfaceNumbers<double>& surface,
              const FilmLaw& film)
      : model_(model), film_(&film), surface_(surface) {}

  AsperityModel model_;
  const FilmLaw* film_;
  detail::SurfaceNumbers<double> surface_;
};

}  // namespace tribo
