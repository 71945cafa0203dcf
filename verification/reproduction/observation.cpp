// SPDX-License-Identifier: Apache-2.0
#include "reproduction/observation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tribo/bracketed_root.hpp"
#include "tribo/onset.hpp"

namespace tribo::reproduction {
namespace {

constexpr std::size_t of(ContactName name) { return static_cast<std::size_t>(name); }
constexpr ContactName contact_of(PaperSurface surface) { return static_cast<ContactName>(surface); }

const std::vector<ContactPoint>& points(const Stages& stages, ContactName name) {
  return stages.starved[of(name)]->points;
}

// The indices of the grid at which two contacts are compared: from the lowest speed (for mixed
// lubrication from ten times that speed) to the onset by film_maximum on the smooth surface, but
// not beyond the collapse of a film.
struct Zone {
  std::size_t first, end;
};
Zone zone(const Stages& stages, bool mixed) {
  const std::vector<ContactPoint>& smooth = points(stages, ContactName::smooth);
  const std::vector<ContactPoint>& other = points(stages, ContactName::smooth_gw);
  const auto& maximum = stages.starved[of(ContactName::smooth)]->film_maximum;
  Zone found{0, 0};
  while (mixed && found.first < smooth.size() &&
         smooth[found.first].speed < 9.999 * smooth[0].speed)
    ++found.first;
  while (found.end < smooth.size() && !smooth[found.end].collapsed && !other[found.end].collapsed &&
         !(maximum && smooth[found.end].speed > maximum->speed))
    ++found.end;
  return found;
}

// Is a ratio above 1 (order), or within a tolerance of 1 (equal), at every speed of a zone?
template <class Ratio>
Observed over(const Zone& where, const Item& item, Ratio&& ratio) {
  if (where.first >= where.end)
    return {{}, 0, 0, "the onset lies below the speeds that are compared"};
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  std::size_t held = 0;
  for (std::size_t i = where.first; i < where.end; ++i) {
    const double here = ratio(i);
    least = std::min(least, here);
    greatest = std::max(greatest, here);
    held += item.rule == Rule::equal ? std::abs(std::log(here)) <= std::log1p(item.tolerance)
                                     : here > 1;
  }
  const double part = static_cast<double>(held) / static_cast<double>(where.end - where.first);
  if (item.rule == Rule::equal && std::log(greatest) > -std::log(least))
    return {greatest, least, part};
  return {least, greatest, part};
}

Observed ratio_over(const Stages& stages, const Item& item, ContactName above, ContactName below,
                    double ContactPoint::*quantity, bool mixed) {
  const auto& a = points(stages, above);
  const auto& b = points(stages, below);
  return over(zone(stages, mixed), item,
              [&](std::size_t i) { return a[i].*quantity / (b[i].*quantity); });
}

// Successive ratios of what should rise from smooth to medium to rough.
Observed rising(const PerContact<std::optional<double>>& value, std::string_view none) {
  const auto &rough = value[0], &medium = value[1], &smooth = value[2];
  if (!rough || !medium || !smooth) return {{}, 0, 0, none};
  const double first = *medium / *smooth, second = *rough / *medium;
  return {std::min(first, second), std::max(first, second),
          ((first > 1 ? 1 : 0) + (second > 1 ? 1 : 0)) / 2.0};
}

// The first speed of the grid's range at which a quantity has fallen to a level; none if it starts
// there, or never does.
std::optional<double> fall_speed(const Stages& stages, ContactName name,
                                 double ContactPoint::*quantity, double level) {
  const std::vector<ContactPoint>& curve = points(stages, name);
  const ReadContact& contact = stages.flooded[of(name)]->contact;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].*quantity > level) continue;
    if (i == 0) return std::nullopt;
    return std::exp(bracketed_root(
        [&](double x) { return contact.point(std::exp(x), *stages.inlet).*quantity - level; },
        std::log(curve[i - 1].speed), std::log(curve[i].speed), 1e-12));
  }
  return std::nullopt;
}

Observed equal_share_order(const Stages& stages) {
  PerContact<std::optional<double>> speed;
  for (std::size_t i = 0; i < surface_count; ++i)
    speed[i] = fall_speed(stages, static_cast<ContactName>(i), &ContactPoint::asperity_share, 0.5);
  return rising(speed, "on a surface the shares are nowhere equal");
}

