// SPDX-License-Identifier: Apache-2.0
// Factors of a matrix that joins each node of a plane grid with the two before it and the one
// behind it along X, and with its neighbours along Y. They precondition GMRES, for which single
// precision is enough: it takes half the memory.
#pragma once

#include <Eigen/SparseLU>
#include <vector>

#include "ehl/plane_grid.hpp"

namespace tribo::ehl {

class PlaneFactors {
 public:
  explicit PlaneFactors(const PlaneGrid& grid);

  // All matrices of one object must have entries at the same places, and each row one that is not
  // 0. Returns false where an entry is not finite or the matrix could not be factored.
  bool factor(std::vector<Eigen::Triplet<double>> entries);

  // The solution x of (matrix) x = `side`, to a few digits. factor() must have returned true.
  Eigen::VectorXd solve(const Eigen::VectorXd& side) const;

 private:
  Eigen::SparseMatrix<float> scaled(const std::vector<Eigen::Triplet<double>>& entries);

  std::vector<int> places_;     // of the nodes, in the order of elimination
  Eigen::VectorXd row_scales_;  // they make the greatest entry of each row 1
  Eigen::SparseLU<Eigen::SparseMatrix<float>, Eigen::NaturalOrdering<int>> factors_;
};

}  // namespace tribo::ehl
