// SPDX-License-Identifier: Apache-2.0
#include "page/two_slopes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "page/number_text.hpp"

namespace tribo::report {
namespace {

double film_at(const MixedContact<double>& contact, double speed) {
  OutputSet outputs;
  outputs.insert(Output::film);
  return contact.solve(speed, outputs).film;
}

// d ln h*/d ln u between two speeds a thousandth apart.
double slope_at(const MixedContact<double>& contact, double low, double high) {
  const double film_low = film_at(contact, low), film_high = film_at(contact, high);
  if (!(film_low > 0 && film_high > 0)) return quiet_nan<double>();
  return std::log(film_high / film_low) / std::log(high / low);
}

std::optional<Point> onset_within(const MixedContact<double>& contact, const Scene& scene,
                                  SpeedRange range) {
  const auto found = onset(contact, scene, OnsetCriterion::film_maximum, default_departure);
  if (!found.exists || found.speed < range.low || found.speed > range.high) return std::nullopt;
  return contact.solve(found.speed);
}

SlopeCurve slope_curve(std::string_view name, std::string change, const Scene& scene,
                       SpeedRange range) {
  const MixedContact<double> contact(scene);
  constexpr double step = 1.001;
  return {name,
          std::move(change),
          closely_spaced_curve(contact, range),
          slope_at(contact, range.low, range.low * step),
          slope_at(contact, range.high / step, range.high),
          onset_within(contact, scene, range)};
}

SlopeCurve flow_curve(const SolvedCase& base, double flow, StarvationClosure closure,
                      std::string_view name) {
  Scene scene = base.source.scene;
  scene.supply = {SupplyKind::inlet_flow, flow};
  scene.closures.starvation = closure;
  return slope_curve(
      name, fmt::format("supply.inlet_flow = {} m2/s, closures.starvation = {}", exact(flow), name),
      scene, base.range);
}

SlopeCurve flooded_curve(const SolvedCase& base) {
  Scene scene = base.source.scene;
  scene.supply = {};
  return slope_curve("flooded", "no supply", scene, base.range);
}

// The line u^slope through `film` at `anchor`, over [from, to].
GuideLine guide(double slope, double anchor, double film, double from, double to) {
  GuideLine line{slope, {from, std::sqrt(from * to), to}, {}};
  for (std::size_t i = 0; i < line.speeds.size(); ++i)
    line.films[i] = film * std::pow(line.speeds[i] / anchor, slope);
  return line;
}

}  // namespace

TwoSlopes two_slopes(const SolvedCase& base) {
  const SpeedRange range = base.range;
  const double knee = std::sqrt(range.low) * std::sqrt(range.high);
  const double film = base.contact.solve(knee).film_flooded;
  const double flow = film * knee;
  // The guides stand a little above the curves, on both sides of the knee.
  const double third = std::cbrt(knee / range.low);
  const double above = film * 1.7;
  return {
      &base,
      flow,
      knee,
      {flooded_curve(base),
       flow_curve(base, flow, StarvationClosure::starved_inlet, "starved_inlet"),
       flow_curve(base, flow, StarvationClosure::damiens, "damiens"),
       {"paper", "as the scene file", base.curve,
        slope_at(base.contact, range.low, range.low * 1.001),
        slope_at(base.contact, range.high / 1.001, range.high), base.at_onset}},
      {guide(base.contact.film().speed_power.value, knee, above, range.low * third, knee / third),
       guide(-1, knee, above, knee * std::sqrt(third), knee * third * std::sqrt(third))}};
}

}  // namespace tribo::report
