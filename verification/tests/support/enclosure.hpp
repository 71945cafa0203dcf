// SPDX-License-Identifier: Apache-2.0
// The model's templates on Arb's real balls. Every operation of the same code is an enclosure, so
// that a result encloses the value of the formulas at the exact inputs.
//
// These run unchanged: all formulas of hertz.hpp, film_thickness.hpp, asperity_contact.hpp,
// friction.hpp, hertz_line.hpp and mixed_contact.hpp; all of hertz_ellipse.hpp but the shape; the
// shares of load_sharing.hpp; the closures of starvation.hpp and the step that refines ψ; the
// products with e^{−d²/2} of gaussian_moment.hpp.
//
// These are replaced, because a ball does not contain what an iteration or a sum leaves out:
//   scaled_gaussian_moment   by confluent hypergeometric functions (generators/moments.hpp). Other
//                            tests compare sums, series and continued fraction with tables.
//   bracketed_root           the model's own iteration on midpoints proposes a root. A certain
//                            change of sign of the model's own equation close to it proves the
//                            root, and all between the two signs is the enclosure.
//   LoadSharing: the root (root), the floor (find_floor), the way back from a share to a film
//                            (distance_above_floor): the same proof near the root in long double.
//                            The equations are those at the head of load_sharing.hpp, written out
//                            here; their A is the model's asperity_share.
//   the shape of an ellipse  the same proof of the model's equation in ln k, with Carlson's
//                            integrals in place of Bulirsch's.
//   LoadSharing: the Taylor series of 1 − A near the floor, by 1 − A itself: 320 bits are enough in
//                            spite of the cancellation.
// So each formula with its branches is checked here, and that the results of the iterations solve
// the equations; but not how fast or from where the iterations converge.
//
// On purpose the model drops 1/(4x²) of asinh x past x = 1/ε, which is less than 2^−600 of the
// value as ε = 2^−300 for this type. It takes e^{−d²/2} as 0 past d = 100000.
#pragma once

#include <arb.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "generators/ellipse_shape.hpp"
#include "generators/moments.hpp"
#include "tribo/bracketed_root.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/load_sharing.hpp"

template <>
class std::numeric_limits<tribo::reference::Ball> {
 public:
  static constexpr bool is_specialized = true;
  static tribo::reference::Ball epsilon() {
    return pow(tribo::reference::Ball(2), tribo::reference::Ball(-300));
  }
  static double quiet_NaN() { return numeric_limits<double>::quiet_NaN(); }
  // No ball underflows.
  static constexpr int min_exponent = -2000000000;
};

namespace tribo::verification {

using Enclosure = reference::Ball;

// The widths that a proof tries, in bits. The first is near the best that 320 bits can prove.
inline constexpr int proof_bits[] = {290, 270, 250, 220, 190, 160, 130};

// Undecided comparisons do not count during the life of this object: after a proof that fails, one
// with fewer bits is tried, and an exception tells if none succeeds.
class Proof {
 public:
  Proof() : before_(reference::undecided_comparisons) {}
  ~Proof() { reference::undecided_comparisons = before_; }
  Proof(const Proof&) = delete;
  Proof& operator=(const Proof&) = delete;

