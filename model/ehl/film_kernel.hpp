// SPDX-License-Identifier: Apache-2.0
// The film at every node from the pressure at every node, H = K P, and the form in which K is kept.
// A block of K between two neighbouring halves of the nodes has a low rank, because ln|x − t| is
// smooth there, and is kept as a product of two thin matrices. So N nodes take N log N numbers, and
// as many operations, instead of N².
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

namespace tribo::ehl {

// A block of K as the product left · rightᵀ.
struct ThinProduct {
  Eigen::MatrixXd left, right;
  // The first rough_rank columns give the block to 1e-8 of its norm: enough for a Newton step.
  Eigen::Index rough_rank = 0;
};

// The nodes from begin to end − 1. A leaf keeps its block of K. Any other part keeps the two blocks
// between its halves.
struct KernelPart {
  int begin = 0, end = 0, middle = 0;  // middle: where the second half begins; 0: a leaf
  int first = -1, second = -1;         // the halves, as places in the tree
  // A leaf's block, with the rows of the two nodes before it and of one after it. The balances at
  // its nodes need these rows.
  Eigen::MatrixXd dense;
  // upper: rows of the first half, columns of the second half. lower: the other way round.
  ThinProduct upper, lower;
  // upper_rows: the rows of the nodes begin − 2, begin − 1 and middle, in the columns of the second
  // half. lower_rows: those of middle − 2, middle − 1 and end, in the columns of the first half. A
  // node that is not there has zeros.
  Eigen::MatrixXd upper_rows, lower_rows;
};

class FilmKernel {
 public:
  // K for pressure that is linear between the nodes x, and 0 at the first and the last node. Each
  // block of K is kept to 1e-12 of its norm.
  explicit FilmKernel(std::span<const double> x);

  // K P: the film that the pressure adds. pressure.size() is that of x.
  Eigen::VectorXd operator*(const Eigen::VectorXd& pressure) const;

  double entry(int row, int column) const;
  int size() const { return static_cast<int>(x_.size()); }
  int root() const { return 0; }
  std::size_t part_count() const { return parts_.size(); }
  const KernelPart& part(int index) const { return parts_[static_cast<std::size_t>(index)]; }
  std::size_t bytes() const;

 private:
  int add_part(int begin, int end);
  Eigen::MatrixXd rows(int row, int row_end, int column, int column_end) const;
  ThinProduct thin_product(int row, int row_end, int column, int column_end) const;
  void add_product(int index, const Eigen::VectorXd& pressure, Eigen::VectorXd& film) const;

  std::vector<double> x_;
  std::vector<KernelPart> parts_;
};

}  // namespace tribo::ehl
