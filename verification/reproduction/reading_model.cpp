// SPDX-License-Identifier: Apache-2.0
#include "reproduction/reading_model.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "tribo/batch.hpp"
#include "tribo/bracketed_root.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"
#include "tribo/stribeck_walk.hpp"

namespace tribo::reproduction {
namespace {

bool is_gt(const Scene& scene) { return scene.closures.asperity == AsperityModel::greenwood_tripp; }

double nominal_area(const Scene& scene, const Reading& reading) {
  const HertzPoint<double> hertz =
      hertz_point(scene.load, scene.bodies.effective_modulus, scene.bodies.reduced_radius);
  return reading.is(Switch::nominal_area, 1) ? hertz.radius * hertz.radius : hertz.nominal_area;
}

// The switches of the prefactor and of two rough faces apply to GT only (the paper prints no
// prefactor of GW).
AsperityContact<double> asperities_of(const Scene& scene, const Reading& reading) {
  // β is printed as 0.1 µm, but all three printed products nβσ_s need 10 µm.
  const double radius =
      scene.surface.summit_radius * (reading.is(Switch::summit_radius, 1) ? 0.01 : 1);
  const double planes = is_gt(scene) ? offset_planes[reading.at(Switch::offset_planes)] : 1;
  AsperityContact<double> contact =
      asperity_contact(scene.closures.asperity, scene.surface.summit_density, radius,
                       scene.surface.summit_height_sd, planes * scene.surface.summit_plane_offset,
                       scene.bodies.effective_modulus, nominal_area(scene, reading), scene.load);
  if (is_gt(scene) && reading.is(Switch::asperity_prefactor, 1)) contact.stiffness /= 2;
  return contact;
}

// The circular contact's gap is 4/π times the line contact's, and its c is π/4 times as great.
InletCurve<double> curve_of(const Reading& reading) {
  const StarvationClosure closure = reading.inlet() == InletRule::as_printed
                                        ? StarvationClosure::flooded_inlet
                                        : static_cast<StarvationClosure>(reading.inlet());
  return {closure, reading.is(Switch::gap, 1) ? std::numbers::pi / 4 : 1};
}

// The nodes of InletLengths. The paper's films lie within them at all its speeds.
constexpr double least_log_r = -12, greatest_log_r = 4, nodes_a_unit = 32;

// E11: equations 1.12 to 1.14 as printed give h*/h_oil = (2/π) arctan(2.7ψ) and
// h_oil/h* = 1 + ψ^{3/2}/c, so that the ratio does not depend on the flooded film.
double printed_constant(const InletCurve<double>& curve) {
  const double length =
      bracketed_root([&](double t) { return curve.log_film_ratio(t) + curve.log_inverse_r(t); },
                     -20.0, 20.0, epsilon<double>());
  return wolveridge_film_ratio(std::exp(length));
}

}  // namespace

FrictionLaw friction_law(const Reading& reading) {
  return {static_cast<FluidShear>(reading.at(Switch::shear)),
          static_cast<ViscosityLaw>(reading.at(Switch::viscosity))};
}

FilmLaw film_law(const Reading& reading) {
  FilmLaw law = hamrock_dowson_central_law;
  law.speed_modulus -= reading.at(Switch::speed_modulus);
  law.material_modulus -= reading.at(Switch::material_modulus);
  law.load_modulus -= reading.at(Switch::load_modulus);
  law.speed_multiple += reading.at(Switch::speed);
  if (reading.is(Switch::film_constant, 1)) law.side_leakage = {0, 1};
  return law;
}

InletLengths::InletLengths(const InletCurve<double>& curve) : curve_(curve) {
  for (int node = 0; node <= (greatest_log_r - least_log_r) * nodes_a_unit; ++node) {
    const double t = curve.log_inlet_length(std::exp(least_log_r + node / nodes_a_unit));
    log_length_.push_back(t);
    step_slope_.push_back(-1 / (nodes_a_unit * curve.slope_of_log_inverse_r(t)));
  }
}

double InletLengths::log_length(double flooded_over_inlet) const {
  const double log_r = std::log(flooded_over_inlet);
  const double place = (log_r - least_log_r) * nodes_a_unit;
  if (!(place >= 0 && place < static_cast<double>(log_length_.size() - 1)))
    return curve_.log_inlet_length(flooded_over_inlet);
  // Hermite's cubic gives t, and its slope is used in the Newton step.
  const auto i = static_cast<std::size_t>(place);
  const double x = place - static_cast<double>(i);
  const double rise = log_length_[i + 1] - log_length_[i];
  const double a = step_slope_[i] - rise, b = rise - step_slope_[i + 1];
  const double t = log_length_[i] + x * (rise + (1 - x) * (a * (1 - x) + b * x));
  const double slope = rise + (1 - 2 * x) * (a * (1 - x) + b * x) + x * (1 - x) * (b - a);
  return t + slope * nodes_a_unit * (curve_.log_inverse_r(t) + log_r);
}

ReadInlet::ReadInlet(const Reading& reading, bool of_many)
    : rule_(reading.inlet()), curve_(curve_of(reading)) {
  if (of_many && is_implicit(curve_.closure) && rule_ != InletRule::as_printed)
    lengths_.emplace(curve_);
  if (rule_ == InletRule::as_printed)
    constant_film_ = printed_constant(curve_);
  else if (const double r = curve_.at_film_maximum(); r == r)
    maximum_ = r;
}

double ReadInlet::film_ratio(double flooded_over_inlet) const {
  if (rule_ == InletRule::as_printed) return constant_film_ / flooded_over_inlet;
  if (lengths_) return wolveridge_film_ratio(std::exp(lengths_->log_length(flooded_over_inlet)));
  return curve_.film_ratio(flooded_over_inlet);
}

double ReadInlet::slope(double flooded_over_inlet) const {
  if (rule_ == InletRule::as_printed) return -1;
  if (!lengths_) return curve_.slope(flooded_over_inlet);
  const double t = lengths_->log_length(flooded_over_inlet);
  return -curve_.slope_of_log_y(t) / curve_.slope_of_log_inverse_r(t);
}

double ReadInlet::departure(double departure) const {
  if (rule_ == InletRule::as_printed) return constant_film_ / (1 - departure);
  return curve_.at_departure(departure);
}

ReadContact::ReadContact(const Scene& scene, const Reading& reading, double film_scale)
    : inlet_film_ratio_(scene.supply.value),
      film_at_unit_speed_(film_scale *
                          film_thickness(film_law(reading), 1.0, scene.lubricant.viscosity,
                                         scene.lubricant.pressure_viscosity, scene.load,
                                         scene.bodies.effective_modulus,
                                         scene.bodies.reduced_radius, scene.bodies.ellipticity) /
                          scene.surface.summit_height_sd),
      summit_height_sd_(scene.surface.summit_height_sd),
      mean_pressure_(scene.load / nominal_area(scene, reading)),
      lubricant_(scene.lubricant),
      boundary_coefficient_(scene.friction.boundary_coefficient.value_or(0)),
      slide_roll_ratio_(scene.friction.slide_roll_ratio),
      asperities_(asperities_of(scene, reading)),
      sharing_(asperities_.model, asperities_.stiffness, asperities_.offset) {}

double ReadContact::smooth_film_parameter(double speed) const {
  return film_at_unit_speed_ * decimal_power(speed, sharing_.film().speed_exponent);
}

double ReadContact::flooded_film_parameter(double speed) const {
  return sharing_.film_parameter(smooth_film_parameter(speed));
}

std::vector<double> ReadContact::flooded_film_parameters(std::span<const double> at) const {
  std::vector<double> smooth, found(at.size());
  smooth.reserve(at.size());
  for (const double speed : at) smooth.push_back(smooth_film_parameter(speed));
  film_parameter(sharing_, smooth, found);
  return found;
}

double ReadContact::asperity_share(double film_parameter) const {
  if (sharing_.has_floor() && film_parameter <= sharing_.floor()) return 1;
  return sharing_.shares_above_floor(film_parameter - sharing_.floor()).asperity;
}

ContactPoint ReadContact::point(double speed, double flooded, const ReadInlet& inlet) const {
  const double y = inlet.film_ratio(flooded / inlet_film_ratio_);
  const double film = flooded * y;
  const double separation = std::max(film, sharing_.floor());
  return {speed,
          film,
          separation,
          asperity_share(film),
          real_area_ratio(asperities_, separation),
          summit_count(asperities_, separation),
          y == 0};
}

double ReadContact::friction(const ContactPoint& point, FrictionLaw law) const {
  if (point.separation == 0) return quiet_nan<double>();
  const double dry = boundary_coefficient_ * point.asperity_share;
  const double fluid_area = 1 - point.real_area_ratio;
  if (!(fluid_area > 0)) return dry;
  const double thickening =
      log_viscosity_ratio(law.viscosity, lubricant_.viscosity, lubricant_.pressure_viscosity,
                          (1 - point.asperity_share) * mean_pressure_);
  const double stress =
      fluid_shear_stress(law.shear, *lubricant_.eyring_stress, lubricant_.viscosity, thickening,
                         slide_roll_ratio_ * point.speed, point.separation * summit_height_sd_);
  return dry + stress * fluid_area / mean_pressure_;
}

std::optional<double> ReadContact::speed_at(double film_parameter) const {
  if (sharing_.has_floor() && film_parameter <= sharing_.floor()) return std::nullopt;
  const double fluid = sharing_.shares_above_floor(film_parameter - sharing_.floor()).fluid;
  const double flooded = sharing_.flooded_film_parameter(film_parameter, fluid);
  return decimal_power(flooded / film_at_unit_speed_, inverse(sharing_.film().speed_exponent));
}

std::optional<OnsetPoint> ReadContact::onset_at_ratio(double r, const ReadInlet& inlet) const {
  const double flooded = r * inlet_film_ratio_;
  const std::optional<double> speed = speed_at(flooded);
  if (!speed) return std::nullopt;
  return OnsetPoint{*speed, flooded * inlet.film_ratio(r)};
}

double ReadContact::flooded_slope(double film_parameter) const {
  if (sharing_.has_floor() && film_parameter <= sharing_.floor()) return 0;
  const LoadShares<double> shares = sharing_.shares_above_floor(film_parameter - sharing_.floor());
  const double steepness = shares.asperity > 0 ? sharing_.asperity_share_slope(film_parameter) : 0;
  const FilmLaw& law = sharing_.film();
  return detail::film_slope(
      {ratio<double>(law.speed_exponent), ratio<double>(law.sharing_exponent)}, shares, steepness);
}

double ReadContact::film_slope(double r, const ReadInlet& inlet) const {
  return flooded_slope(r * inlet_film_ratio_) * (1 + inlet.slope(r));
}

double ReadContact::collapse_speed(const ReadInlet& inlet) const {
  if (inlet.rule() != InletRule::flooded_inlet) return std::numeric_limits<double>::infinity();
  return speed_at(inlet_film_ratio_).value_or(0);
}

std::optional<OnsetPoint> explicit_onset(const ReadContact& contact, const ReadInlet& inlet,
                                         const OnsetChoice& choice) {
  if (choice.rule == OnsetRule::film_departure)
    return contact.onset_at_ratio(inlet.departure(choice.departure), inlet);
  if (!inlet.maximum()) return std::nullopt;
  const std::optional<OnsetPoint> found = contact.onset_at_ratio(*inlet.maximum(), inlet);
  if (!found || choice.rule == OnsetRule::film_maximum) return found;
  // asperity_minimum: there is none where the asperities carry the whole load at every speed.
  const double share = contact.point(found->speed, inlet).asperity_share;
  return share < 1 ? found : std::nullopt;
}

}  // namespace tribo::reproduction