 private:
  std::uint64_t before_;
};

// The zero near `candidate` of a function that is certainly negative on one side of it and
// certainly positive on the other, at a distance of `scale`·2^−bits. Throws std::runtime_error if
// there is no such proof.
template <class Function>
Enclosure proven_zero(Function&& f, const Enclosure& candidate, const Enclosure& scale) {
  for (const int bits : proof_bits) {
    const Enclosure step = (scale * pow(Enclosure(2), Enclosure(-bits))).midpoint();
    const Enclosure below = f((candidate - step).midpoint());
    const Enclosure above = f((candidate + step).midpoint());
    if (!((below < 0 && above > 0) || (below > 0 && above < 0))) continue;
    Enclosure zero;
    arb_union(zero.get(), (candidate - step).midpoint().get(), (candidate + step).midpoint().get(),
              reference::ball_precision);
    return zero;
  }
  throw std::runtime_error("no change of sign is certain near " + candidate.decimal(20));
}

// Adds step(x) to x until a step is below least(x), but at most 60 times.
template <class Step, class Least>
Enclosure refined(Enclosure x, Step&& step, Least&& least) {
  for (int i = 0; i < 60; ++i) {
    const Enclosure by = Enclosure(step(x)).midpoint();
    x = (x + by).midpoint();
    if (abs(by) < least(x)) break;
  }
  return x;
}

inline AsperityModel model_of(Order load_order) {
  return load_order == Order::five_halves ? AsperityModel::greenwood_tripp
                                          : AsperityModel::greenwood_williamson;
}

inline long double as_long_double(const Enclosure& x) {
  const double high = x.nearest();
  return static_cast<long double>(high) +
         (std::isfinite(high) ? static_cast<long double>((x - high).nearest()) : 0);
}
inline Enclosure as_enclosure(long double x) {
  int exponent = 0;
  const long double mantissa = std::frexp(x, &exponent);  // two doubles hold it
  const double high = static_cast<double>(mantissa);
  Enclosure value =
      Enclosure(high) + Enclosure(static_cast<double>(mantissa - static_cast<long double>(high)));
  arb_mul_2exp_si(value.get(), value.get(), exponent);
  return value;
}

// An upper bound on |got − truth|, in a given unit.
inline double error_in(const Enclosure& unit, const Enclosure& got, const Enclosure& truth) {
  return Enclosure(abs(got - truth) / unit).upper_bound();
}

// An upper bound on |got − truth| in ulp of the truth (one subnormal unit at least).
inline double error_in_ulp(double got, const Enclosure& truth) {
  const double nearest = truth.nearest();
  if (!std::isfinite(got))
    return got == nearest ? 0 : std::numeric_limits<double>::infinity();  // both past the largest
  const double unit = nearest == 0 || !std::isfinite(nearest)
                          ? std::numeric_limits<double>::denorm_min()
                          : std::max(std::numeric_limits<double>::denorm_min(),
                                     std::ldexp(1.0, std::ilogb(nearest) - 52));
  return error_in(unit, Enclosure(got), truth);
}
inline double error_in_ulp(long double got, const Enclosure& truth) {
  if (!std::isfinite(got)) return std::numeric_limits<double>::infinity();
  if (got == 0) return truth == 0 ? 0 : std::numeric_limits<double>::infinity();
  return error_in(as_enclosure(std::ldexp(1.0L, std::ilogb(got) - 63)), as_enclosure(got), truth);
}

// Is the radius at most `relative_radius` of the midpoint, counted in whole bits?
inline bool is_narrow(const Enclosure& x, double relative_radius) {
  return is_finite(x) &&
         (x == 0 || static_cast<double>(x.accurate_bits()) >= -std::log2(relative_radius));
}

}  // namespace tribo::verification

namespace tribo::reference {

// A whole number within 1 of the midpoint. The model splits d there, and may do so anywhere.
inline Ball trunc(const Ball& x) { return Ball(std::trunc(x.nearest())); }

// S_n(d ± ρ) lies within S_n(d) e^{±sρ}, s = (n+1)/(d−ρ) where d − ρ > 1, else n + 2. Let h_n be
// −F_n′/F_n. For d ≥ 0, (ln S_n)′ = d − h_n lies between 0 and −(n+1)/d, as h_n − d = F_{n+1}/F_n =
// (n+1)/h_{n+1} and h_{n+1} > d; it is above −(n+2). For d < 0, S_n is F_n, and 0 < h_n < n+2.
inline Ball scaled_gaussian_moment(Order order, const Ball& d) {
  const Ball middle = d.midpoint();
  Ball value = scaled_moment_by_hypergeometric(twice(order), middle);
  if (middle < 0) value *= exp(-middle * middle / 2);
  Ball radius;
  arb_get_rad_arb(radius.get(), d.get());
  const Ball n = fraction(twice(order), 2);
  const Ball slope = middle - radius > 1 ? (n + 1) / (middle - radius) : n + 2;
  const Ball widening = abs(value) * expm1(slope * radius);
  arb_add_error(value.get(), widening.get());
  return value;
}

template <class Function>
Ball bracketed_root(Function&& f, Ball low, Ball high, const Ball& least_width) {
  const verification::Proof proof;
  const Ball candidate =
      tribo::bracketed_root<Ball>([&](const Ball& x) { return f(x.midpoint()).midpoint(); }, low,
                                  high, least_width)
          .midpoint();
  return verification::proven_zero(f, candidate, abs(candidate) + 1);
}

}  // namespace tribo::reference