Observed late_share_rise(const Stages& stages) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  int risen = 0;
  for (std::size_t i = 0; i < surface_count; ++i) {
    const auto& curve = points(stages, static_cast<ContactName>(i));
    double lowest = 1;
    for (const ContactPoint& point : curve) lowest = std::min(lowest, point.asperity_share);
    const double rise = curve.back().asperity_share - lowest;
    least = std::min(least, rise);
    greatest = std::max(greatest, rise);
    risen += rise >= 0.01 ? 1 : 0;
  }
  return {least, greatest, risen / 3.0};
}

Observed slow_area_spread(const Stages& stages) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t i = 0; i < surface_count; ++i) {
    const double area = points(stages, static_cast<ContactName>(i)).front().real_area_ratio;
    least = std::min(least, area);
    greatest = std::max(greatest, area);
  }
  return {greatest / least, greatest / least, 0};
}

Observed area_transition(const Stages& stages) {
  const Zone where = zone(stages, false);
  std::array<std::optional<double>, 2> speed;
  for (std::size_t k = 0; k < 2 && where.end > 0; ++k) {
    const auto name = k == 0 ? ContactName::smooth : ContactName::smooth_gw;
    const auto& curve = points(stages, name);
    double least = curve[0].real_area_ratio;
    for (std::size_t i = 0; i < where.end; ++i) least = std::min(least, curve[i].real_area_ratio);
    // On a floor the area is constant but for its last digits; a fall in these does not count.
    if (least > (1 - 1e-9) * curve[0].real_area_ratio) continue;
    speed[k] = fall_speed(stages, name, &ContactPoint::real_area_ratio,
                          (curve[0].real_area_ratio + least) / 2);
  }
  if (!speed[0] || !speed[1]) return {{}, 0, 0, "the area does not fall with speed"};
  const double ratio = *speed[1] / *speed[0];
  return {ratio, ratio, 0};
}

Observed smoother_over_rougher(const Stages& stages, const Item& item) {
  const auto& rough = points(stages, ContactName::rough);
  const auto& medium = points(stages, ContactName::medium);
  const auto& smooth = points(stages, ContactName::smooth);
  return over(zone(stages, false), item, [&](std::size_t i) {
    return std::min(smooth[i].summit_count / medium[i].summit_count,
                    medium[i].summit_count / rough[i].summit_count);
  });
}

Observed flooded_slope(const Stages& stages) {
  const auto& film = stages.flooded[of(ContactName::smooth)]->film_parameter;
  const auto& curve = points(stages, ContactName::smooth);
  const std::size_t last = curve.size() - 1;
  const double slope =
      std::log(film[last] / film[last - 1]) / std::log(curve[last].speed / curve[last - 1].speed);
  return {slope, slope};
}

// Beyond its maximum the film's slope falls from 0 through −0.9 and −1.1.
Observed starved_slope_range(const Stages& stages) {
  const ReadInlet& inlet = *stages.inlet;
  const ReadContact& contact = stages.flooded[of(ContactName::smooth)]->contact;
  if (!inlet.maximum()) return {1.0, 1.0, 0};  // it never falls
  const double low = std::log(*inlet.maximum());
  const double high = inlet.rule() == InletRule::flooded_inlet ? -1e-12 : std::log(1e6);
  std::array<std::optional<double>, 2> speed;
  for (std::size_t k = 0; k < 2; ++k) {
    const double wanted = k == 0 ? -0.9 : -1.1;
    const double log_r =
        bracketed_root([&](double x) { return contact.film_slope(std::exp(x), inlet) - wanted; },
                       low, high, 1e-14);
    speed[k] = contact.speed_at(std::exp(log_r) * contact.inlet_film_ratio());
  }
  if (!speed[0] || !speed[1] || !std::isfinite(*speed[1] / *speed[0]))
    return {{}, 0, 0, "the film's slope does not pass −1"};
  const double range = *speed[1] / *speed[0];
  return {range, range, 0};
}

Observed onset_number(const Stages& stages, const Item& item, double OnsetPoint::*quantity,
                      double divisor) {
  const auto& onset = stages.onsets[of(contact_of(item.surface))];
  if (!onset) return {{}, 0, 0, "no onset by this criterion"};
  const double value = (*onset).*quantity / divisor;
  return {value, value};
}

Observed onset_order(const Stages& stages) {
  PerContact<std::optional<double>> speed;
  for (std::size_t i = 0; i < contact_count; ++i)
    if (stages.onsets[i]) speed[i] = stages.onsets[i]->speed;
  return rising(speed, "no onset by this criterion on a surface");
}

