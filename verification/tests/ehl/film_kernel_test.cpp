// SPDX-License-Identifier: Apache-2.0
// Checks the film that a pressure raises: of one hat function by quadrature, of many by their
// direct sum, and of Hertz' pressure by its closed form.
#include "ehl/film_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "ehl/grids.hpp"
#include "ehl/influence.hpp"
#include "generators/log_element.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

// ∫ f(s) ln|r − s| ds from a to b. Near r the variable is the distance from r, because the
// logarithm needs its digits; far from r it is s, because f does.
template <class Function>
double with_log(double r, double a, double b, const Function& f) {
  static boost::math::quadrature::tanh_sinh<double> quadrature;
  if (r > a && r < b) return with_log(r, a, r, f) + with_log(r, r, b, f);
  if (r < 2 * a - b || r > 2 * b - a)
    return quadrature.integrate([&](double s) { return f(s) * std::log(std::abs(r - s)); }, a, b,
                                1e-15);
  const double sign = a >= r ? 1 : -1;
  const double near = sign > 0 ? a - r : r - b, far = sign > 0 ? b - r : r - a;
  return quadrature.integrate(
      [&](double apart) { return apart > 0 ? f(r + sign * apart) * std::log(apart) : 0.0; }, near,
      far, 1e-15);
}

void expect_film_of_hat(double left, double right, std::initializer_list<double> places) {
  for (const double r : places) {
    const double expected = -(with_log(r, -left, 0, [&](double s) { return 1 + s / left; }) +
                              with_log(r, 0, right, [&](double s) { return 1 - s / right; })) /
                            pi;
    const double area = (left + right) / 2;
    EXPECT_TRUE(
        is_within(ehl::film_of_hat(r, left, right), expected, 1e-13 * (area + std::abs(expected))))
        << "r = " << r << ", left = " << left << ", right = " << right;
  }
}

TEST(FilmOfHat, IsTheIntegralAtEveryDistance) {
  Sampler sampler(1);
  for (int i = 0; i < 300; ++i) {
    const double left = sampler.log_uniform(1e-6, 10);
    const double right = left * sampler.log_uniform(0.5, 2);
    const double sign = sampler.pick({-1.0, 1.0});
    const double anywhere = sign * left * sampler.log_uniform(1e-3, 1e5);
    const double where_ways_meet = sign * left * sampler.uniform(7, 17);
    expect_film_of_hat(left, right, {anywhere, where_ways_meet, 0, right, -left});
  }
}

TEST(FilmOfHat, IsTheIntegralForUnequalNeighbours) {
  Sampler sampler(2);
  for (int i = 0; i < 300; ++i) {
    const double left = sampler.log_uniform(1e-4, 1);
    const double right = left * sampler.log_uniform(1e-4, 1e4);
    const double sign = sampler.pick({-1.0, 1.0});
    const double anywhere = sign * std::max(left, right) * sampler.log_uniform(1e-3, 100);
    expect_film_of_hat(left, right, {anywhere, 0, right});
  }
}

TEST(FilmKernel, ProductIsTheDirectSum) {
  Sampler sampler(3);
  for (const int count : {3, 5, 64, 65, 66, 130, 300, 700}) {
    const std::vector<double> x = uneven_nodes(count, -50, 2, sampler);
    const ehl::FilmKernel kernel(x);
    for (int kind = 0; kind < 3; ++kind) {
      VectorXd pressure(count), direct = VectorXd::Zero(count);
      for (int i = 0; i < count; ++i) pressure[i] = kind == 0 ? 1 : sampler.uniform(-1, 1);
      if (kind == 2) pressure = VectorXd::Unit(count, count / 3);
      for (int i = 0; i < count; ++i)
        for (int j = 1; j + 1 < count; ++j)
          direct[i] +=
              pressure[j] *
              ehl::film_of_hat(x[static_cast<std::size_t>(i)] - x[static_cast<std::size_t>(j)],
                               x[static_cast<std::size_t>(j)] - x[static_cast<std::size_t>(j) - 1],
                               x[static_cast<std::size_t>(j) + 1] - x[static_cast<std::size_t>(j)]);
      const VectorXd product = kernel * pressure;
      for (int i = 0; i < count; ++i)
        EXPECT_TRUE(is_within(product[i], direct[i], 1e-11 * direct.cwiseAbs().maxCoeff()))
            << "node " << i << " of " << count;
    }
  }
}

