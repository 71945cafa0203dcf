// SPDX-License-Identifier: Apache-2.0
#include "ehl/plane_factors.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace tribo::ehl {
namespace {

// Nodes of columns first_x to last_x − 1 and of rows first_y to last_y − 1.
struct Block {
  int first_x, last_x, first_y, last_y;
  int width() const { return last_x - first_x; }
  int height() const { return last_y - first_y; }
};

// Nested dissection: a strip of nodes cuts a block into two halves that no matrix entry joins, and
// is eliminated after both. A strip across X is two nodes wide, because entries join each node with
// the second node before it. Source: A. George: Nested dissection of a regular finite element mesh.
// SIAM J. Numer. Anal. 10 (1973) 345.
void order(const PlaneGrid& grid, Block block, int& next, std::vector<int>& places) {
  const auto number = [&](const Block& of) {
    for (int j = of.first_y; j < of.last_y; ++j)
      for (int i = of.first_x; i < of.last_x; ++i)
        places[static_cast<std::size_t>(grid.node(i, j))] = next++;
  };
  constexpr int least_nodes = 8;  // with 6 or 12 the factors take as long
  if (block.width() * block.height() <= least_nodes) return number(block);
  Block before = block, strip = block, behind = block;
  if (block.width() > 2 * block.height()) {
    strip.first_x = before.last_x = block.first_x + (block.width() - 2) / 2;
    behind.first_x = strip.last_x = strip.first_x + 2;
  } else {
    strip.first_y = before.last_y = block.first_y + (block.height() - 1) / 2;
    behind.first_y = strip.last_y = strip.first_y + 1;
  }
  order(grid, before, next, places);
  order(grid, behind, next, places);
  number(strip);
}

}  // namespace

PlaneFactors::PlaneFactors(const PlaneGrid& grid) : places_(static_cast<std::size_t>(grid.size())) {
  int next = 0;
  order(grid, {0, grid.count_x(), 0, grid.count_y()}, next, places_);
  // The order of elimination is kept where a diagonal entry is at least 0.1 of its column's
  // greatest. With 0 or 1 a contact took as many steps, and with 1 its factors were 4 % larger.
  factors_.setPivotThreshold(0.1F);
}

Eigen::SparseMatrix<float> PlaneFactors::scaled(
    const std::vector<Eigen::Triplet<double>>& entries) {
  const auto size = static_cast<Eigen::Index>(places_.size());
  row_scales_ = Eigen::VectorXd::Zero(size);
  for (const auto& entry : entries)
    row_scales_[entry.row()] = std::fmax(row_scales_[entry.row()], std::fabs(entry.value()));
  row_scales_ = row_scales_.cwiseInverse();
  std::vector<Eigen::Triplet<float>> ordered;
  ordered.reserve(entries.size());
  for (const auto& entry : entries)
    ordered.emplace_back(places_[static_cast<std::size_t>(entry.row())],
                         places_[static_cast<std::size_t>(entry.col())],
                         static_cast<float>(row_scales_[entry.row()] * entry.value()));
  Eigen::SparseMatrix<float> matrix(size, size);
  matrix.setFromTriplets(ordered.begin(), ordered.end());
  return matrix;
}

bool PlaneFactors::factor(std::vector<Eigen::Triplet<double>> entries) {
  // The entries are freed before the factors take memory.
  const Eigen::SparseMatrix<float> matrix = scaled(std::exchange(entries, {}));
  const Eigen::Map<const Eigen::VectorXf> values(matrix.valuePtr(), matrix.nonZeros());
  if (!values.allFinite()) return false;
  if (factors_.rows() == 0) factors_.analyzePattern(matrix);
  factors_.factorize(matrix);
  return factors_.info() == Eigen::Success;
}

Eigen::VectorXd PlaneFactors::solve(const Eigen::VectorXd& side) const {
  Eigen::VectorXf ordered(side.size());
  for (Eigen::Index node = 0; node < side.size(); ++node)
    ordered[places_[static_cast<std::size_t>(node)]] =
        static_cast<float>(row_scales_[node] * side[node]);
  const Eigen::VectorXf solved = factors_.solve(ordered);
  Eigen::VectorXd result(side.size());
  for (Eigen::Index node = 0; node < side.size(); ++node)
    result[node] = static_cast<double>(solved[places_[static_cast<std::size_t>(node)]]);
  return result;
}

}  // namespace tribo::ehl
