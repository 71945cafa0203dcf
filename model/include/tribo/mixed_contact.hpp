// SPDX-License-Identifier: Apache-2.0
// The whole model for one scene (model/README.md): prepared once, then asked at any speed.
//
//   u → λ₀ → λ (load_sharing) → r = h_ff/h_oil → y = h*/h_ff (starvation) → shares, area, friction
//
// Only the outputs that are asked for are computed. No allocation, no exception, no state.
#pragma once

#include "tribo/asperity_contact.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/friction.hpp"
#include "tribo/hertz_contact.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/moes_film.hpp"
#include "tribo/operating_point.hpp"
#include "tribo/scene.hpp"
#include "tribo/solved_inlet.hpp"
#include "tribo/starvation.hpp"
#include "tribo/thermal_reduction.hpp"

namespace tribo {

// The fully flooded film with its load shares, at a speed.
template <class T>
struct FloodedFilm {
  T speed;               // u, m/s
  LoadShares<T> shares;  // λ = h_ff/σ_s, A, 1 − A
};

// The effect of the inlet on the flooded film.
template <class T>
struct InletState {
  T film_ratio;          // y = h*/h_ff
  T flooded_over_inlet;  // r = h_ff/h_oil; 0 without a supply
  bool collapsed;
};

namespace detail {

// The film of a scene's contact by a law without fixed exponents, over `height` in m.
template <class T>
MoesFilm<T> moes_film(const FilmLaw& law, ContactShape shape, const SceneNumbers<T>& scene,
                      const T& height) {
  const bool is_line = shape == ContactShape::line;
  return {law,
          scene.viscosity,
          scene.pressure_viscosity,
          is_line ? T(scene.load * scene.radius_x / scene.across) : scene.load,
          scene.effective_modulus,
          scene.radius_x,
          shape == ContactShape::ellipse ? T(scene.radius_x / scene.across) : T(1),
          height};
}

}  // namespace detail

class MixedContacts;

template <class T>
class MixedContact {
 public:
  // The scene's fields must be in range (scene_reader.hpp sees to it).
  explicit MixedContact(const Scene& scene) : MixedContact(scene, film_law(scene)) {}

  // Takes a film law that need not be one of those that scenes can name.
  MixedContact(const Scene& scene, const FilmLaw& film)
      : MixedContact(detail::words_of(scene, film), detail::numbers_of<T>(scene)) {}
  MixedContact(const Scene&, FilmLaw&&) = delete;

  // Takes the words and numbers that were read out of a scene.
  MixedContact(const detail::ContactWords& words, const detail::SceneNumbers<T>& scene)
      : load_(scene.load),
        summit_height_sd_(scene.summit_height_sd),
        lubricant_{scene.viscosity, scene.pressure_viscosity, scene.eyring_stress},
        boundary_coefficient_(scene.boundary_coefficient),
        slide_roll_ratio_(scene.slide_roll_ratio),
        fluid_(words.fluid),
        viscosity_law_(words.viscosity),
        thermal_(words.thermal),
        supply_(words.supply),
        inlet_law_(detail::inlet_law(words, scene)),
        film_(words.film),
        effective_modulus_(scene.effective_modulus),
        conductivity_(scene.conductivity),
        temperature_coefficient_(scene.temperature_coefficient),
        supply_value_(scene.supply),
        hertz_(hertz_contact(words.shape, scene)),
        asperities_(asperity_contact(words.model, scene.summit_density, scene.summit_radius,
                                     summit_height_sd_,
                                     T(scene.offset_planes * scene.summit_plane_offset),
                                     scene.effective_modulus, hertz_.nominal_area, load_)),
        sharing_(asperities_.model, asperities_.stiffness, asperities_.offset, *film_),
        moes_film_(detail::moes_film(*film_, words.shape, scene, summit_height_sd_)),
        film_parameter_at_unit_speed_(
            film_->has_fixed_exponents()
                ? T(film_thickness(
                        *film_, T(1), lubricant_.viscosity, lubricant_.pressure_viscosity,
                        words.shape == ContactShape::line ? T(load_ * scene.radius_x / scene.across)
                                                          : load_,
                        scene.effective_modulus, scene.radius_x, scene.ellipticity) /
                    summit_height_sd_)
                : moes_film_.at(T(1), T(1)).film_parameter) {}