TEST(FilmKernel, EntriesOutsideAreZero) {
  const std::vector<double> x{-2, -1, 0, 1, 2};
  const ehl::FilmKernel kernel(x);
  for (const int row : {-1, 5}) EXPECT_EQ(kernel.entry(row, 2), 0);
  for (const int column : {0, 4}) EXPECT_EQ(kernel.entry(2, column), 0);
  EXPECT_EQ(kernel.entry(1, 3), ehl::film_of_hat(-2, 1, 1));
}

// −(1/π) ∫ √(1 − t²) ln|X − t| dt = (1 + 2 ln 2)/4 − X²/2 for |X| ≤ 1.
TEST(FilmKernel, HertzPressureLiftsTheFilmByAParabolaAtSecondOrder) {
  std::array<double, 3> errors{};
  for (int grid = 0; grid < 3; ++grid) {
    const int cells = 50 << grid;
    std::vector<double> x;
    VectorXd pressure(cells + 1);
    for (int i = 0; i <= cells; ++i) {
      x.push_back(-std::cos(pi * i / cells));
      pressure[i] = std::sqrt(std::max(0.0, 1 - x.back() * x.back()));
    }
    const VectorXd film = ehl::FilmKernel(x) * pressure;
    for (int i = 0; i <= cells; ++i) {
      const double at = x[static_cast<std::size_t>(i)];
      const double exact = (1 + 2 * std::log(2)) / 4 - at * at / 2;
      double& error = errors[static_cast<std::size_t>(grid)];
      error = std::max(error, std::abs(film[i] - exact));
    }
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_TRUE(is_second_order(errors));
}

// The element of the second method, against the same quadrature.
TEST(LogElement, WeightsAreTheIntegralsOfItsPolynomials) {
  Sampler sampler(4);
  for (const int degree : {1, 2, 3, 4, 5}) {
    const reference::LogElement element(degree);
    const auto polynomial = [&](int k, double t) {
      double product = 1;
      for (int j = 0; j <= degree; ++j)
        if (j != k) product *= (t - element.nodes()[j]) / (element.nodes()[k] - element.nodes()[j]);
      return product;
    };
    std::vector<double> places{-1, 1, 0, element.nodes()[degree / 2], 2.499, -2.501, -9.99, -10.01};
    for (int i = 0; i < 20; ++i)
      places.push_back(sampler.pick({-1.0, 1.0}) * sampler.log_uniform(1e-2, 1e4));
    for (const double z : places) {
      const reference::LogElement::Weights weights = element.log_weights(z);
      for (int k = 0; k <= degree; ++k)
        EXPECT_TRUE(is_within(
            weights[k], with_log(z, -1, 1, [&](double t) { return polynomial(k, t); }), 2e-12))
            << "degree " << degree << ", node " << k << ", z = " << z;
    }
  }
}

TEST(LogElement, SlopesAndIntegralsArePolynomials) {
  for (const int degree : {1, 2, 3, 4, 5}) {
    const reference::LogElement element(degree);
    for (int power = 0; power <= degree; ++power) {
      const VectorXd values = element.nodes().array().pow(power);
      EXPECT_TRUE(
          is_within(element.integral().dot(values), power % 2 == 0 ? 2.0 / (power + 1) : 0, 1e-13));
      const VectorXd slopes = element.slopes() * values;
      for (int k = 0; k <= degree; ++k) {
        const double expected = power == 0 ? 0 : power * std::pow(element.nodes()[k], power - 1);
        EXPECT_TRUE(is_within(slopes[k], expected, 1e-11));
      }
    }
  }
}

}  // namespace
}  // namespace tribo::verification
