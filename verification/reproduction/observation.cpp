// SPDX-License-Identifier: Apache-2.0
#include "reproduction/observation.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <initializer_list>

#include "tribo/bracketed_root.hpp"

namespace tribo::reproduction {
namespace {

constexpr std::size_t of(ContactName name) { return static_cast<std::size_t>(name); }
constexpr ContactName contact_of(PaperSurface surface) { return static_cast<ContactName>(surface); }
constexpr auto gt = ContactName::smooth, gw = ContactName::smooth_gw;  // as the paper compares them

const std::vector<ContactPoint>& points(const Stages& stages, ContactName name) {
  return stages.starved[of(name)]->points;
}
const ReadContact& contact(const Stages& stages, ContactName name) {
  return stages.flooded[of(name)]->contact;
}

constexpr std::string_view no_zone = "the onset lies below the speeds that are compared";
constexpr std::string_view no_film = "a film has collapsed at all speeds that are compared";
constexpr std::string_view no_ratio = "a film vanishes within the speeds that are compared";

// ln of the speeds at which contacts are compared: from the lowest speed (for mixed lubrication
// from ten times that speed) to the onset by film_maximum on the smooth surface, but not beyond the
// collapse of a film that is compared. Between these ends they are the speeds of the grid.
struct Zone {
  std::vector<double> log_speed;  // both ends are among them
  std::size_t first_on_grid = 0;  // index of log_speed[1] in the grid
  std::string_view none{};        // why no speeds are compared; else empty
};
Zone zone(const Stages& stages, std::initializer_list<ContactName> compared, bool mixed) {
  const std::vector<ContactPoint>& grid = points(stages, ContactName::smooth);
  const auto& maximum = stages.starved[of(ContactName::smooth)]->film_maximum;
  const double low = (mixed ? 10 : 1) * grid.front().speed;
  double high = grid.back().speed;
  if (maximum) high = std::min(high, maximum->speed);
  Zone found;
  for (const ContactName name : compared) {
    const double collapse = contact(stages, name).collapse_speed(*stages.inlet);
    if (collapse < low) found.none = no_film;
    high = std::min(high, collapse);
  }
  if (high < low) {
    if (found.none.empty()) found.none = no_zone;
    return found;
  }
  // A speed of the grid that nearly equals an end is left out.
  const double least_step = 0.01 * std::log(grid[1].speed / grid[0].speed);
  const double from = std::log(low), to = std::log(high);
  found.log_speed.push_back(from);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double here = std::log(grid[i].speed);
    if (here < from + least_step || here > to - least_step) continue;
    if (found.log_speed.size() == 1) found.first_on_grid = i;
    found.log_speed.push_back(here);
  }
  if (to > from) found.log_speed.push_back(to);
  return found;
}

// A function of the points of one or two contacts at equal speeds, over a zone.
template <class OfPoints>
class OverZone {
 public:
  OverZone(const Stages& stages, const Zone& where, ContactName a, ContactName b,
           OfPoints of_points)
      : stages_(stages), where_(where), a_(a), b_(b), of_points_(of_points) {}

  double at(double log_speed) const {
    return of_points_(point(a_, log_speed), point(b_, log_speed));
  }
  std::vector<double> values() const {
    std::vector<double> made;
    const std::size_t last = where_.log_speed.size() - 1;
    for (std::size_t k = 0; k <= last; ++k)
      made.push_back(k == 0 || k == last ? at(where_.log_speed[k])
                                         : of_points_(on_grid(a_, k), on_grid(b_, k)));
    return made;
  }

 private:
  ContactPoint point(ContactName name, double log_speed) const {
    return contact(stages_, name).point(std::exp(log_speed), *stages_.inlet);
  }
  const ContactPoint& on_grid(ContactName name, std::size_t k) const {
    return points(stages_, name)[where_.first_on_grid + k - 1];
  }

