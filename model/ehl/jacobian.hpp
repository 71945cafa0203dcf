// SPDX-License-Identifier: Apache-2.0
// The linear equations of a Newton step, factored part by part of the tree of FilmKernel: a direct
// solution in N log² N operations. Source: S. Ambikasaran, E. Darve: An O(N log N) fast direct
// solver for partial hierarchically semi-separable matrices. J. Sci. Comput. 57 (2013) 477.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "ehl/film_kernel.hpp"
#include "ehl/reynolds.hpp"

namespace tribo::ehl {

// The matrix J with the rows J_i = Σ_k by_film[k] K_{i−2+k} + by_pressure[k] e_{i−2+k}, k from 0 to
// 3; rows of nodes that are held (not free) are e_i.
class Jacobian {
 public:
  Jacobian(const FilmKernel& kernel, std::span<const BalanceSlopes> slopes,
           std::span<const char> is_free);

  // J⁻¹ times each column.
  Eigen::MatrixXd solve(Eigen::MatrixXd right_hand_sides) const;
  std::size_t bytes() const;

 private:
  // `lu` has the factors of a leaf's block or, of any other part, of the small system that joins
  // its halves. Such a part also has the two blocks between its halves as products left · rightᵀ.
  // first_left is the inverse of the first half times the left of the upper block, second_left the
  // inverse of the second half times the left of the lower block.
  struct Factor {
    Eigen::PartialPivLU<Eigen::MatrixXd> lu;
    Eigen::MatrixXd upper_right, lower_right, first_left, second_left;
  };

  void factor(int index);
  void solve_part(int index, Eigen::Ref<Eigen::MatrixXd> b) const;
  Eigen::MatrixXd leaf_block(const KernelPart& part) const;
  ThinProduct between(const KernelPart& part, bool is_upper) const;

  const FilmKernel& kernel_;
  std::span<const BalanceSlopes> slopes_;
  std::span<const char> is_free_;
  std::vector<Factor> factors_;
};

}  // namespace tribo::ehl
