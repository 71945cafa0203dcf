// SPDX-License-Identifier: Apache-2.0
// The factors of plane grids, against products with the matrix itself.
#include "ehl/plane_factors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "sampling/sampler.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Entries = std::vector<Eigen::Triplet<double>>;

ehl::PlaneGrid grid_of(int across, int along) { return {across - 1, 0, along - 1, 0.1, 0.1}; }

// A matrix whose rows have sizes from 1e-30 to 1e30. The entry of the node before along X may be
// greater than the diagonal, as where drag moves more liquid than the pressure does.
Entries random_entries(const ehl::PlaneGrid& grid, Sampler& sampler) {
  Entries entries;
  for (int j = 0; j < grid.count_y(); ++j)
    for (int i = 0; i < grid.count_x(); ++i) {
      const double size = sampler.log_uniform(1e-30, 1e30);
      const auto add = [&](int to_i, int to_j, double value) {
        if (to_i < 0 || to_j < 0 || to_i >= grid.count_x() || to_j >= grid.count_y()) return;
        entries.emplace_back(static_cast<int>(grid.node(i, j)),
                             static_cast<int>(grid.node(to_i, to_j)), size * value);
      };
      add(i, j, sampler.uniform(3, 4));
      add(i - 2, j, sampler.uniform(-0.5, 0.5));
      add(i - 1, j, sampler.uniform(-5, 0));
      add(i + 1, j, sampler.uniform(-0.5, 0.5));
      add(i, j - 1, sampler.uniform(-0.5, 0.5));
      add(i, j + 1, sampler.uniform(-0.5, 0.5));
    }
  return entries;
}

VectorXd product(const Entries& entries, const VectorXd& with) {
  VectorXd result = VectorXd::Zero(with.size());
  for (const auto& entry : entries) result[entry.row()] += entry.value() * with[entry.col()];
  return result;
}

TEST(PlaneFactors, UndoTheMatrixToSinglePrecisionOnGridsOfAllShapes) {
  Sampler sampler(1);
  constexpr std::pair<int, int> shapes[]{{1, 1}, {1, 40}, {40, 1},  {2, 9},   {3, 3},
                                         {5, 2}, {17, 5}, {64, 33}, {33, 64}, {90, 41}};
  for (const auto& [across, along] : shapes) {
    SCOPED_TRACE(testing::Message() << across << " by " << along << " nodes");
    const ehl::PlaneGrid grid = grid_of(across, along);
    ehl::PlaneFactors factors(grid);
    for (int matrix = 0; matrix < 2; ++matrix) {  // the second one has the places of the first
      const Entries entries = random_entries(grid, sampler);
      VectorXd expected(grid.size());
      for (Index node = 0; node < grid.size(); ++node) expected[node] = sampler.uniform(-1, 1);
      ASSERT_TRUE(factors.factor(entries));
      const VectorXd got = factors.solve(product(entries, expected));
      EXPECT_TRUE(is_within((got - expected).cwiseAbs().maxCoeff(), 0, 1e-5));
    }
  }
}

TEST(PlaneFactors, SayWhereThereAreNone) {
  Sampler sampler(2);
  const ehl::PlaneGrid grid = grid_of(9, 7);
  const Entries entries = random_entries(grid, sampler);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Entries one_bad = entries;
    const auto entry = one_bad[40];
    one_bad[40] = {entry.row(), entry.col(), bad};
    EXPECT_EQ(ehl::PlaneFactors(grid).factor(one_bad), false) << bad;
  }
  Entries without_a_row = entries, without_a_column = entries;
  for (auto& entry : without_a_row)
    if (entry.row() == 30) entry = {entry.row(), entry.col(), 0};
  for (auto& entry : without_a_column)
    if (entry.col() == 30) entry = {entry.row(), entry.col(), 0};
  EXPECT_EQ(ehl::PlaneFactors(grid).factor(without_a_row), false);
  EXPECT_EQ(ehl::PlaneFactors(grid).factor(without_a_column), false);
  EXPECT_EQ(ehl::PlaneFactors(grid).factor(entries), true);
}

}  // namespace
}  // namespace tribo::verification