  const Stages& stages_;
  const Zone& where_;
  ContactName a_, b_;
  OfPoints of_points_;
};

// Is a ratio above 1 (order), or within a tolerance of 1 (equal), at every speed of a zone? Both
// `at_speeds`, at the speeds of the zone, and `log_ratio`, a function of ln u, are ln of the ratio.
template <class LogRatio>
Observed over(const Zone& where, const Item& item, std::vector<double> at_speeds,
              LogRatio log_ratio, double noise, Effort effort) {
  if (!std::all_of(at_speeds.begin(), at_speeds.end(), [](double x) { return std::isfinite(x); }))
    return {{}, 0, 0, no_ratio};
  const double tolerance = std::log1p(item.tolerance);
  // Above 0 where the comparison holds. A ratio above 1 by no more than `noise` is not above 1.
  const auto held = [&](double of_ratio) {
    return item.rule == Rule::equal ? tolerance - std::abs(of_ratio) : of_ratio - noise;
  };
  std::vector<double> held_at = at_speeds;
  for (double& one : held_at) one = held(one);
  const SampledCurve curve(where.log_speed, std::move(at_speeds), log_ratio, noise);
  const Estimate least = curve.least(effort), greatest = curve.greatest(effort);
  const bool greatest_is_worst = item.rule == Rule::equal && greatest.value > -least.value;
  const Estimate& worst = greatest_is_worst ? greatest : least;
  const double value = std::exp(worst.value);
  const double other_end = std::exp(greatest_is_worst ? least.value : greatest.value);
  const double error = effort == Effort::grid ? std::expm1(worst.error) * value
                                              : std::expm1(std::max(least.error, greatest.error)) *
                                                    std::max(value, other_end);
  Estimate part{held(worst.value) > 0 ? 1.0 : 0.0, 0};
  if (effort == Effort::refined && part.value == 0)
    part = SampledCurve(
               where.log_speed, std::move(held_at), [&](double x) { return held(log_ratio(x)); },
               noise)
               .part_above_zero();
  return {value, other_end, part.value, {}, error, part.error};
}

// The relative rounding error of a ratio of two points' numbers: twice the greatest rounding of any
// point of the contacts on the grid.
double rounding_of_ratio(const Stages& stages, std::initializer_list<ContactName> compared) {
  double greatest = 0;
  for (const ContactName name : compared)
    for (const ContactPoint& point : points(stages, name))
      greatest = std::max(greatest, rounding(point));
  return 2 * greatest;
}

Observed ratio_over(const Stages& stages, const Item& item, ContactName above, ContactName below,
                    double ContactPoint::*quantity, bool mixed, Effort effort) {
  const Zone where = zone(stages, {above, below}, mixed);
  if (!where.none.empty()) return {{}, 0, 0, where.none};
  const OverZone ratio(stages, where, above, below,
                       [&](const ContactPoint& a, const ContactPoint& b) {
                         return std::log(a.*quantity / (b.*quantity));
                       });
  return over(
      where, item, ratio.values(), [&](double x) { return ratio.at(x); },
      rounding_of_ratio(stages, {above, below}), effort);
}

Observed friction_over(const Stages& stages, const Item& item, Effort effort) {
  const Zone where = zone(stages, {gt, gw}, false);
  if (!where.none.empty()) return {{}, 0, 0, where.none};
  const OverZone ratio(stages, where, gt, gw, [&](const ContactPoint& a, const ContactPoint& b) {
    return std::log(contact(stages, gt).friction(a, stages.law) /
                    contact(stages, gw).friction(b, stages.law));
  });
  std::vector<double> at_speeds{ratio.at(where.log_speed.front())};
  for (std::size_t k = 1; k + 1 < where.log_speed.size(); ++k)
    at_speeds.push_back(
        std::log(stages.friction[of(gt)]->coefficient[where.first_on_grid + k - 1] /
                 stages.friction[of(gw)]->coefficient[where.first_on_grid + k - 1]));
  if (where.log_speed.size() > 1) at_speeds.push_back(ratio.at(where.log_speed.back()));
  return over(
      where, item, std::move(at_speeds), [&](double x) { return ratio.at(x); },
      rounding_of_ratio(stages, {gt, gw}), effort);
}

// Ratios of successive numbers that should rise from smooth to rough. Their errors are relative.
Observed rising(const std::array<std::optional<Estimate>, surface_count>& value,
                std::string_view none) {
  const auto &rough = value[0], &medium = value[1], &smooth = value[2];
  if (!rough || !medium || !smooth) return {{}, 0, 0, none};
  const double first = medium->value / smooth->value, second = rough->value / medium->value;
  const double greater = std::max(first, second);
  return {std::min(first, second),
          greater,
          ((first > 1 ? 1 : 0) + (second > 1 ? 1 : 0)) / 2.0,
          {},
          (rough->error + medium->error + smooth->error) * greater,
          {},
          greater};
}

// A number of one contact at all speeds of the grid, as a function of ln u.
auto over_grid(const Stages& stages, ContactName name, double ContactPoint::*quantity) {
  std::vector<double> x, y;
  double noise = 0;
  for (const ContactPoint& point : points(stages, name)) {
    x.push_back(std::log(point.speed));
    y.push_back(point.*quantity);
    noise = std::max(noise, rounding(point) * std::abs(y.back()));
  }
  const auto at = [&stages, name, quantity](double log_speed) {
    return contact(stages, name).point(std::exp(log_speed), *stages.inlet).*quantity;
  };
  return SampledCurve(std::move(x), std::move(y), at, noise);
}

Observed equal_share_order(const Stages& stages) {
  std::array<std::optional<Estimate>, surface_count> speed;
  for (std::size_t i = 0; i < surface_count; ++i) {
    speed[i] = over_grid(stages, static_cast<ContactName>(i), &ContactPoint::asperity_share)
                   .first_fall_to({0.5, 0});
    if (speed[i]) speed[i]->value = std::exp(speed[i]->value);
  }
  return rising(speed, "on a surface the shares are nowhere equal");
}

Observed late_share_rise(const Stages& stages, const Item& item, Effort effort) {
  std::array<double, surface_count> rises{};
  Observed found;
  int risen = 0;
  for (std::size_t i = 0; i < surface_count; ++i) {
    const auto name = static_cast<ContactName>(i);
    const ContactPoint& last = points(stages, name).back();
    const Estimate lowest = over_grid(stages, name, &ContactPoint::asperity_share).least(effort);
    rises[i] = last.asperity_share - lowest.value;
    found.error = std::max(found.error, lowest.error + rounding(last) * last.asperity_share);
    risen += rises[i] >= item.tolerance ? 1 : 0;
    if (last.collapsed) found.beyond_collapse |= static_cast<std::uint8_t>(1U << i);
  }
  std::sort(rises.begin(), rises.end());
  found.value = rises[0];
  found.middle = rises[1];
  found.other_end = rises[2];
  found.part = risen / 3.0;
  return found;
}

// A number of the points at the lowest speed, with their rounding.
Observed at_lowest_speed(const Stages& stages, std::initializer_list<ContactName> names,
                         double number, double part) {
  Observed found{number, number, part};
  for (const ContactName name : names) {
    const ContactPoint& point = points(stages, name).front();
    found.error += rounding(point) * number;
    if (point.collapsed) found.beyond_collapse |= static_cast<std::uint8_t>(1U << of(name));
  }
  return found;
}

Observed slow_area_spread(const Stages& stages) {
  const auto area = [&](ContactName name) { return points(stages, name).front().real_area_ratio; };
  const auto [least, greatest] =
      std::minmax({area(ContactName::rough), area(ContactName::medium), area(gt)});
  return at_lowest_speed(stages, {ContactName::rough, ContactName::medium, gt}, greatest / least,
                         0);
}

Observed slow_count_ratio(const Stages& stages) {
  const double ratio =
      points(stages, gt).front().summit_count / points(stages, gw).front().summit_count;
  return at_lowest_speed(stages, {gt, gw}, ratio, ratio > 1 ? 1.0 : 0.0);
}

Observed area_transition(const Stages& stages, const Item&, Effort effort) {
  const Zone where = zone(stages, {gt, gw}, false);
  if (!where.none.empty()) return {{}, 0, 0, where.none};
  Observed found{1.0, 1.0, 0};
  for (const ContactName name : {gt, gw}) {
    const OverZone area(
        stages, where, name, name,
        [](const ContactPoint& point, const ContactPoint&) { return point.real_area_ratio; });
    std::vector<double> values = area.values();
    const double slowest = values.front();
    const SampledCurve curve(
        where.log_speed, std::move(values), [&](double x) { return area.at(x); },
        slowest * rounding_of_ratio(stages, {name}));
    Estimate least = curve.least(effort);
    // At the floor the area is constant except for its last digits. A fall in these does not count.
    const double fallen = (1 - 1e-9) * slowest;
    if (effort == Effort::grid && least.value > fallen && least.value - least.error < fallen)
      least = curve.least(Effort::refined);
    if (least.value > fallen) return {{}, 0, 0, "the area does not fall with speed"};
    const auto log_speed = curve.first_fall_to({(slowest + least.value) / 2, least.error / 2});
    if (!log_speed) return {{}, 0, 0, "the area does not fall with speed"};
    const double factor = std::exp(log_speed->value);
    *found.value = name == gt ? 1 / factor : *found.value * factor;
    found.error += log_speed->error;
  }
  found.error *= *found.value;
  found.other_end = *found.value;
  return found;
}

Observed smoother_over_rougher(const Stages& stages, const Item& item, Effort effort) {
  constexpr auto rough = ContactName::rough, medium = ContactName::medium;
  const Zone where = zone(stages, {rough, medium, gt}, false);
  if (!where.none.empty()) return {{}, 0, 0, where.none};
  const auto log_ratio = [](const ContactPoint& a, const ContactPoint& b) {
    return std::log(a.summit_count / b.summit_count);
  };
  const OverZone first(stages, where, gt, medium, log_ratio);
  const OverZone second(stages, where, medium, rough, log_ratio);
  std::vector<double> at_speeds = first.values();
  const std::vector<double> others = second.values();
  for (std::size_t k = 0; k < others.size(); ++k) at_speeds[k] = std::min(at_speeds[k], others[k]);
  return over(
      where, item, std::move(at_speeds),
      [&](double x) { return std::min(first.at(x), second.at(x)); },
      rounding_of_ratio(stages, {rough, medium, gt}), effort);
}

Observed flooded_slope(const Stages& stages) {
  const double film = stages.flooded[of(ContactName::smooth)]->film_parameter.back();
  const double slope = contact(stages, ContactName::smooth).flooded_slope(film);
  return {slope, slope, 1, {}, 1e-13};
}

// Beyond the film's maximum, its slope falls from 0 through −0.9 and −1.1.
Observed starved_slope_range(const Stages& stages) {
  const ReadInlet& inlet = *stages.inlet;
  const ReadContact& film = contact(stages, ContactName::smooth);
  if (!inlet.maximum()) return {1.0, 1.0, 0};  // the film never falls
  const double low = std::log(*inlet.maximum());
  const double high = inlet.rule() == InletRule::flooded_inlet ? -1e-12 : std::log(1e6);
  constexpr double width = 1e-14;
  std::array<std::optional<double>, 2> speed;
  for (std::size_t k = 0; k < 2; ++k) {
    const double wanted = k == 0 ? -0.9 : -1.1;
    const double log_r = bracketed_root(
        [&](double x) { return film.film_slope(std::exp(x), inlet) - wanted; }, low, high, width);
    speed[k] = film.speed_at(std::exp(log_r) * film.inlet_film_ratio());
  }
  if (!speed[0] || !speed[1] || !std::isfinite(*speed[1] / *speed[0]))
    return {{}, 0, 0, "the film's slope does not pass −1"};
  const double range = *speed[1] / *speed[0];
  return {range, range, 0, {}, 1e-12 * range};
}

Observed onset_number(const Stages& stages, const Item& item, double OnsetPoint::*quantity,
                      double divisor) {
  const auto& onset = stages.onsets[of(contact_of(item.surface))];
  if (!onset) return {{}, 0, 0, "no onset by this criterion"};
  const double value = (*onset).*quantity / divisor;
  return {value, value, 1, {}, onset->error * value};
}

Observed film_constant(const Stages& stages) {
  return {stages.film_constant, stages.film_constant, 1, {}, 1e-15 * stages.film_constant};
}

Observed onset_order(const Stages& stages) {
  std::array<std::optional<Estimate>, surface_count> speed;
  for (std::size_t i = 0; i < surface_count; ++i)
    if (stages.onsets[i]) speed[i] = {stages.onsets[i]->speed, stages.onsets[i]->error};
  return rising(speed, "no onset by this criterion on a surface");
}

Observed onset_ratio(const Stages& stages) {
  const auto& with_gt = stages.onsets[of(ContactName::smooth)];
  const auto& with_gw = stages.onsets[of(ContactName::smooth_gw)];
  if (!with_gt || !with_gw) return {{}, 0, 0, "no onset by this criterion with GT or with GW"};
  const double ratio = with_gw->speed / with_gt->speed;
  return {ratio, ratio, 0, {}, (with_gt->error + with_gw->error) * ratio};
}

// One quantity: its name in claims.tsv, the stage that it needs, and its number.
struct QuantityInfo {
  std::string_view name;
  Stage stage;
  Observed (*observe)(const Stages& stages, const Item& item, Effort effort);
};

// The ratio of a number of the points of two contacts, over all compared speeds.
template <ContactName above, ContactName below, double ContactPoint::*quantity, bool mixed>
Observed ratio_of(const Stages& stages, const Item& item, Effort effort) {
  return ratio_over(stages, item, above, below, quantity, mixed, effort);
}
// Adapts the function of a quantity that needs neither item nor effort.
template <Observed (*number)(const Stages&)>
Observed alone(const Stages& stages, const Item&, Effort) {
  return number(stages);
}

// In the order of Quantity.
constexpr std::array<QuantityInfo, quantity_count> quantities{{
    {"onset_speed", Stage::onsets,
     [](const Stages& stages, const Item& item, Effort) {
       return onset_number(stages, item, &OnsetPoint::speed, 1);
     }},
    {"onset_film_parameter", Stage::onsets,
     [](const Stages& stages, const Item& item, Effort) {
       return onset_number(stages, item, &OnsetPoint::film_parameter, stages.lambda_divisor);
     }},
    {"onset_speed_order", Stage::onsets, alone<onset_order>},
    {"slow_asperity_share", Stage::films,
     [](const Stages& stages, const Item& item, Effort) {
       const ContactName name = contact_of(item.surface);
       return at_lowest_speed(stages, {name}, points(stages, name).front().asperity_share, 1);
     }},
    {"equal_share_speed_order", Stage::films, alone<equal_share_order>},
    {"late_share_rise", Stage::films, late_share_rise},
    {"area_gw_over_gt", Stage::films, ratio_of<gw, gt, &ContactPoint::real_area_ratio, false>},
    {"slow_area_spread", Stage::films, alone<slow_area_spread>},
    {"area_rough_over_smooth", Stage::films,
     ratio_of<ContactName::rough, gt, &ContactPoint::real_area_ratio, true>},
    {"area_transition_gw_over_gt", Stage::films, area_transition},
    {"slow_count_gt_over_gw", Stage::films, alone<slow_count_ratio>},
    {"count_gw_over_gt", Stage::films, ratio_of<gw, gt, &ContactPoint::summit_count, true>},
    {"count_smoother_over_rougher", Stage::films, smoother_over_rougher},
    {"film_gw_over_gt", Stage::films, ratio_of<gw, gt, &ContactPoint::film_parameter, false>},
    {"friction_gt_over_gw", Stage::friction, friction_over},
    {"onset_gw_over_gt", Stage::onsets, alone<onset_ratio>},
    {"flooded_slope", Stage::films, alone<flooded_slope>},
    {"starved_slope_range", Stage::films, alone<starved_slope_range>},
    {"film_constant", Stage::constant, alone<film_constant>},
}};
const QuantityInfo& info(Quantity quantity) {
  return quantities[static_cast<std::size_t>(quantity)];
}

// The least friction between two speeds, ln u there, and the error of this ln u.
struct LeastFriction {
  double log_speed, friction, error;
};
template <class Friction>
LeastFriction least_friction(const Friction& friction, double low, double high) {
  constexpr int bits = 24;  // friction is flat at its minimum
  const auto [x, least] = boost::math::tools::brent_find_minima(friction, low, high, bits);
  constexpr double step = 1e-3, noise = 1e-13;
  const double curvature = (friction(x - step) + friction(x + step) - 2 * least) / (step * step);
  const double width = std::ldexp(2 + 2 * std::abs(x), -bits);
  return {x, least, width + std::sqrt(4 * noise * least / std::max(curvature, noise))};
}

}  // namespace

