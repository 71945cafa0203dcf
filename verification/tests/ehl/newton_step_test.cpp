// SPDX-License-Identifier: Apache-2.0
// Tests of the parts of a Newton step. The balance of the liquid's mass is compared with a known
// flow, its derivatives with differences, and the solution of the linear equations with that of a
// full matrix.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

#include "ehl/films.hpp"
#include "ehl/grids.hpp"
#include "ehl/jacobian.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The matrix of the rows J_i = Σ_k by_film[k] K_{i−2+k} + by_pressure[k] e_{i−2+k}. The row of a
// node that is held is e_i.
MatrixXd full_jacobian(const ehl::FilmKernel& kernel, const std::vector<ehl::BalanceSlopes>& slopes,
                       const std::vector<char>& is_free) {
  const int count = kernel.size();
  MatrixXd j = MatrixXd::Zero(count, count);
  for (int i = 0; i < count; ++i) {
    const auto node = static_cast<std::size_t>(i);
    if (is_free[node] == 0) {
      j(i, i) = 1;
      continue;
    }
    for (int k = 0; k < 4; ++k) {
      const int at = i - 2 + k;
      if (at < 0 || at >= count) continue;
      for (int column = 0; column < count; ++column)
        j(i, column) +=
            slopes[node].by_film[static_cast<std::size_t>(k)] * kernel.entry(at, column);
      j(i, at) += slopes[node].by_pressure[static_cast<std::size_t>(k)];
    }
  }
  return j;
}

// A leaf of n nodes keeps n² numbers. Two leaves that are joined keep 2n² numbers. The two blocks
// between them are products left · rightᵀ of r and s columns. Each of these columns adds 2n
// numbers, and the system that joins the leaves has (r + s)².
TEST(Jacobian, CountsTheBytesOfAllItsBlocks) {
  Sampler sampler(12);
  const auto numbers = [&](int count) {
    const std::vector<double> x = uneven_nodes(count, -20, 2, sampler);
    const ehl::FilmKernel kernel(x);
    ehl::BalanceSlopes slope;
    slope.by_film = {0.3, -0.5, 0.7, 0.2};
    slope.by_pressure = {0.1, -0.2, 4, 0.3};
    const std::vector<ehl::BalanceSlopes> slopes(x.size(), slope);
    const std::vector<char> is_free(x.size(), 1);
    return ehl::Jacobian(kernel, slopes, is_free).bytes() / sizeof(double);
  };
  for (const std::size_t count : {5U, 40U, 64U})
    EXPECT_EQ(numbers(static_cast<int>(count)), count * count);
  for (const std::size_t half : {40U, 50U, 64U}) {
    const std::size_t blocks = numbers(static_cast<int>(2 * half)) - 2 * half * half;
    std::size_t products = 1;
    while (products * products + 2 * half * products < blocks) ++products;
    EXPECT_EQ(products * products + 2 * half * products, blocks) << half;
    EXPECT_LT(products, half);
  }
}

TEST(Jacobian, SolvesTheFullMatrixWithSomeNodesHeld) {
  Sampler sampler(11);
  for (const int count : {5, 40, 64, 65, 66, 127, 128, 129, 193, 300, 513, 700}) {
    const std::vector<double> x = uneven_nodes(count, -20, 2, sampler);
    const ehl::FilmKernel kernel(x);
    std::vector<ehl::BalanceSlopes> slopes(x.size());
    std::vector<char> is_free(x.size(), 1);
    const double held = sampler.pick({0.0, 0.1, 0.5});
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        slopes[i].by_film[k] = sampler.uniform(-1, 1);
        slopes[i].by_pressure[k] = sampler.uniform(-1, 1) + (k == 2 ? 4 : 0);
      }
      if (i == 0 || i + 1 == x.size() || sampler.uniform(0, 1) < held) is_free[i] = 0;
    }
    MatrixXd expected(count, 2);
    for (Index i = 0; i < expected.size(); ++i) expected.data()[i] = sampler.uniform(-1, 1);
    const MatrixXd full = full_jacobian(kernel, slopes, is_free);
    const MatrixXd got = ehl::Jacobian(kernel, slopes, is_free).solve(full * expected);
    const MatrixXd by_full = full.partialPivLu().solve(full * expected);
    // The error of a block between halves is up to 1e-8 of its norm (film_kernel.hpp). A single
    // leaf has no such error.
    const double bound = count <= 64 ? 1e-9 : 1e-7;
    EXPECT_TRUE(is_within((got - by_full).cwiseAbs().maxCoeff(), 0, bound)) << count << " nodes";
    EXPECT_TRUE(is_within((got - expected).cwiseAbs().maxCoeff(), 0, bound)) << count << " nodes";
  }
}

