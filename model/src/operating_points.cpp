// SPDX-License-Identifier: Apache-2.0
#include "tribo/operating_points.hpp"

namespace tribo {
namespace {

// Calls visit(output, array) for each array of numbers.
template <class Points, class Visitor>
void for_each_number(Points& points, Visitor&& visit) {
  visit(Output::film_flooded, points.film_flooded);
  visit(Output::film, points.film);
  visit(Output::separation, points.separation);
  visit(Output::film_parameter, points.film_parameter);
  visit(Output::asperity_load_share, points.asperity_load_share);
  visit(Output::fluid_load_share, points.fluid_load_share);
  visit(Output::real_area_ratio, points.real_area_ratio);
  visit(Output::summit_count, points.summit_count);
  visit(Output::friction, points.friction);
}

}  // namespace

void OperatingPoints::resize(std::size_t count, OutputSet outputs) {
  speed.resize(count);
  for_each_number(*this, [&](Output output, auto& array) {
    array.resize(outputs.contains(output) ? count : 0);
  });
  regime.resize(outputs.contains(Output::regime) ? count : 0);
  inlet.resize(outputs.contains(Output::inlet) ? count : 0);
  friction_undefined.resize(outputs.contains(Output::friction) ? count : 0);
}

OperatingPoint<double> OperatingPoints::operator[](std::size_t i) const {
  const auto at = [i](const auto& array) {
    return array.empty() ? typename std::decay_t<decltype(array)>::value_type{} : array[i];
  };
  return {speed[i],
          at(film_flooded),
          at(film),
          at(separation),
          at(film_parameter),
          at(asperity_load_share),
          at(fluid_load_share),
          at(real_area_ratio),
          at(summit_count),
          at(friction),
          regime.empty() ? Regime::mixed : regime[i],
          at(inlet),
          at(friction_undefined) != 0};
}

void solve(const MixedContact<double>& contact, std::span<const double> speeds, OutputSet outputs,
           OperatingPoints& points, std::size_t first) {
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const std::size_t i = first + k;
    const OperatingPoint<double> point = contact.solve(speeds[k], outputs);
    const auto store = [&](auto& array, auto value) {
      if (!array.empty()) array[i] = value;
    };
    points.speed[i] = point.speed;
    store(points.film_flooded, point.film_flooded);
    store(points.film, point.film);
    store(points.separation, point.separation);
    store(points.film_parameter, point.film_parameter);
    store(points.asperity_load_share, point.asperity_load_share);
    store(points.fluid_load_share, point.fluid_load_share);
    store(points.real_area_ratio, point.real_area_ratio);
    store(points.summit_count, point.summit_count);
    store(points.friction, point.friction);
    store(points.regime, point.regime);
    store(points.inlet, point.inlet);
    store(points.friction_undefined, static_cast<std::uint8_t>(point.friction_undefined));
  }
}

}  // namespace tribo
