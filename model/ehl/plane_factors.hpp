// SPDX-License-Identifier: Apache-2.0
// Factors of a matrix that joins each node of a plane grid with the two before it and the one
// behind it along X, and with its neighbours along Y. They precondition GMRES: single precision
// serves, in half the memory.
#pragma once

#include <Eigen/SparseLU>
#include <vector>

#include "ehl/plane_grid.hpp"

namespace tribo::ehl {

class PlaneFactors {
 public:
  explicit PlaneFactors(const PlaneGrid& grid);

  // All matrices of one object have entries at the same places, and one that is not 0 in each row.
  // Returns false where an entry is not finite or the matrix could not be factored.
  bool factor(std::vector<Eigen::Triplet<double>> entries);

  // After factor() has returned true: what the matrix takes to `side`, to a few digits.
  Eigen::VectorXd solve(const Eigen::VectorXd& side) const;

 private:
  Eigen::SparseMatrix<float> scaled(const std::vector<Eigen::Triplet<double>>& entries);

  std::vector<int> places_;     // of the nodes, in the order of elimination
  Eigen::VectorXd row_scales_;  // by which a node's greatest entry is 1
  Eigen::SparseLU<Eigen::SparseMatrix<float>, Eigen::NaturalOrdering<int>> factors_;
};

}  // namespace tribo::ehl