  const HertzContact<T>& hertz() const { return hertz_; }
  const AsperityContact<T>& asperities() const { return asperities_; }
  const LoadSharing<T>& sharing() const { return sharing_; }
  const FilmLaw& film() const { return *film_; }
  const InletLaw<T>& inlet_law() const { return inlet_law_; }
  // The law of the inlet at a speed in m/s and at r. For the closure `solved` it is Damiens' law
  // with the γ that the table of solved starved films has there; this γ is NaN beyond the table.
  InletLaw<T> inlet_law(const T& speed, const T& r) const {
    using std::log;
    if (inlet_law_.closure != StarvationClosure::solved) return inlet_law_;
    const auto [load, material] = moes_film_.numbers(speed, T(1));
    return {StarvationClosure::damiens,
            solved_inlet_exponent(inlet_table(), T(log(load)), material, T(log(r)))};
  }
  const T& summit_height_sd() const { return summit_height_sd_; }
  SupplyKind supply() const { return supply_; }
  // q of a scene with inlet_flow, m²/s.
  const T& inlet_flow() const { return supply_value_; }

  // h_oil/σ_s at speed u in m/s. To be called only where the scene has a supply; u matters only
  // with inlet_flow.
  T inlet_film_parameter(const T& speed) const {
    if (supply_ == SupplyKind::inlet_film_ratio) return supply_value_;
    const T inlet_film =
        supply_ == SupplyKind::inlet_flow ? T(supply_value_ / speed) : supply_value_;
    return inlet_film / summit_height_sd_;
  }

  // λ₀ = h₀/σ_s at speed u in m/s; where the scene asks for a heated inlet, the heat makes h₀
  // thinner. speed_at() gives the speed at which an inlet that is not heated reaches a given λ₀.
  T flooded_film_parameter(const T& speed) const {
    const T isothermal =
        film_->has_fixed_exponents()
            ? T(film_parameter_at_unit_speed_ * decimal_power(speed, film_->speed_exponent))
            : moes_film_.at(speed, T(1)).film_parameter;
    if (thermal_ == ThermalInlet::none) return isothermal;
    return isothermal * heat_at(speed);
  }
  T speed_at(const T& flooded_film_parameter) const {
    return speed_at(LoadShares<T>{flooded_film_parameter, T(0), T(1), 0});
  }
  // The speed in m/s at which an inlet that is not heated makes the flooded film with these shares;
  // NaN beyond a table of solved films.
  T speed_at(const LoadShares<T>& shares) const {
    using std::exp;
    using std::log;
    if (film_->has_fixed_exponents())
      return decimal_power(T(sharing_.flooded_film_parameter(shares.film_parameter, shares.fluid) /
                             film_parameter_at_unit_speed_),
                           inverse(film_->speed_exponent));
    const T stiffening = 1 / shares.fluid;
    const auto excess = [&](const T& log_speed) {
      return log(T(moes_film_.continued(exp(log_speed), stiffening).film_parameter /
                   shares.film_parameter));
    };
    // The film rises at least as fast as the square root of the speed (test analytic.MoesFilm).
    const T start = excess(T(0));
    const T root = bracketed_root(excess, start > 0 ? T(-2 * start - 1) : T(0),
                                  start > 0 ? T(0) : T(1 - 2 * start), epsilon<T>());
    const auto there = moes_film_.continued(exp(root), stiffening);
    if (!there.is_known) return quiet_nan<T>();
    return exp(T(root - excess(root) / there.speed_exponent));
  }
  // d ln λ₀/d ln u and d ln λ₀/d ln γ at a film; the heat of a heated inlet is left out.
  FilmExponents<T> film_exponents(const FloodedFilm<T>& flooded) const {
    if (film_->has_fixed_exponents() || !(flooded.shares.fluid > 0))
      return {ratio<T>(film_->speed_exponent), ratio<T>(film_->sharing_exponent)};
    const auto at = moes_film_.at(flooded.speed, T(1 / flooded.shares.fluid));
    return {at.speed_exponent, at.sharing_exponent};
  }

