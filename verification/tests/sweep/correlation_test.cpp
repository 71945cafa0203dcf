// SPDX-License-Identifier: Apache-2.0
#include "sweep/correlation.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/judge.hpp"
#include "sweep/design.hpp"

namespace tribo::verification {
namespace {

using sweep::correlate;
using sweep::correlation_root;
using Matrix = std::vector<std::vector<double>>;

constexpr double ulp = std::numeric_limits<double>::epsilon();

double standard_normal(double u) {
  sweep::standard_normals(std::span(&u, 1));
  return u;
}

// The error of z is the difference of P(Z < z) and u, over the slope of P.
TEST(StandardNormal, IsExactToFourUlp) {
  std::mt19937_64 words(1);
  std::vector<double> numbers{sweep::least_unit_number,    0.5 - 0x1p-53, 0.5 + 0x1p-53, 0.25, 0.75,
                              1 - sweep::least_unit_number};
  for (int i = 0; i < 400; ++i) {
    const double small = sweep::unit_number(words() >> (words() % 52));
    const double around = 0.5 + (sweep::unit_number(words()) - 0.5) * std::ldexp(1, -(i % 45));
    numbers.insert(numbers.end(), {sweep::unit_number(words()), small, 1 - small, around});
  }
  for (const double u : numbers) {
    if (u == 0.5) continue;
    const double z = standard_normal(u);
    const Reference below = boost::math::erfc(Reference(-Reference(z) / sqrt(Reference(2)))) / 2;
    const Reference slope =
        exp(Reference(-Reference(z) * z / 2)) / sqrt(2 * boost::math::constants::pi<Reference>());
    EXPECT_TRUE(is_within(static_cast<double>((below - u) / slope), 0, 4 * ulp * std::abs(z)))
        << describe({{"u", u}, {"z", z}});
  }
  EXPECT_EQ(standard_normal(0.5), 0);
}

TEST(StandardNormal, IsOdd) {
  std::mt19937_64 words(2);
  for (int i = 0; i < 10000; ++i) {
    const double u = sweep::unit_number(words());
    EXPECT_EQ(standard_normal(u), -standard_normal(1 - u)) << describe({{"u", u}});
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(standard_normal(0), -infinity);
  EXPECT_EQ(standard_normal(1), infinity);
}

// The cosines between k random directions in n dimensions.
Matrix random_matrix(std::size_t k, std::size_t n, std::uint64_t seed) {
  Sampler sampler(seed);
  std::vector<std::vector<double>> directions(k, std::vector<double>(n));
  for (auto& direction : directions) {
    double squares = 0;
    for (double& x : direction) {
      x = sampler.uniform(-1, 1);
      squares += x * x;
    }
    for (double& x : direction) x /= std::sqrt(squares);
  }
  Matrix matrix(k, std::vector<double>(k, 1));
  for (std::size_t i = 0; i < k; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double cosine = 0;
      for (std::size_t d = 0; d < n; ++d) cosine += directions[i][d] * directions[j][d];
      matrix[i][j] = matrix[j][i] = cosine;
    }
  return matrix;
}

TEST(CorrelationRoot, TimesItsTransposeIsTheMatrix) {
  for (const std::size_t k : {1, 2, 3, 8, 40, 100}) {
    const Matrix matrix = random_matrix(k, k + 3, k);
    const sweep::CorrelationRoot root = correlation_root(matrix);
    ASSERT_EQ(root.fault, "");
    ASSERT_EQ(root.rows.size(), k);
    for (std::size_t i = 0; i < k; ++i) {
      EXPECT_EQ(root.rows[i].size(), i + 1);
      EXPECT_GT(root.rows[i][i], 0);
      for (std::size_t j = 0; j <= i; ++j) {
        double product = 0;
        for (std::size_t d = 0; d <= j; ++d) product += root.rows[i][d] * root.rows[j][d];
        EXPECT_TRUE(is_within(product, matrix[i][j], 4 * ulp)) << i << ", " << j << " of " << k;
      }
    }
  }
}

TEST(CorrelationRoot, OfAMatrixThatIsNotPositiveDefiniteSaysItsLeastEigenvalue) {
  // Three variables of one correlation ρ: eigenvalues 1 − ρ, 1 − ρ, 1 + 2ρ.
  const auto equal = [](double rho) { return Matrix{{1, rho, rho}, {rho, 1, rho}, {rho, rho, 1}}; };
  EXPECT_EQ(correlation_root(equal(-0.6)).fault,
            "not positive definite: its least eigenvalue is -0.2");
  EXPECT_EQ(correlation_root(equal(1)).fault, "not positive definite: its least eigenvalue is 0");
  EXPECT_EQ(correlation_root({{1, 2}, {2, 1}}).fault,
            "not positive definite: its least eigenvalue is -1");
  EXPECT_EQ(correlation_root(equal(-0.6)).rows.size(), 0U);
  EXPECT_EQ(correlation_root(equal(-0.4999)).fault, "");
  EXPECT_EQ(correlation_root(random_matrix(9, 5, 1)).fault,
            "not positive definite: its least eigenvalue is 0");
}

TEST(Correlate, GivesDrawsThisCorrelation) {
  const Matrix matrix{{1, 0.8, -0.5}, {0.8, 1, 0}, {-0.5, 0, 1}};
  const sweep::CorrelationRoot root = correlation_root(matrix);
  ASSERT_EQ(root.fault, "");
  constexpr std::size_t draws = 1000000, block = 1000;
  sweep::UnitPoints points(sweep::Design::monte_carlo, 3, draws, 1);
  std::vector<double> u(3 * block);
  Matrix products(3, std::vector<double>(3));
  for (std::size_t first = 0; first < draws; first += block) {
    points.points(first, u);
    for (std::size_t i = 0; i < block; ++i) {
      const std::span<double> z(&u[3 * i], 3);
      sweep::standard_normals(z);
      correlate(root.rows, z);
      for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t e = 0; e <= d; ++e) products[d][e] += z[d] * z[e] / draws;
    }
  }
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t e = 0; e <= d; ++e)
      // the variance of a product of two normals is 1 + ρ²
      EXPECT_TRUE(is_within(products[d][e], matrix[d][e],
                            4 * std::sqrt((1 + matrix[d][e] * matrix[d][e]) / draws)))
          << d << ", " << e;
}

}  // namespace
}  // namespace tribo::verification
