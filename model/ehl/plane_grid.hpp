// SPDX-License-Identifier: Apache-2.0
// Nodes of a rectangle of the half plane Y ≥ 0, at equal distances along X and along Y. The contact
// is symmetric about Y = 0. A grid of half the distances has all nodes of this one.
#pragma once

#include <Eigen/Dense>

namespace tribo::ehl {

struct PlaneGrid {
  int ahead, behind;  // cells from X = 0 to the end of the inlet, and to the end of the outlet
  int beside;         // cells from Y = 0 to the side
  double dx, dy;      // distances of nodes along X and Y

  int count_x() const { return ahead + behind + 1; }
  int count_y() const { return beside + 1; }
  Eigen::Index size() const { return Eigen::Index{count_x()} * count_y(); }
  Eigen::Index node(int i, int j) const { return Eigen::Index{j} * count_x() + i; }
  double x(int i) const { return (i - ahead) * dx; }
  double y(int j) const { return j * dy; }
  bool is_inside(int i, int j) const { return i > 0 && i + 1 < count_x() && j + 1 < count_y(); }
  // The area of a node's surroundings on both sides of Y = 0.
  double area(int j) const { return (j == 0 ? 1 : 2) * dx * dy; }
  // The grid with `times` as many cells along each side.
  PlaneGrid finer(int times = 2) const {
    return {times * ahead, times * behind, times * beside, dx / times, dy / times};
  }
};

}  // namespace tribo::ehl