  FloodedFilm<T> flooded(const T& speed) const {
    if (film_->has_fixed_exponents()) return {speed, sharing_.solve(flooded_film_parameter(speed))};
    const T heat = thermal_ == ThermalInlet::none ? T(1) : heat_at(speed);
    return {speed, sharing_.solve_by([&](const T& stiffening) {
              auto at = moes_film_.continued(speed, stiffening);
              at.film_parameter *= heat;
              return at;
            })};
  }

  InletState<T> inlet(const FloodedFilm<T>& film) const {
    if (supply_ == SupplyKind::flooded) return {T(1), T(0), false};
    const T r = film.shares.film_parameter / inlet_film_parameter(film.speed);
    const bool collapsed = inlet_law_.closure == StarvationClosure::flooded_inlet && r >= 1;
    if (collapsed) return {T(0), r, true};
    return {inlet_law(film.speed, r).film_ratio(r), r, false};
  }

  // All outputs of a set at speed u > 0 in m/s.
  OperatingPoint<T> solve(const T& speed, OutputSet outputs = OutputSet::all()) const {
    const FloodedFilm<T> film = flooded(speed);
    return complete(film, inlet(film), outputs);
  }

  // All outputs of a set, from a film and inlet that are known already.
  OperatingPoint<T> complete(const FloodedFilm<T>& flooded, const InletState<T>& inlet,
                             OutputSet outputs) const {
    LoadShares<T> shares{};
    if (needs_shares(outputs))
      shares = supply_ == SupplyKind::flooded ? flooded.shares : starved_shares(flooded, inlet);
    return complete(flooded, inlet, shares, outputs);
  }

  // The same, where the shares at the starved film are known, too.
  OperatingPoint<T> complete(const FloodedFilm<T>& flooded, const InletState<T>& inlet,
                             const LoadShares<T>& shares, OutputSet outputs) const {
    OperatingPoint<T> point;
    point.speed = flooded.speed;
    const T& lambda_flooded = flooded.shares.film_parameter;
    const T lambda = lambda_flooded * inlet.film_ratio;
    const T lambda_apart = lambda < sharing_.floor() ? sharing_.floor() : lambda;
    if (outputs.contains(Output::film_flooded))
      point.film_flooded = lambda_flooded * summit_height_sd_;
    if (outputs.contains(Output::film)) point.film = lambda * summit_height_sd_;
    if (outputs.contains(Output::separation)) point.separation = lambda_apart * summit_height_sd_;
    if (outputs.contains(Output::film_parameter)) point.film_parameter = lambda;
    if (outputs.contains(Output::inlet))
      point.inlet = inlet.collapsed                         ? Inlet::collapsed
                    : inlet.film_ratio >= ratio<T>(95, 100) ? Inlet::flooded
                                                            : Inlet::starved;
    const bool has_collapsed = inlet.collapsed && lambda_apart == 0;
    if (outputs.contains_any(balance_outputs())) add_shares(point, shares, has_collapsed);
    const bool is_stiff_film = is_stiff(flooded);
    if (outputs.contains_any(area_outputs()))
      point.real_area_ratio = moment_at(asperities_.area_factor, area_order(asperities_.model),
                                        lambda_apart, shares.asperity, is_stiff_film);
    if (outputs.contains(Output::summit_count))
      point.summit_count = moment_at(asperities_.count_factor, count_order(asperities_.model),
                                     lambda_apart, shares.asperity, is_stiff_film);
    if (outputs.contains(Output::friction)) add_friction(point, lambda_apart, has_collapsed);
    return point;
  }

  // The shares at the starved film λ*: A(λ*), or A = 1 at the floor and below. Near a floor the
  // flooded film's fluid share gives λ − λ_b, and λ* − λ_b is this minus λ(1 − y). So no nearly
  // equal numbers are subtracted. Farther from a high floor A(λ*) follows from A(λ). The deficit is
  // 1 − y.
  LoadShares<T> starved_shares(const FloodedFilm<T>& flooded, const InletState<T>& inlet) const {
    const bool is_by_deficit = is_near_floor(flooded) || is_stiff(flooded);
    const T& r = inlet.flooded_over_inlet;
    return starved_shares(flooded, inlet,
                          is_by_deficit ? inlet_law(flooded.speed, r).deficit(r) : T(0));
  }
  LoadShares<T> starved_shares(const FloodedFilm<T>& flooded, const InletState<T>& inlet,
                               const T& deficit) const {
    const T& lambda_flooded = flooded.shares.film_parameter;
    const T lambda = lambda_flooded * inlet.film_ratio, fall = lambda_flooded * deficit;
    T distance = lambda - sharing_.floor();
    if (is_near_floor(flooded)) {
      distance = sharing_.distance_above_floor(flooded.shares.fluid) - fall;
    } else if (is_stiff(flooded)) {
      const T asperity = sharing_.share_below(flooded.shares, fall);
      if (asperity < 1) return {lambda, asperity, 1 - asperity, 0};
      return {lambda, T(1), T(0), 0};
    }
    if (sharing_.has_floor() && !(distance > 0)) return {lambda, T(1), T(0), 0};
    return sharing_.shares_above_floor(distance);
  }