TEST(Balance, SlopesAreItsDerivatives) {
  Sampler sampler(12);
  constexpr int count = 14;
  for (const ehl::LineContact& contact : three_liquids(20, 3))
    for (int trial = 0; trial < 20; ++trial) {
      const std::vector<double> x = uneven_nodes(count, -2, 1.5, sampler);
      VectorXd pressure(count), film(count);
      // In half of the trials neighbours differ so little that a series gives the mean fluidity.
      const double spread = trial % 2 == 0 ? 1 : 1e-3;
      for (int i = 0; i < count; ++i) {
        pressure[i] = 0.3 + spread * sampler.uniform(0, 0.5);
        film[i] = sampler.log_uniform(0.05, 0.5);
      }
      const ehl::Balance balance = ehl::balance_of(contact, x, pressure, film);
      const auto check = [&](VectorXd& values, const auto& slope_of, const char* name) {
        for (int j = 0; j < count; ++j) {
          const double here = values[j], step = 1e-5 * here;
          values[j] = here + step;
          const VectorXd above = ehl::balance_of(contact, x, pressure, film, false).surplus;
          values[j] = here - step;
          const VectorXd below = ehl::balance_of(contact, x, pressure, film, false).surplus;
          values[j] = here;
          for (int i = 1; i + 1 < count; ++i) {
            const int k = j - i + 2;
            const auto& slopes = slope_of(balance.slopes[static_cast<std::size_t>(i)]);
            const double got = k >= 0 && k < 4 ? slopes[static_cast<std::size_t>(k)] : 0;
            const double scale = std::abs(slopes[0]) + std::abs(slopes[1]) + std::abs(slopes[2]) +
                                 std::abs(slopes[3]);
            EXPECT_TRUE(is_within(got, (above[i] - below[i]) / (2 * step), 1e-7 * scale))
                << "surplus of node " << i << " by the " << name << " at " << j;
          }
        }
      };
      check(
          pressure, [](const ehl::BalanceSlopes& s) { return s.by_pressure; }, "pressure");
      check(
          film, [](const ehl::BalanceSlopes& s) { return s.by_film; }, "film");
    }
}

TEST(Balance, SurplusIsTheDifferenceOfFlowsAndZeroAtTheEnds) {
  Sampler sampler(13);
  const std::vector<double> x = uneven_nodes(20, -2, 1.5, sampler);
  VectorXd pressure(20), film(20);
  for (int i = 0; i < 20; ++i) {
    pressure[i] = sampler.uniform(0, 1);
    film[i] = sampler.uniform(0.1, 1);
  }
  const ehl::Balance balance = ehl::balance_of(ehl::barus_contact(5, 3), x, pressure, film);
  EXPECT_EQ(balance.surplus[0], 0);
  EXPECT_EQ(balance.surplus[19], 0);
  for (int i = 1; i < 19; ++i)
    EXPECT_TRUE(is_within(balance.surplus[i], balance.flow[i] - balance.flow[i - 1], 1e-15));
}

// Pressure and film are given functions. The flow is therefore known everywhere, and is computed in
// long double.
TEST(Balance, MeetsAGivenFlowAtSecondOrder) {
  using Long = long double;
  const auto pressure_at = [](Long x) {
    const Long u = (x + 2) * (1.5L - x);
    return u * u / 12;
  };
  const auto slope_at = [](Long x) { return (x + 2) * (1.5L - x) * (-0.5L - 2 * x) / 6; };
  const auto film_at = [](Long x) { return 0.3L + 0.2L * x * x + 0.05L * std::sin(3 * x); };
  for (const ehl::LineContact& contact : three_liquids(5, 4)) {
    const auto flow_at = [&](Long x) {
      const Long p = pressure_at(x), h = film_at(x);
      const ehl::Fluid& fluid = contact.fluid;
      const Long density =
          1 + 0.34L * fluid.density_pressure * p / (1 + fluid.density_pressure * p);
      Long log_viscosity = fluid.exponent * p;
      if (fluid.roelands_pressure > 0)
        log_viscosity = fluid.exponent / (fluid.roelands_index * fluid.roelands_pressure) *
                        (std::pow(1 + fluid.roelands_pressure * p, Long{fluid.roelands_index}) - 1);
      return density * h -
             density * h * h * h * std::exp(-log_viscosity) / contact.theta() * slope_at(x);
    };
    std::array<double, 3> of_flow{}, of_surplus{};
    for (std::size_t grid = 0; grid < 3; ++grid) {
      const int cells = 1600 << grid;
      std::vector<double> x;
      VectorXd pressure(cells + 1), film(cells + 1);
      for (int i = 0; i <= cells; ++i) {
        const double share = static_cast<double>(i) / cells;
        x.push_back(-2 + 3.5 * (share + 0.1 * std::sin(2 * std::numbers::pi * share)));
        pressure[i] = static_cast<double>(pressure_at(x.back()));
        film[i] = static_cast<double>(film_at(x.back()));
      }
      const ehl::Balance balance = ehl::balance_of(contact, x, pressure, film, false);
      const auto middle = [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        return (Long{x[k]} + Long{x[k + 1]}) / 2;
      };
      for (int i = 0; i < cells; ++i) {
        const auto off = static_cast<double>(balance.flow[i] - flow_at(middle(i)));
        of_flow[grid] = std::max(of_flow[grid], std::abs(off));
        if (i < 2) continue;  // the first flow is not extrapolated
        const auto difference =
            static_cast<double>(balance.surplus[i] - (flow_at(middle(i)) - flow_at(middle(i - 1))));
        of_surplus[grid] =
            std::max(of_surplus[grid],
                     std::abs(difference) / static_cast<double>(middle(i) - middle(i - 1)));
      }
    }
    EXPECT_LT(of_flow[0], 1e-2);
    EXPECT_TRUE(is_second_order(of_flow)) << "flow";
    EXPECT_TRUE(is_second_order(of_surplus)) << "surplus over the distance";
  }
}

// Eigen cuts matrix products by these cache sizes, which so decide the order of the sums.
TEST(NewtonStep, ProductsAreCutByTheSameSizesOnEveryMachine) {
  EXPECT_EQ(Eigen::l1CacheSize(), 32 * 1024);
  EXPECT_EQ(Eigen::l2CacheSize(), 256 * 1024);
  EXPECT_EQ(Eigen::l3CacheSize(), 2048 * 1024);
}

}  // namespace
}  // namespace tribo::verification