Observed onset_ratio(const Stages& stages) {
  const auto& gt = stages.onsets[of(ContactName::smooth)];
  const auto& gw = stages.onsets[of(ContactName::smooth_gw)];
  if (!gt || !gw) return {{}, 0, 0, "no onset by this criterion with GT or with GW"};
  return {gw->speed / gt->speed, gw->speed / gt->speed, 0};
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
  FloodedCurve curve{contact, {}};
  curve.film_parameter.reserve(speeds.size());
  for (const double speed : speeds)
    curve.film_parameter.push_back(contact.flooded_film_parameter(speed));
  return curve;
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
  constexpr double margin = 1 + 1e-12;  // what lies within rounding is a plateau
  std::size_t lowest = 0;
  for (std::size_t i = 1; i + 1 < f.size(); ++i)
    if (f[i] * margin < f[i - 1] && f[i] * margin < f[i + 1] && (lowest == 0 || f[i] < f[lowest]))
      lowest = i;
  if (lowest == 0) return std::nullopt;
  const ReadContact& contact = flooded.contact;
  const double log_speed = detail::golden_section_minimum(
      [&](double x) { return contact.friction(contact.point(std::exp(x), inlet), law); },
      std::log(starved.points[lowest - 1].speed), std::log(starved.points[lowest + 1].speed), 1e-6);
  const ContactPoint point = contact.point(std::exp(log_speed), inlet);
  return OnsetPoint{point.speed, point.film_parameter};
}

Needs needs(Quantity quantity) {
  switch (quantity) {
    case Quantity::onset_speed:
    case Quantity::onset_film_parameter:
    case Quantity::onset_speed_order:
    case Quantity::onset_gw_over_gt:
      return Needs::onsets;
    case Quantity::friction_gt_over_gw:
      return Needs::friction;
    case Quantity::film_constant:
      return Needs::constant;
    default:
      return Needs::films;
  }
}

Observed observe(const Item& item, const Stages& stages) {
  const auto smooth = ContactName::smooth, smooth_gw = ContactName::smooth_gw;
  switch (item.quantity) {
    case Quantity::onset_speed:
      return onset_number(stages, item, &OnsetPoint::speed, 1);
    case Quantity::onset_film_parameter:
      return onset_number(stages, item, &OnsetPoint::film_parameter, stages.lambda_divisor);
    case Quantity::onset_speed_order:
      return onset_order(stages);
    case Quantity::slow_asperity_share: {
      const double share = points(stages, contact_of(item.surface)).front().asperity_share;
      return {share, share};
    }
    case Quantity::equal_share_speed_order:
      return equal_share_order(stages);
    case Quantity::late_share_rise:
      return late_share_rise(stages);
    case Quantity::area_gw_over_gt:
      return ratio_over(stages, item, smooth_gw, smooth, &ContactPoint::real_area_ratio, false);
    case Quantity::slow_area_spread:
      return slow_area_spread(stages);
    case Quantity::area_rough_over_smooth:
      return ratio_over(stages, item, ContactName::rough, smooth, &ContactPoint::real_area_ratio,
                        true);
    case Quantity::area_transition_gw_over_gt:
      return area_transition(stages);
    case Quantity::slow_count_gt_over_gw: {
      const double ratio = points(stages, smooth).front().summit_count /
                           points(stages, smooth_gw).front().summit_count;
      return {ratio, ratio, ratio > 1 ? 1.0 : 0.0};
    }
    case Quantity::count_gw_over_gt:
      return ratio_over(stages, item, smooth_gw, smooth, &ContactPoint::summit_count, true);
    case Quantity::count_smoother_over_rougher:
      return smoother_over_rougher(stages, item);
    case Quantity::film_gw_over_gt:
      return ratio_over(stages, item, smooth_gw, smooth, &ContactPoint::film_parameter, false);
    case Quantity::friction_gt_over_gw: {
      const auto& gt = stages.friction[of(smooth)]->coefficient;
      const auto& gw = stages.friction[of(smooth_gw)]->coefficient;
      return over(zone(stages, false), item, [&](std::size_t i) { return gt[i] / gw[i]; });
    }
    case Quantity::onset_gw_over_gt:
      return onset_ratio(stages);
    case Quantity::flooded_slope:
      return flooded_slope(stages);
    case Quantity::starved_slope_range:
      return starved_slope_range(stages);
    case Quantity::film_constant:
      return {stages.film_constant, stages.film_constant};
  }
  return {{}, 0, 0, "unknown quantity"};
}

}  // namespace tribo::reproduction
