// SPDX-License-Identifier: Apache-2.0
// Condition numbers in closed form: the sum of |∂ ln output/∂ ln input| over all inputs of a scene
// (as in the tables of reference/exact, which take differences), at least 1. Each logarithm is
// carried as its gradient; the chain rule follows model/README.md, sections 3 to 8. Near a floor
// the terms that cancel are taken out by hand.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "support/judge.hpp"
#include "tribo/contract.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {

// −F_n′/F_n = n F_{n−1}/F_n = d + F_{n+1}/F_n; φ/F_0 for n = 0.
template <class T>
T moment_hazard(Order order, const T& d) {
  const T moment = scaled_gaussian_moment(order, d);
  if (twice(order) >= 2)
    return value_of<T>(order) * scaled_gaussian_moment(lower(order), d) / moment;
  if (order == Order::zero)
    return (d > 0 ? T(1) : T(std::exp(-d * d / 2))) / (sqrt_two_pi<T>() * moment);
  return d + scaled_gaussian_moment(Order::three_halves, d) / moment;
}

// |d ln F_n/d ln d|
inline double moment_condition(Order order, double d) {
  const auto x = static_cast<long double>(d);
  return std::max(1.0, static_cast<double>(std::abs(x) * moment_hazard(order, x)));
}

// Of y: |∂ ln y/∂ ln r| + |∂ ln y/∂ ln γ|.
struct FilmRatioSlopes {
  double ratio, exponent;
};
inline FilmRatioSlopes film_ratio_slopes(StarvationClosure closure, long double r,
                                         long double gamma) {
  if (closure == StarvationClosure::flooded_inlet && r >= 1) return {0, 0};
  const auto slope = static_cast<double>(starvation_slope(closure, r, gamma));
  if (closure != StarvationClosure::damiens) return {slope, 0};
  // ln y = −ln(1 + r^γ)/γ, or −ln r − ln(1 + r^−γ)/γ
  const long double power = std::pow(r <= 1 ? r : 1 / r, gamma);
  return {slope, static_cast<double>(std::log1p(power) / gamma +
                                     power * std::abs(std::log(r)) / (1 + power))};
}
inline double film_ratio_condition(StarvationClosure closure, double r, double gamma) {
  const FilmRatioSlopes slopes =
      film_ratio_slopes(closure, static_cast<long double>(r), static_cast<long double>(gamma));
  return std::max(1.0, std::abs(slopes.ratio) + std::abs(slopes.exponent));
}

// Of the root λ(λ₀, K, δ): with a = −d ln A/d ln λ and w = 1 − A, implicit differentiation gives
// (w + 0.14 A a) d ln λ = w d ln λ₀ + 0.14 A (q d ln K + a (δ/λ) d ln δ).
struct RootSlopes {
  long double film, stiffness, offset;
};
inline RootSlopes root_slopes(AsperityModel model, long double offset,
                              const LoadShares<long double>& root) {
  const long double lambda = root.film_parameter;
  const long double a = lambda * sharing_exponent<long double>(model) *
                        moment_hazard(load_order(model), lambda - offset);
  const long double m = sharing_film_exponent<long double>() * root.asperity;
  const long double sum = root.fluid + m * a;
  if (!(m * a > 0)) return {1, 0, 0};
  return {root.fluid / sum, m * sharing_exponent<long double>(model) / sum,
          m * a * (offset / lambda) / sum};
}
inline double root_condition(AsperityModel model, long double offset,
                             const LoadShares<long double>& root) {
  const RootSlopes slopes = root_slopes(model, offset, root);
  return std::max(1.0, static_cast<double>(slopes.film + slopes.stiffness + slopes.offset));
}

inline double root_condition(AsperityModel model, double stiffness, double offset, double film0) {
  const LoadSharing<long double> sharing(model, static_cast<long double>(stiffness),
                                         static_cast<long double>(offset));
  return root_condition(model, static_cast<long double>(offset),
                        sharing.solve(static_cast<long double>(film0)));
}

// d ln x, as its components by the logarithms of the inputs.
class LogGradient {
 public:
  enum Input : std::size_t {
    load,
    speed,
    density,
    radius,
    sd,
    offset,
    modulus,
    body_radius,
    ellipticity,
    viscosity,
    pressure_viscosity,
    eyring_stress,
    supply,
    boundary,
    slide_roll,
    gamma,
    count
  };
  LogGradient() = default;
  LogGradient(Input input) { parts_[input] = 1; }  // NOLINT: of an input itself

  friend LogGradient operator+(LogGradient a, const LogGradient& b) {
    for (std::size_t i = 0; i < count; ++i) a.parts_[i] += b.parts_[i];
    return a;
  }
  friend LogGradient operator-(LogGradient a, const LogGradient& b) {
    for (std::size_t i = 0; i < count; ++i) a.parts_[i] -= b.parts_[i];
    return a;
  }
  friend LogGradient operator*(long double factor, LogGradient a) {
    for (long double& part : a.parts_) part = factor == 0 ? 0 : part * factor;
    return a;
  }
  double condition() const {
    long double sum = 0;
    for (const long double part : parts_) sum += std::abs(part);
    return static_cast<double>(sum > 1 ? sum : 1.0L);
  }

