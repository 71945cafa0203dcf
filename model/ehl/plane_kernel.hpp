// SPDX-License-Identifier: Apache-2.0
// The film that pressure adds on an elastic half-space, at all nodes of a plane grid from the
// pressure at all nodes: ∬ P/r by fast Fourier transforms, in N log N operations. Pressure is
// constant around each node. Source of the rectangle's film: A. E. H. Love: The stress produced in
// a semi-infinite solid by pressure on part of the boundary. Phil. Trans. R. Soc. A 228 (1929) 377.
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <cstddef>
#include <vector>

#include "ehl/plane_grid.hpp"

namespace tribo::ehl {

// ∬ dX′dY′/r over a rectangle with sides dx, dy; r to the point that is (x, y) off its middle.
double film_of_rectangle(double x, double y, double dx, double dy);

class PlaneKernel {
 public:
  explicit PlaneKernel(const PlaneGrid& grid);

  // ∬ P/r at each node, by the pressure at all nodes and its mirror image in Y = 0.
  Eigen::VectorXd operator*(const Eigen::VectorXd& pressure) const;

  // ∬ P/r at a node of row j by a pressure of 1 at this node and its mirror image.
  double own(int j) const { return own_[static_cast<std::size_t>(j)]; }

 private:
  PlaneGrid grid_;
  int length_x_, length_y_;  // of the transforms
  std::vector<double> own_;
  std::vector<double> spectrum_;  // of the kernel: real, because the kernel is even
};

}  // namespace tribo::ehl