 private:
  // The part of λ₀ that the heat of the inlet leaves.
  T heat_at(const T& speed) const {
    return gupta_thermal_reduction(hertz_.peak_pressure, effective_modulus_, slide_roll_ratio_,
                                   temperature_coefficient_, lubricant_.viscosity, speed,
                                   conductivity_);
  }

  bool is_near_floor(const FloodedFilm<T>& flooded) const {
    return sharing_.has_floor() && flooded.shares.fluid < ratio<T>(1, 4);
  }
  // Do moments and starved shares follow from A, and not from the rounded λ? The limit is the
  // engine's stiff_film.
  bool is_stiff(const FloodedFilm<T>& flooded) const {
    return sharing_.is_stiff(flooded.shares, T(6));
  }

  // The moments need the shares, too, where the floor is high.
  bool needs_shares(OutputSet outputs) const {
    return outputs.contains_any(balance_outputs()) ||
           (has_high_floor() && outputs.contains_any(moment_outputs()));
  }

  struct Fluid {
    T viscosity, pressure_viscosity, eyring_stress;
  };

  static constexpr OutputSet only(Output output) {
    OutputSet set;
    set.insert(output);
    return set;
  }
  static constexpr OutputSet moment_outputs() {
    OutputSet set = area_outputs();
    set.insert(Output::summit_count);
    return set;
  }
  static constexpr OutputSet area_outputs() {
    OutputSet set = only(Output::real_area_ratio);
    set.insert(Output::friction);
    return set;
  }

  // ln F_n(λ − δ) falls as (λ − δ)²/2, so that the rounding of λ moves F_n by up to λ²/2 ulp: by a
  // few at a floor of 3, by dozens beyond.
  bool has_high_floor() const { return sharing_.floor() > 3 && is_finite(sharing_.floor()); }

  // factor · F_n(λ − δ). Near a high floor it is computed from A (`share` has to be set there),
  // because A is more exact than λ: F_p is A^{1/q}/K, and F_n/F_p hardly depends on d.
  T moment_at(const T& factor, Order n, const T& film_parameter, const T& share,
              bool is_stiff_film) const {
    const T d = film_parameter - asperities_.offset;
    const bool is_high = is_stiff_film || (has_high_floor() && share > ratio<T>(3, 4));
    if (!is_high) return moment_product(factor, n, d);
    const Order p = load_order(asperities_.model);
    const T load = p == Order::five_halves ? T(share * share) : share;
    return factor * (load / asperities_.stiffness) *
           (scaled_gaussian_moment(n, d) / scaled_gaussian_moment(p, d));
  }

  // Without a film and a floor nothing balances the load. A(0) < 1 is then no load share.
  static void add_shares(OperatingPoint<T>& point, const LoadShares<T>& shares,
                         bool has_collapsed) {
    if (has_collapsed) {
      point.asperity_load_share = point.fluid_load_share = quiet_nan<T>();
      point.regime = Regime::collapsed;
      return;
    }
    point.asperity_load_share = shares.asperity;
    point.fluid_load_share = shares.fluid;
    point.regime = regime_of(shares.asperity, shares.fluid);
  }