std::vector<double> speed_grid(double from, double to) {
  const double decades = std::log10(to / from);
  const auto steps = static_cast<std::size_t>(std::ceil(20 * decades));
  std::vector<double> speeds(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i)
    speeds[i] =
        from * std::exp(std::log(to / from) * static_cast<double>(i) / static_cast<double>(steps));
  speeds.back() = to;
  return speeds;
}

FloodedCurve flooded_curve(const ReadContact& contact, const std::vector<double>& speeds) {
  return {contact, contact.flooded_film_parameters(speeds)};
}

StarvedCurve starved_curve(const FloodedCurve& flooded, const ReadInlet& inlet,
                           const std::vector<double>& speeds) {
  StarvedCurve curve;
  curve.points.reserve(speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i)
    curve.points.push_back(flooded.contact.point(speeds[i], flooded.film_parameter[i], inlet));
  curve.film_maximum = explicit_onset(flooded.contact, inlet, {OnsetRule::film_maximum, 0});
  return curve;
}

FrictionCurve friction_curve(const FloodedCurve& flooded, const StarvedCurve& starved,
                             FrictionLaw law) {
  FrictionCurve curve;
  curve.coefficient.reserve(starved.points.size());
  for (const ContactPoint& point : starved.points)
    curve.coefficient.push_back(flooded.contact.friction(point, law));
  return curve;
}

