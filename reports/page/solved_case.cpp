// SPDX-License-Identifier: Apache-2.0
#include "page/solved_case.hpp"

#include <algorithm>
#include <cmath>

#include "page/speed_search.hpp"

namespace tribo::report {
namespace {

constexpr std::size_t curve_points = 601;

// Speeds u_c (1 − 10^−e) just below a collapse at u_c: the film falls as the 2/3rd power of the
// distance, so that on logarithmic axes evenly spaced e draw an even line.
void add_points_before_collapse(std::vector<Point>& curve, const MixedContact<double>& contact,
                                SpeedRange range, double collapse) {
  for (int eighths = 8; eighths <= 64; ++eighths) {
    const double speed = collapse * (1 - std::pow(10, -eighths / 8.0));
    if (speed > range.low && speed < range.high) curve.push_back(contact.solve(speed));
  }
  curve.push_back(contact.solve(collapse));
}

SpeedRange range_of(const Scene& scene) {
  const auto span = detail::speed_span(scene.speeds);
  return {span.low, span.high};
}

bool contains(SpeedRange range, double speed) { return range.low <= speed && speed <= range.high; }

}  // namespace

std::optional<double> collapse_speed(const MixedContact<double>& contact, SpeedRange range) {
  return first_speed(range.low, range.high,
                     [&](double speed) { return contact.inlet(contact.flooded(speed)).collapsed; });
}

std::vector<Point> closely_spaced_curve(const MixedContact<double>& contact, SpeedRange range) {
  std::vector<Point> curve;
  stribeck_curve(contact, range.low, range.high, curve_points, OutputSet::all(),
                 [&](const Point& point) { curve.push_back(point); });
  if (const auto collapse = collapse_speed(contact, range))
    add_points_before_collapse(curve, contact, range, *collapse);
  std::sort(curve.begin(), curve.end(),
            [](const Point& a, const Point& b) { return a.speed < b.speed; });
  return curve;
}

SolvedCase solve_case(const Case& source) {
  const MixedContact<double> contact(source.scene);
  const SpeedRange range = range_of(source.scene);
  SolvedCase solved{source, contact, range, closely_spaced_curve(contact, range),
                    {},     {},      {},    contact.solve(range.low)};
  for (const OnsetCriterion criterion : onset_criteria)
    solved.onsets[static_cast<std::size_t>(criterion)] =
        onset(contact, source.scene, criterion, default_departure);
  const Onset<double>& maximum = solved.by(OnsetCriterion::film_maximum);
  if (maximum.exists && contains(range, maximum.speed))
    solved.at_onset = contact.solve(maximum.speed);
  if (const auto speed = collapse_speed(contact, range)) solved.at_collapse = contact.solve(*speed);
  return solved;
}

const SolvedCase& find_solved(const std::vector<SolvedCase>& solved, std::string_view surface,
                              AsperityModel model) {
  return *std::find_if(solved.begin(), solved.end(), [&](const SolvedCase& one) {
    return one.source.surface == surface && one.source.model == model;
  });
}

}  // namespace tribo::report