 private:
  std::array<long double, count> parts_{};
};

// Of each number of an operating point.
using Conditions = std::array<double, number_count>;

inline Conditions operating_point_conditions(const Scene& scene,
                                             const MixedContact<long double>& contact,
                                             const FloodedFilm<long double>& film,
                                             const InletState<long double>& inlet,
                                             const OperatingPoint<long double>& point) {
  using G = LogGradient;
  const auto model = scene.closures.asperity;
  const bool tripp = model == AsperityModel::greenwood_tripp;
  const bool has_supply = scene.supply.kind != SupplyKind::flooded;
  const long double q = sharing_exponent<long double>(model);
  const long double delta = contact.asperities().offset;
  const long double sd = contact.summit_height_sd();
  const auto hazard = [&](Order order, long double lambda) {
    return moment_hazard(order, lambda - delta);
  };
  const auto share_hazard = [&](long double lambda) {  // −d ln A/dλ
    return q * hazard(load_order(model), lambda);
  };

  const G area = 2.0L / 3 * (G(G::load) + G::body_radius - G::modulus);
  const G pressure = G(G::load) - area;
  const G roughness = G(G::density) + G::radius + G::sd;
  const G stiffness =
      (tripp ? 2.0L : 1.0L) * roughness + 0.5L * (G(G::sd) - G::radius) + G::modulus - pressure;
  const long double k = static_cast<long double>(scene.bodies.ellipticity);
  const long double fade = 0.61L * std::exp(-0.73L * k);
  const G flooded = 0.67L * (G(G::viscosity) + G::speed - G::modulus - G::body_radius) +
                    0.53L * (G(G::pressure_viscosity) + G::modulus) -
                    0.067L * (G(G::load) - G::modulus - 2 * G(G::body_radius)) + G::body_radius +
                    (0.73L * k * fade / (1 - fade)) * G(G::ellipticity) - G::sd;  // ln λ₀

  // The root, and ln w there.
  const LoadShares<long double>& root = film.shares;
  const long double lambda_root = root.film_parameter;
  const RootSlopes slopes = root_slopes(model, delta, root);
  const G at_root =
      slopes.film * flooded + slopes.stiffness * stiffness + slopes.offset * G(G::offset);
  const long double root_hazard = share_hazard(lambda_root);
  const long double root_sum = root.fluid + 0.14L * root.asperity * root_hazard * lambda_root;
  // d ln A at the root is w times this.
  const G share_at_root = (1 / root_sum) * (q * stiffness + root_hazard * delta * G(G::offset) -
                                            root_hazard * lambda_root * flooded);

  // The film behind the inlet.
  G film_ratio;
  if (has_supply) {
    G over_inlet = at_root - G::supply;
    if (scene.supply.kind != SupplyKind::inlet_film_ratio) over_inlet = over_inlet + G::sd;
    if (scene.supply.kind == SupplyKind::inlet_flow) over_inlet = over_inlet + G::speed;
    const FilmRatioSlopes s = film_ratio_slopes(scene.closures.starvation, inlet.flooded_over_inlet,
                                                contact.damiens_exponent());
    film_ratio = static_cast<long double>(s.ratio) * over_inlet +
                 static_cast<long double>(s.exponent) * G(G::gamma);
  }
  const G lambda = at_root + film_ratio;
  const long double lambda_star = point.film_parameter;
  const bool on_floor = lambda_star < contact.sharing().floor();
  const long double lambda_apart = on_floor ? contact.sharing().floor() : lambda_star;
  G apart = lambda;
  if (on_floor) {
    const long double h = share_hazard(lambda_apart) * lambda_apart;
    apart = (1 / h) * (q * stiffness + (h * (delta / lambda_apart)) * G(G::offset));
  }

  // The shares: A d ln A and d ln (1 − A).
  const long double asperity = point.asperity_load_share, fluid = point.fluid_load_share;
  G share, fluid_share;
  if (!has_supply) {
    share = root.fluid * share_at_root;
    fluid_share = -root.asperity * share_at_root;
  } else if (fluid > 0) {
    const long double h = share_hazard(lambda_star);
    const long double lost = lambda_root - lambda_star;
    if (contact.sharing().has_floor() && root.fluid < 0.25L && lost < 1e-3L * lambda_root) {
      const long double d = lambda_root - delta;
      const long double n = tripp ? 2.5L : 1.5L;
      // h = q(n F_{n−1}/F_n), of which the derivative is h(h/q − d) − qn
      const long double change = -lambda_root *
                                 starvation_deficit(contact.closure(), inlet.flooded_over_inlet,
                                                    contact.damiens_exponent()) *
                                 (root_hazard * (root_hazard / q - d) - q * n);
      share = root.fluid * share_at_root + change * (delta * G(G::offset) - lambda_root * at_root) +
              (h * lost) * at_root - (h * lambda_star) * film_ratio;
    } else {
      share = q * stiffness + (h * delta) * G(G::offset) - (h * lambda_star) * lambda;
    }
    fluid_share = (-asperity / fluid) * share;
  }

  const G real_area =
      (tripp ? 2.0L : 1.0L) * roughness - hazard(tripp ? Order::two : Order::one, lambda_apart) *
                                              (lambda_apart * apart - delta * G(G::offset));
  const G summits = (tripp ? roughness : G()) + G::density + area -
                    hazard(tripp ? Order::one : Order::zero, lambda_apart) *
                        (lambda_apart * apart - delta * G(G::offset));

  // μ = μ_b A + τ (1 − A_r)/p̄
  G friction;
  const long double boundary =
      static_cast<long double>(scene.friction.boundary_coefficient.value_or(0)) * asperity;
  if (!point.friction_undefined && point.friction > 0) {
    const long double viscous = point.friction - boundary;
    friction = (boundary / point.friction) * (G(G::boundary) + share);
    if (viscous > 0) {
      const long double mean = contact.hertz().mean_pressure, carried = fluid * mean;
      const G carried_change = mean * (fluid * fluid_share) + carried * pressure;  // dp_L
      const auto eta = static_cast<long double>(scene.lubricant.viscosity);
      const auto alpha = static_cast<long double>(scene.lubricant.pressure_viscosity);
      const auto tau = static_cast<long double>(scene.lubricant.eyring_stress.value_or(1));
      G thickening;
      if (scene.friction.viscosity == ViscosityLaw::barus)
        thickening = alpha * carried_change + (alpha * carried) * G(G::pressure_viscosity);
      if (scene.friction.viscosity == ViscosityLaw::roelands) {
        const long double p_r = 1.96e8L, scale = std::log(eta) + 9.67L, z = alpha * p_r / scale;
        const long double b = std::log1p(carried / p_r), e = std::exp(z * b);
        thickening =
            std::expm1(z * b) * G(G::viscosity) +
            (scale * e * z / (p_r + carried)) * carried_change +
            (scale * e * z * b) * (G(G::pressure_viscosity) - (1 / scale) * G(G::viscosity));
      }
      const G rate = G(G::viscosity) - G::eyring_stress + G::slide_roll + G::speed - apart - G::sd +
                     thickening;
      const long double log_x = std::log(eta / tau) +
                                std::log(static_cast<long double>(scene.friction.slide_roll_ratio) *
                                         point.speed / (lambda_apart * sd)) +
                                log_viscosity_ratio(scene.friction.viscosity, eta, alpha, carried);
      const long double x = std::exp(std::min(log_x, 11000.0L));
      const long double response = scene.friction.fluid == FluidShear::limiting
                                       ? (x > 11000 ? 0 : x / std::expm1(x))
                                   : x > 1e9L ? 1 / (std::log(2.0L) + log_x)
                                              : x / (std::sqrt(1 + x * x) * std::asinh(x));
      friction = friction + (viscous / point.friction) *
                                (G(G::eyring_stress) + response * rate - pressure -
                                 (point.real_area_ratio / (1 - point.real_area_ratio)) * real_area);
    }
  }
  const G height(G::sd);
  const std::array<G, number_count> gradients{at_root + height, lambda + height, apart + height,
                                              lambda,           share,           fluid_share,
                                              real_area,        summits,         friction};
  const std::array<long double, number_count> values = numbers_of(point);
  Conditions conditions{};
  for (std::size_t i = 0; i < number_count; ++i)  // what is 0 to either side has no condition
    conditions[i] = values[i] == 0 ? 1 : gradients[i].condition();
  return conditions;
}

// `multiple` times what a contract allows, relative to the expected value. One ulp is the spacing
// of doubles there.
inline double allowed_by(const Contract& contract, const Reference& expected, double condition,
                         double multiple) {
  if (expected == 0) return 0;
  const double value = std::abs(static_cast<double>(expected));
  const double ulp = std::ldexp(1.0, std::max(std::ilogb(value), -1022) - 52);
  return multiple * std::max(contract.ulp, contract.ulp_per_condition * condition) * ulp / value;
}

// The condition numbers of a scene's outputs at a speed.
inline Conditions conditions_at(const Scene& scene, double speed) {
  const MixedContact<long double> contact(scene);
  const FloodedFilm<long double> film = contact.flooded(static_cast<long double>(speed));
  const InletState<long double> inlet = contact.inlet(film);
  return operating_point_conditions(scene, contact, film, inlet,
                                    contact.complete(film, inlet, OutputSet::all()));
}

}  // namespace tribo::verification