std::optional<OnsetPoint> friction_minimum(const FloodedCurve& flooded, const StarvedCurve& starved,
                                           const FrictionCurve& friction, const ReadInlet& inlet,
                                           FrictionLaw law) {
  const std::vector<double>& f = friction.coefficient;
  const std::vector<ContactPoint>& grid = starved.points;
  const auto at = [&](double x) {
    return flooded.contact.friction(flooded.contact.point(std::exp(x), inlet), law);
  };
  const auto log_speed = [&](std::size_t i) { return std::log(grid[i].speed); };
  constexpr double margin = 1 + 1e-12;  // smaller differences are rounding: a plateau
  std::optional<LeastFriction> lowest;
  const auto look_between = [&](std::size_t from, std::size_t to) {
    const LeastFriction found = least_friction(at, log_speed(from), log_speed(to));
    if (!lowest || found.friction < lowest->friction) lowest = found;
  };
  for (std::size_t i = 1; i + 1 < f.size(); ++i)
    if (f[i] * margin < f[i - 1] && !(f[i] * margin >= f[i + 1])) look_between(i - 1, i + 1);
  // The first or the last cell has a minimum if friction falls from the end and then rises.
  const std::size_t last = f.size() - 1;
  const double step = (log_speed(1) - log_speed(0)) / 64;
  if (f[1] > f[0] && at(log_speed(0) + step) * margin < f[0]) look_between(0, 1);
  if (f[last - 1] > f[last] && at(log_speed(last) - step) * margin < f[last])
    look_between(last - 1, last);
  if (!lowest) return std::nullopt;
  const ContactPoint point = flooded.contact.point(std::exp(lowest->log_speed), inlet);
  return OnsetPoint{point.speed, point.film_parameter, lowest->error};
}

std::string_view name(ContactName contact) {
  constexpr std::array<std::string_view, contact_count> names{"rough", "medium", "smooth",
                                                              "smooth_gw"};
  return names[of(contact)];
}

std::vector<std::string_view> beyond_collapse(const Observed& observed) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < contact_count; ++i)
    if ((observed.beyond_collapse >> i & 1U) != 0)
      names.push_back(name(static_cast<ContactName>(i)));
  return names;
}

std::string_view name(Quantity quantity) { return info(quantity).name; }
Stage stage(Quantity quantity) { return info(quantity).stage; }

Observed observe(const Item& item, const Stages& stages, Effort effort) {
  return info(item.quantity).observe(stages, item, effort);
}

}  // namespace tribo::reproduction
