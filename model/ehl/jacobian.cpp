// SPDX-License-Identifier: Apache-2.0
#include "ehl/jacobian.hpp"

namespace tribo::ehl {

Jacobian::Jacobian(const FilmKernel& kernel, std::span<const BalanceSlopes> slopes,
                   std::span<const char> is_free)
    : kernel_(kernel), slopes_(slopes), is_free_(is_free), factors_(kernel.part_count()) {
  factor(kernel.root());
}

Eigen::MatrixXd Jacobian::leaf_block(const KernelPart& part) const {
  const int size = part.end - part.begin;
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    const int row = part.begin + i;
    const auto node = static_cast<std::size_t>(row);
    if (is_free_[node] == 0) {
      block(i, i) = 1;
      continue;
    }
    const BalanceSlopes& slopes = slopes_[node];
    for (int k = 0; k < 4; ++k) {
      const auto place = static_cast<std::size_t>(k);
      // The leaf's rows of K begin two nodes before it.
      block.row(i) += slopes.by_film[place] * part.dense.row(i + k);
      const int column = i - 2 + k;
      if (column >= 0 && column < size) block(i, column) += slopes.by_pressure[place];
    }
  }
  return block;
}

// The block of J between the halves. J_i is a sum of rows of K. Rows of K in the half of node i
// come from the thin product. Rows of up to three nodes outside this half, and pressures at nodes
// of the other half, get columns of their own.
ThinProduct Jacobian::between(const KernelPart& part, bool is_upper) const {
  const int row = is_upper ? part.begin : part.middle;
  const int row_end = is_upper ? part.middle : part.end;
  const int column = is_upper ? part.middle : part.begin;
  const int column_end = is_upper ? part.end : part.middle;
  const ThinProduct& thin = is_upper ? part.upper : part.lower;
  const Eigen::MatrixXd& outside = is_upper ? part.upper_rows : part.lower_rows;
  const int rank = static_cast<int>(thin.rough_rank);
  const int pressures = is_upper ? 1 : 2;  // nodes of the other half whose pressures rows contain
  ThinProduct product{Eigen::MatrixXd::Zero(row_end - row, rank + 3 + pressures),
                      Eigen::MatrixXd::Zero(column_end - column, rank + 3 + pressures)};
  product.right.leftCols(rank) = thin.right.leftCols(rank);
  product.right.middleCols(rank, 3) = outside.transpose();
  const int first_pressure = is_upper ? part.middle : part.middle - 2;
  for (int p = 0; p < pressures; ++p) product.right(first_pressure + p - column, rank + 3 + p) = 1;

  for (int i = row; i < row_end; ++i) {
    const auto node = static_cast<std::size_t>(i);
    if (is_free_[node] == 0) continue;
    for (int k = 0; k < 4; ++k) {
      const int at = i - 2 + k;
      const double by_film = slopes_[node].by_film[static_cast<std::size_t>(k)];
      if (at >= row && at < row_end)
        product.left.row(i - row).head(rank) += by_film * thin.left.row(at - row).head(rank);
      else
        product.left(i - row, rank + (at < row ? at - row + 2 : 2)) += by_film;
      const int p = at - first_pressure;
      if (p >= 0 && p < pressures)
        product.left(i - row, rank + 3 + p) +=
            slopes_[node].by_pressure[static_cast<std::size_t>(k)];
    }
  }
  return product;
}

void Jacobian::factor(int index) {
  const KernelPart& part = kernel_.part(index);
  Factor& own = factors_[static_cast<std::size_t>(index)];
  if (part.middle == 0) {
    own.lu.compute(leaf_block(part));
    return;
  }
  factor(part.first);
  factor(part.second);
  ThinProduct upper = between(part, true), lower = between(part, false);
  solve_part(part.first, upper.left);
  solve_part(part.second, lower.left);
  const Eigen::Index of_upper = upper.left.cols(), of_lower = lower.left.cols();
  // Let s = upper.rightᵀ x₂ and t = lower.rightᵀ x₁. The halves, solved alone, give the values
  // s + (upper.rightᵀ second_left) t and t + (lower.rightᵀ first_left) s: equations for s and t.
  Eigen::MatrixXd joint = Eigen::MatrixXd::Identity(of_upper + of_lower, of_upper + of_lower);
  joint.topRightCorner(of_upper, of_lower) = upper.right.transpose() * lower.left;
  joint.bottomLeftCorner(of_lower, of_upper) = lower.right.transpose() * upper.left;
  own.lu.compute(joint);
  own.first_left = std::move(upper.left);
  own.second_left = std::move(lower.left);
  own.upper_right = std::move(upper.right);
  own.lower_right = std::move(lower.right);
}

void Jacobian::solve_part(int index, Eigen::Ref<Eigen::MatrixXd> b) const {
  const KernelPart& part = kernel_.part(index);
  const Factor& own = factors_[static_cast<std::size_t>(index)];
  if (part.middle == 0) {
    b = own.lu.solve(b).eval();
    return;
  }
  auto first = b.topRows(part.middle - part.begin);
  auto second = b.bottomRows(part.end - part.middle);
  solve_part(part.first, first);
  solve_part(part.second, second);
  const Eigen::Index of_upper = own.upper_right.cols(), of_lower = own.lower_right.cols();
  Eigen::MatrixXd both(of_upper + of_lower, b.cols());
  both.topRows(of_upper) = own.upper_right.transpose() * second;
  both.bottomRows(of_lower) = own.lower_right.transpose() * first;
  both = own.lu.solve(both).eval();
  first -= own.first_left * both.topRows(of_upper);
  second -= own.second_left * both.bottomRows(of_lower);
}

Eigen::MatrixXd Jacobian::solve(Eigen::MatrixXd right_hand_sides) const {
  solve_part(kernel_.root(), right_hand_sides);
  return right_hand_sides;
}

std::size_t Jacobian::bytes() const {
  Eigen::Index numbers = 0;
  for (const Factor& f : factors_)
    numbers += f.lu.matrixLU().size() + f.upper_right.size() + f.lower_right.size() +
               f.first_left.size() + f.second_left.size();
  return static_cast<std::size_t>(numbers) * sizeof(double);
}

}  // namespace tribo::ehl