  // μ = μ_b A + τ (1 − A_r/A_nom)/p̄
  void add_friction(OperatingPoint<T>& point, const T& separation_over_sd,
                    bool has_collapsed) const {
    if (has_collapsed) {
      point.friction = quiet_nan<T>();
      return;
    }
    point.friction = boundary_coefficient_ * point.asperity_load_share;
    const T fluid_area = 1 - point.real_area_ratio;
    if (!(fluid_area > 0)) return;
    const T pressure = point.fluid_load_share * hertz_.mean_pressure;
    const T log_thickening = log_viscosity_ratio(viscosity_law_, lubricant_.viscosity,
                                                 lubricant_.pressure_viscosity, pressure);
    const T stress = fluid_shear_stress(fluid_, lubricant_.eyring_stress, lubricant_.viscosity,
                                        log_thickening, T(slide_roll_ratio_ * point.speed),
                                        T(separation_over_sd * summit_height_sd_));
    point.friction += stress * fluid_area / hertz_.mean_pressure;
  }

  T load_;
  T summit_height_sd_;
  Fluid lubricant_;
  T boundary_coefficient_;
  T slide_roll_ratio_;
  FluidShear fluid_;
  ViscosityLaw viscosity_law_;
  ThermalInlet thermal_;
  SupplyKind supply_;
  InletLaw<T> inlet_law_;
  const FilmLaw* film_;
  T effective_modulus_, conductivity_, temperature_coefficient_;  // of a heated inlet
  T supply_value_;
  HertzContact<T> hertz_;
  AsperityContact<T> asperities_;
  LoadSharing<T> sharing_;
  MoesFilm<T> moes_film_;           // of a law without fixed exponents
  T film_parameter_at_unit_speed_;  // λ₀/u^a
};

// In double the numbers come from the engine (src/engine.hpp): a point has the same bits alone and
// in a batch of any size, on every x86-64 with fused multiply-add. Where the engine's range might
// not be enough (src/sharing_method.hpp), the numbers are those of the template in long double,
// rounded. Error: operating_point_contract; near 0, where doubles are subnormal, their spacing.
template <>
class MixedContact<double> {
 public:
  explicit MixedContact(const Scene& scene);
  MixedContact(const Scene& scene, const FilmLaw& film);
  MixedContact(const Scene&, FilmLaw&&) = delete;

  HertzContact<double> hertz() const;
  AsperityContact<double> asperities() const {
    return {words_.model, numbers_.surface.stiffness, numbers_.surface.offset, numbers_.area_factor,
            numbers_.count_factor};
  }
  LoadSharing<double> sharing() const { return {words_.model, numbers_.surface, film()}; }
  const FilmLaw& film() const { return *words_.film; }
  InletLaw<double> inlet_law() const { return detail::inlet_law(words_, numbers_); }
  double summit_height_sd() const { return numbers_.summit_height_sd; }
  SupplyKind supply() const { return words_.supply; }
  double inlet_flow() const { return numbers_.supply; }
  double inlet_film_parameter(double speed) const;
  double flooded_film_parameter(double speed) const;
  double speed_at(double flooded_film_parameter) const;
  double speed_at(const LoadShares<double>& shares) const;
  FilmExponents<double> film_exponents(const FloodedFilm<double>& flooded) const;

  FloodedFilm<double> flooded(double speed) const;
  InletState<double> inlet(const FloodedFilm<double>& film) const;
  OperatingPoint<double> solve(double speed, OutputSet outputs = OutputSet::all()) const;
  OperatingPoint<double> complete(const FloodedFilm<double>& flooded,
                                  const InletState<double>& inlet, OutputSet outputs) const;

  const detail::ContactWords& words() const { return words_; }
  const detail::ContactNumbers<double>& numbers() const { return numbers_; }
  const detail::SceneNumbers<double>& scene_numbers() const { return scene_; }
  // The same contact in another number type, from the same scene.
  template <class T>
  MixedContact<T> in() const {
    auto numbers = detail::numbers_in<T>(scene_);
    if (words_.shape == ContactShape::ellipse) numbers.set_ellipse();
    return MixedContact<T>(words_, numbers);
  }

 private:
  friend class MixedContacts;
  bool is_within_engine(double speed) const;
  MixedContact(const detail::ContactWords& words, const detail::SceneNumbers<double>& scene,
               const detail::ContactNumbers<double>& numbers)
      : words_(words), scene_(scene), numbers_(numbers) {}

  detail::ContactWords words_;
  detail::SceneNumbers<double> scene_;
  detail::ContactNumbers<double> numbers_;
};

}  // namespace tribo
