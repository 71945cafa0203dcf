// SPDX-License-Identifier: Apache-2.0
// The arrays of OperatingPoints by their outputs.
#pragma once

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

}  // namespace tribo
