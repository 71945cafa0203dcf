// SPDX-License-Identifier: Apache-2.0
#include "page/contour_labels.hpp"

#include <algorithm>
#include <cmath>

namespace tribo::report {
namespace {

// The room of a label, how far from others its middle stays in such labels, and how far its middle
// stays from the map's edge.
constexpr double label_width = 0.15, label_height = 0.085, least_room = 1.2, edge_width = 0.09,
                 edge_height = 0.06;

// Where lines between neighbouring places cross the level.
std::vector<MapPlace> crossings(const Eigen::MatrixXd& values, double level) {
  const Eigen::Index across = values.rows() - 1, up = values.cols() - 1;
  std::vector<MapPlace> places;
  const auto add = [&](Eigen::Index i, Eigen::Index j, Eigen::Index di, Eigen::Index dj) {
    if (i + di > across || j + dj > up) return;
    const double here = values(i, j) - level, next = values(i + di, j + dj) - level;
    if ((here < 0) == (next < 0)) return;
    const double part = here / (here - next);
    places.push_back(
        {(static_cast<double>(i) + part * static_cast<double>(di)) / static_cast<double>(across),
         (static_cast<double>(j) + part * static_cast<double>(dj)) / static_cast<double>(up)});
  };
  for (Eigen::Index i = 0; i <= across; ++i)
    for (Eigen::Index j = 0; j <= up; ++j) {
      add(i, j, 1, 0);
      add(i, j, 0, 1);
    }
  return places;
}

// In labels: below 1 they would touch.
double distance(const MapPlace& a, const MapPlace& b) {
  return std::fmax(std::fabs(a.x - b.x) / label_width, std::fabs(a.y - b.y) / label_height);
}

}  // namespace

bool is_clear(const MapPlace& place, const std::vector<MapPlace>& taken) {
  return std::all_of(taken.begin(), taken.end(),
                     [&](const MapPlace& other) { return distance(place, other) > 1; });
}

std::vector<ContourLabel> contour_labels(const Eigen::MatrixXd& values,
                                         const std::vector<double>& levels,
                                         const std::vector<MapPlace>& taken) {
  std::vector<ContourLabel> labels;
  std::vector<MapPlace> filled = taken;
  for (const double level : levels) {
    double best = least_room;
    MapPlace chosen{};
    for (const MapPlace& place : crossings(values, level)) {
      if (std::fmin(place.x, 1 - place.x) < edge_width) continue;
      if (std::fmin(place.y, 1 - place.y) < edge_height) continue;
      double room = 1e9;
      for (const MapPlace& other : filled) room = std::fmin(room, distance(place, other));
      // The better of two places with much room is the one nearer to the middle.
      const double worth = std::fmin(room, 4) - 0.2 * std::hypot(place.x - 0.5, place.y - 0.5);
      if (room <= least_room || worth <= best) continue;
      best = worth;
      chosen = place;
    }
    if (best <= least_room) continue;
    labels.push_back({level, chosen});
    filled.push_back(chosen);
  }
  return labels;
}

}  // namespace tribo::report
