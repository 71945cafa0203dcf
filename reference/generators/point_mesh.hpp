// SPDX-License-Identifier: Apache-2.0
// Rectangular elements over the half plane Y ≥ 0, whose sides become longer away from the contact,
// and the film that a pressure on them adds. P is bilinear on each element. N is the function of a
// node, and ∬ N/r is exact near this node, from the fourth integral of 1/r. Farther away than about
// seven times the longest side beside the node, Gauss' rule of two points along each axis computes
// it with an error below 2e-5.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace tribo::reference {

using Eigen::Index;
using Nodes = std::vector<double>;  // rising
// A row for each node at which a film is added. Numbers are `float`, because 7 digits are enough
// and take half the memory.
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

// Nodes from −start to end, one of them at 0. Up to `even` on both sides they are `step` apart.
// Beyond, they lie at even + width·sinh(f(s − even)/width) for whole multiples s of `step`, where f
// is close to 1 and is chosen such that the ends do not depend on `step`.
Nodes graded(double start, double end, double even, double width, double step);

// ∬ N/r at each node (row) for the function N of each node (column) and its mirror image in Y = 0.
// Columns of nodes at the ends are 0.
FilmMatrix film_matrix(const PointMesh& mesh);

}  // namespace tribo::reference
