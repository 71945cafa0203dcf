// SPDX-License-Identifier: Apache-2.0
// Rectangular elements over the half plane Y ≥ 0, their sides longer and longer away from the
// contact, and the film that a pressure adds on them: P is bilinear on each element, and ∬ P/r is
// exact near a node's function, from the fourth integral of 1/r, and by Gauss' rule of two points
// along each axis from seven of its sides on, where it is off by less than 2e-5.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace tribo::reference {

using Eigen::Index;
using Nodes = std::vector<double>;  // rising
// A row for each node that is lifted; 7 digits are enough, and half the memory.
using FilmMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

struct PointMesh {
  Nodes x, y;
  Index nx() const { return static_cast<Index>(x.size()); }
  Index ny() const { return static_cast<Index>(y.size()); }
  Index size() const { return nx() * ny(); }
  Index node(Index i, Index j) const { return i + nx() * j; }
  // P is 0 there.
  bool is_end(Index i, Index j) const { return i == 0 || i + 1 == nx() || j + 1 == ny(); }
};

// Nodes from −start to end, of them 0: `step` apart up to `even` on both sides, then as
// width·sinh(fs/width) farther, where f is all but 1: so the ends do not depend on `step`.
Nodes graded(double start, double end, double even, double width, double step);

// ∬ N/r at each node, of each node's function and its mirror image; 0 of those at the ends.
FilmMatrix film_matrix(const PointMesh& mesh);

}  // namespace tribo::reference
