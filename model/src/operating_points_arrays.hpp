// SPDX-License-Identifier: Apache-2.0
// The arrays of OperatingPoints by their outputs, and as the engine fills them.
#pragma once

#include "engine.hpp"
#include "tribo/operating_points.hpp"

namespace tribo {

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

namespace detail {

// Where the numbers of points from `first` on go.
inline Destination destination(OperatingPoints& points, std::size_t first) {
  const auto from = [first](auto& array) { return array.empty() ? nullptr : array.data() + first; };
  return {from(points.film_flooded),
          from(points.film),
          from(points.separation),
          from(points.film_parameter),
          from(points.asperity_load_share),
          from(points.fluid_load_share),
          from(points.real_area_ratio),
          from(points.summit_count),
          from(points.friction),
          from(points.regime),
          from(points.inlet),
          from(points.friction_undefined)};
}

inline void store(const OperatingPoint<double>& point, OperatingPoints& points, std::size_t i) {
  const auto put = [i](auto& array, auto value) {
    if (!array.empty()) array[i] = value;
  };
  put(points.film_flooded, point.film_flooded);
  put(points.film, point.film);
  put(points.separation, point.separation);
  put(points.film_parameter, point.film_parameter);
  put(points.asperity_load_share, point.asperity_load_share);
  put(points.fluid_load_share, point.fluid_load_share);
  put(points.real_area_ratio, point.real_area_ratio);
  put(points.summit_count, point.summit_count);
  put(points.friction, point.friction);
  put(points.regime, point.regime);
  put(points.inlet, point.inlet);
  put(points.friction_undefined, static_cast<std::uint8_t>(point.friction_undefined));
}

}  // namespace detail

}  // namespace tribo