namespace tribo {

template <>
inline void LoadSharing<reference::Ball>::find_floor() {
  using reference::Ball;
  has_floor_ = moment_product(stiffness_, order_, Ball(-offset_)) >= 1;
  floor_ = 0;
  if (!has_floor_) return;
  const verification::Proof proof;
  const long double offset = verification::as_long_double(offset_);
  const LoadSharing<long double> near(verification::model_of(order_),
                                      verification::as_long_double(stiffness_), offset);
  const Ball d = verification::refined(
      verification::as_enclosure(near.floor() - offset),
      [&](const Ball& x) {
        const Asperities at = asperities(x);
        return log(at.share) / -at.log_slope;
      },
      [](const Ball& x) { return (abs(x) + 1) * epsilon<Ball>(); });
  floor_argument_ = verification::proven_zero([&](const Ball& x) { return share_at(x) - 1; }, d,
                                              abs(d) + Ball(1e-10));
  floor_ = offset_ + floor_argument_;
  floor_log_slope_ = asperities(floor_argument_).log_slope;
}

template <>
inline LoadSharing<reference::Ball>::Root LoadSharing<reference::Ball>::root(
    const reference::Ball& flooded_film_parameter) const {
  using reference::Ball;
  const Ball& lambda0 = flooded_film_parameter;
  const auto proven = [&] {
    const verification::Proof proof;
    const LoadSharing<long double> near(verification::model_of(order_),
                                        verification::as_long_double(stiffness_),
                                        verification::as_long_double(offset_), *film_);
    const Ball exponent = ratio<Ball>(film_exponent());
    const Ball p = 1 / exponent;
    const Ball lambda = verification::refined(
        verification::as_enclosure(
            near.solve(verification::as_long_double(lambda0)).film_parameter),
        [&](const Ball& x) {
          const Asperities at = asperities(Ball(x - offset_));
          const Ball fluid = pow(lambda0 / x, p);
          return (at.share + fluid - 1) / (p * fluid / x - at.share * at.log_slope);
        },
        [](const Ball& x) { return x * epsilon<Ball>(); });
    // ln λ − ln λ₀ + e ln(1 − A). It is −∞ where A ≥ 1, for which −1 stands.
    const auto residual = [&](const Ball& x) {
      const Ball share = asperity_share(x);
      if (share >= 1) return Ball(-1);
      return log(x / lambda0) + exponent * log1p(-share);
    };
    return verification::proven_zero(residual, lambda, lambda);
  }();
  return {proven, 0};
}

// Unlike the model, this does not ask if λ₀ or the floor is infinite: a ball cannot answer that.
template <>
inline LoadShares<reference::Ball> LoadSharing<reference::Ball>::shares_at(
    const reference::Ball& flooded_film_parameter, const Root& root) const {
  return shares(flooded_film_parameter, root.film_parameter, 0);
}

// Below a distance of 2^−130 the difference 1 − A would cancel. There ln A is the integral of its
// slope from the floor on, which lies between the slopes at the two ends times the distance.
template <>
inline reference::Ball LoadSharing<reference::Ball>::fluid_share_near_floor(
    const reference::Ball& distance) const {
  using reference::Ball;
  const verification::Proof proof;
  if (!(abs(distance) < pow(Ball(2), Ball(-130))))
    return 1 - share_at(argument_above_floor(distance));
  Ball between = floor_argument_;
  const Ball reach = abs(distance);
  arb_add_error(between.get(), reach.get());
  return -expm1(distance * asperities(between).log_slope);
}

template <>
inline reference::Ball LoadSharing<reference::Ball>::distance_above_floor(
    const reference::Ball& fluid) const {
  using reference::Ball;
  const verification::Proof proof;
  if (fluid < pow(Ball(2), Ball(-110))) {
    Ball between = floor_argument_;
    const Ball reach = 2 * fluid / -floor_log_slope_;
    arb_add_error(between.get(), reach.get());
    return log1p(-fluid) / asperities(between).log_slope;
  }
  const Ball distance =
      verification::refined((fluid / -floor_log_slope_).midpoint(),
                            [&](const Ball& x) {
                              const Asperities at = asperities(Ball(floor_argument_ + x));
                              return (fluid - 1 + at.share) / (-at.share * at.log_slope);
                            },
                            [](const Ball& x) { return x * epsilon<Ball>(); });
  return verification::proven_zero([&](const Ball& x) { return fluid_share_near_floor(x) - fluid; },
                                   distance, distance);
}

template <>
inline EllipseShape<reference::Ball> detail::wide_shape<reference::Ball>(
    const reference::Ball& radius_ratio) {
  using reference::Ball;
  const verification::Proof proof;
  const auto residual = [&](const Ball& log_k) {
    const reference::Associated at = reference::associated(exp(log_k));
    return log(at.k * at.k * at.b / at.d / radius_ratio);
  };
  const Ball h = pow(Ball(2), Ball(-120));
  const Ball log_k = verification::refined(
      verification::as_enclosure(
          std::log(ellipse_shape(verification::as_long_double(radius_ratio)).ellipticity)),
      [&](const Ball& x) {
        const Ball value = residual(x);
        return -value * h / (residual((x + h).midpoint()) - value);
      },
      [](const Ball&) { return pow(Ball(2), Ball(-250)); });
  const Ball k = exp(verification::proven_zero(residual, log_k, 1));
  const reference::Associated at = reference::associated(k);
  return {k, at.b + at.d, at.b + at.d / (k * k)};
}

}  // namespace tribo
