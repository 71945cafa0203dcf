// SPDX-License-Identifier: Apache-2.0
// Where the labels of a map's contour lines stand: on their lines, and none over another.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tribo::report {

// In parts of the map's width and height, from its lower left corner.
struct MapPlace {
  double x, y;
};

struct ContourLabel {
  double level;
  MapPlace place;
};

// Is there room for a label?
bool is_clear(const MapPlace& place, const std::vector<MapPlace>& taken);

// One label for each level that has a line with room for it, clear of the `taken` places. The
// values are at evenly spaced places: a row for each x, a column for each y.
std::vector<ContourLabel> contour_labels(const Eigen::MatrixXd& values,
                                         const std::vector<double>& levels,
                                         const std::vector<MapPlace>& taken);

}  // namespace tribo::report
