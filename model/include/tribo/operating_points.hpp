// SPDX-License-Identifier: Apache-2.0
// Many operating points of one scene in one pass, in double (mixed_contact.hpp has the single one).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tribo/mixed_contact.hpp"
#include "tribo/work.hpp"

namespace tribo {

// Operating points as a structure of arrays. The array of an output that was not asked for is
// empty; but the regime is also there with each output of balance_outputs().
struct OperatingPoints {
  std::vector<double> speed;
  std::vector<double> film_flooded;
  std::vector<double> film;
  std::vector<double> separation;
  std::vector<double> film_parameter;
  std::vector<double> asperity_load_share;
  std::vector<double> fluid_load_share;
  std::vector<double> real_area_ratio;
  std::vector<double> summit_count;
  std::vector<double> friction;
  std::vector<Regime> regime;
  std::vector<Inlet> inlet;

  std::size_t size() const { return speed.size(); }
  // Makes room for `count` points with these outputs. Room that is there already is kept.
  void resize(std::size_t count, OutputSet outputs);
  // Point i; an output that was not asked for is 0.
  OperatingPoint<double> operator[](std::size_t i) const;
};

// Calls visit(output, member) for each member of a structure of points, or of one point, that holds
// numbers.
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

// All outputs of a set at speeds in m/s, into points [first, first + speeds.size()) of a structure
// that has room for them. Error: operating_point_contract. The bits of a point depend only on its
// scene and speed. Nothing is allocated, so that threads may fill parts of one structure.
void solve(const MixedContact<double>& contact, std::span<const double> speeds, OutputSet outputs,
           OperatingPoints& points, std::size_t first = 0);
// The same, and adds the work that was done to `work`.
void solve(const MixedContact<double>& contact, std::span<const double> speeds, OutputSet outputs,
           OperatingPoints& points, WorkCounts& work, std::size_t first = 0);

}  // namespace tribo
