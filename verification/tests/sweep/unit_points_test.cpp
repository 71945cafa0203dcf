// SPDX-License-Identifier: Apache-2.0
// The designs by their definition: the number of points in each cell.
#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/judge.hpp"
#include "sweep/design.hpp"
#include "sweep/small_sweep.hpp"

namespace tribo::verification {
namespace {

using sweep::Design;
using sweep::error_of;
using sweep::UnitPoints;

constexpr std::array designs{Design::monte_carlo, Design::latin_hypercube, Design::sobol};

std::vector<double> all_points(Design design, std::size_t dimensions, std::uint64_t points,
                               std::uint64_t seed) {
  std::vector<double> coordinates(dimensions * static_cast<std::size_t>(points));
  UnitPoints(design, dimensions, points, seed).points(0, coordinates);
  return coordinates;
}

// ⌊uN⌋, exactly: the coordinate is an odd number of 2⁻⁵³.
std::uint64_t cell_of(double u, std::uint64_t cells) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::uint64_t>(static_cast<Wide>(u * 0x1p53) * cells >> 53);
}

TEST(UnitPoints, AreTheNumbersThatUnitNumberComesTo) {
  for (const Design design : designs)
    for (const double u : all_points(design, 7, 3001, 1)) {
      EXPECT_GE(u, sweep::least_unit_number) << name(design);
      EXPECT_LE(u, 1 - sweep::least_unit_number) << name(design);
      EXPECT_EQ(std::fmod(u * 0x1p53, 2), 1) << name(design) << describe({{"u", u}});
    }
}

TEST(UnitPoints, AreTheSameOneByOneAndInBlocksInAnyOrder) {
  constexpr std::uint64_t points = 5000;
  for (const Design design : designs)
    for (const std::size_t dimensions : {std::size_t{1}, std::size_t{2}, std::size_t{5}}) {
      const std::vector<double> expected = all_points(design, dimensions, points, 42);
      UnitPoints unit_points(design, dimensions, points, 42);
      std::mt19937_64 words(dimensions);
      for (int i = 0; i < 300; ++i) {
        const std::uint64_t first = i == 0 ? points - 1 : words() % points;
        const std::uint64_t count = std::min(words() % 70, points - first);
        std::vector<double> got(static_cast<std::size_t>(count) * dimensions);
        unit_points.points(first, got);
        const auto at = expected.begin() + static_cast<std::ptrdiff_t>(first * dimensions);
        EXPECT_EQ(got, std::vector<double>(at, at + static_cast<std::ptrdiff_t>(got.size())))
            << name(design) << " in " << dimensions << " dimensions, points " << first << " to "
            << first + count;
      }
      // and in a row
      UnitPoints in_a_row(design, dimensions, points, 42);
      std::vector<double> got;
      for (std::uint64_t first = 0; first < points;) {
        std::vector<double> block(
            static_cast<std::size_t>(std::min(1 + words() % 97, points - first)) * dimensions);
        in_a_row.points(first, block);
        first += block.size() / dimensions;
        got.insert(got.end(), block.begin(), block.end());
      }
      EXPECT_EQ(got, expected) << name(design);
    }
}

TEST(UnitPoints, PointsThatTheDesignDoesNotHaveAreRefused) {
  for (const Design design : designs) {
    UnitPoints unit_points(design, 2, 10, 1);
    const auto fault_from = [&](std::uint64_t first) {
      std::vector<double> three(6);
      return error_of([&] { unit_points.points(first, three); });
    };
    EXPECT_EQ(fault_from(7), "none") << name(design);
    EXPECT_EQ(error_of([&] {
                std::vector<double> one(2);
                UnitPoints(design, 2, 0, 1).points(0, one);
              }),
              "the design has no such point")
        << name(design);
    EXPECT_EQ(fault_from(8), "the design has no such point") << name(design);
    EXPECT_EQ(fault_from(std::numeric_limits<std::uint64_t>::max()), "the design has no such point")
        << name(design);
  }
  EXPECT_EQ(error_of([] { UnitPoints(Design::factorial, 2, 10, 1); }),
            "a factorial design draws nothing");
  EXPECT_EQ(
      error_of([] { UnitPoints(Design::latin_hypercube, 2, (std::uint64_t{1} << 48) + 1, 1); }),
      "a Latin hypercube has at most 2^48 points");
}

TEST(UnitPoints, DifferByDimensionSeedAndDesign) {
  std::set<double> seen;
  std::size_t count = 0;
  for (const Design design : designs)
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32})
      for (const double u : all_points(design, 6, 500, seed)) {
        seen.insert(u);
        ++count;
      }
  EXPECT_EQ(seen.size(), count) << "a coordinate came twice, of about 1e4 in 2^52";
}

// Random123's words by their documented counters: a seed has to give the same points for ever.
TEST(MonteCarlo, IsPhiloxOfPointAndDimension) {
  const std::uint64_t seed = 0x123456789ABCDEF0;
  const std::uint64_t first = (std::uint64_t{5} << 32) - 3;
  std::vector<double> coordinates(3 * 6);
  UnitPoints(Design::monte_carlo, 3, first + 6, seed).points(first, coordinates);
  for (std::uint64_t i = 0; i < 6; ++i)
    for (std::uint32_t d = 0; d < 3; ++d) {
      const std::uint64_t point = first + i;
      const auto words = r123::Philox4x32()(
          {{static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(point >> 32), d / 2, 0}},
          {{0x9ABCDEF0, 0x12345678}});
      const std::uint64_t word = words[d % 2 * 2] + (std::uint64_t{words[d % 2 * 2 + 1]} << 32);
      EXPECT_EQ(coordinates[i * 3 + d], sweep::unit_number(word)) << "point " << point;
    }
}

constexpr double improbable = 1e-5;  // of each tail; some hundred tests, all with fixed seeds

// Are the counts as even as by chance? freedom: degrees of freedom; 0: one fewer than counts.
void expect_as_likely(const std::vector<double>& counts, const char* what, double freedom = 0) {
  double sum = 0, squares = 0;
  for (const double count : counts) sum += count;
  const double mean = sum / static_cast<double>(counts.size());
  for (const double count : counts) squares += (count - mean) * (count - mean) / mean;
  if (freedom == 0) freedom = static_cast<double>(counts.size() - 1);
  const double tail = boost::math::gamma_q(freedom / 2, squares / 2);  // P(χ² > squares)
  EXPECT_GT(tail, improbable) << what << ": chi squared " << squares;
  EXPECT_LT(tail, 1 - improbable) << what << ": too even, chi squared " << squares;
}

// The numbers of the points pair(i) in the squares of a board of 30 by 30. It also expects that the
// two coordinates are not correlated.
template <class Pair>
std::vector<double> squares_of(std::size_t points, const Pair& pair) {
  std::vector<double> squares(30 * 30);
  double product = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const auto [one, other] = pair(i);
    ++squares[cell_of(one, 30) * 30 + cell_of(other, 30)];
    product += (one - 0.5) * (other - 0.5) * 12;
  }
  const auto count = static_cast<double>(points);
  EXPECT_TRUE(is_within(product / count, 0, 5 / std::sqrt(count)));
  return squares;
}

TEST(MonteCarlo, FillsTheCubeEvenlyAndWithoutCorrelation) {
  constexpr std::size_t dimensions = 5, points = 100000;
  const std::vector<double> u = all_points(Design::monte_carlo, dimensions, points, 7);
  const auto at = [&](std::size_t i, std::size_t d) { return u[i * dimensions + d]; };
  for (std::size_t d = 0; d < dimensions; ++d) {
    std::vector<double> counts(100);
    for (std::size_t i = 0; i < points; ++i) ++counts[cell_of(at(i, d), 100)];
    expect_as_likely(counts, "one dimension");
    for (std::size_t e = 0; e < d; ++e)
      expect_as_likely(
          squares_of(points, [&](std::size_t i) { return std::pair(at(i, d), at(i, e)); }),
          "two dimensions");
    expect_as_likely(
        squares_of(points / 2,
                   [&](std::size_t i) { return std::pair(at(2 * i, d), at(2 * i + 1, d)); }),
        "successive points");
  }
}

// Expects one of the first `cells` points in each of as many equal cells of coordinate d.
void expect_one_in_each_cell(const std::vector<double>& u, std::size_t dimensions, std::size_t d,
                             std::size_t cells) {
  std::vector<int> hits(cells);
  for (std::size_t i = 0; i < cells; ++i) ++hits[cell_of(u[i * dimensions + d], cells)];
  EXPECT_EQ(hits, std::vector<int>(cells, 1)) << cells << " points, dimension " << d;
}

TEST(LatinHypercube, HasOnePointInEachCellOfEachDimension) {
  for (const std::uint64_t points : {1, 2, 3, 4, 5, 7, 15, 16, 17, 99, 1000, 4095, 4099, 65536})
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
      const std::vector<double> u = all_points(Design::latin_hypercube, 3, points, seed);
      for (std::size_t d = 0; d < 3; ++d) expect_one_in_each_cell(u, 3, d, points);
    }
}

TEST(LatinHypercube, OfMorePointsThanCanBeCountedStaysInItsCells) {
  const std::uint64_t points = std::uint64_t{1} << 48;
  UnitPoints unit_points(Design::latin_hypercube, 2, points, 3);
  std::set<std::uint64_t> cells;
  std::vector<double> u(2 * 20000);
  unit_points.points(points - 20000, u);
  for (std::size_t i = 0; i < u.size(); i += 2) cells.insert(cell_of(u[i], points));
  EXPECT_EQ(cells.size(), 20000U);
}

TEST(LatinHypercube, PairsTheCellsOfTwoDimensionsAtRandom) {
  constexpr std::size_t points = 90000;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<double> u = all_points(Design::latin_hypercube, 4, points, seed);
    // Coordinate 0 here is the number of the point, which must not be related to its cells.
    const auto at = [&](std::size_t i, std::size_t d) {
      return d == 0 ? (static_cast<double>(i) + 0.5) / points : u[i * 4 + d - 1];
    };
    for (std::size_t d = 0; d <= 4; ++d)
      for (std::size_t e = 0; e < d; ++e)
        // Rows and columns are full: 29² degrees of freedom, not 30² − 1.
        expect_as_likely(
            squares_of(points, [&](std::size_t i) { return std::pair(at(i, d), at(i, e)); }),
            "two dimensions", 29 * 29);
  }
}

TEST(LatinHypercube, ComesToEachPermutationOfFewPointsAboutAsOften) {
  std::vector<double> counts(24);
  for (std::uint64_t seed = 0; seed < 24000; ++seed) {
    const std::vector<double> u = all_points(Design::latin_hypercube, 1, 4, seed);
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      std::size_t less = 0;
      for (std::size_t j = i + 1; j < 4; ++j) less += u[j] < u[i] ? 1 : 0;
      number = number * (4 - i) + less;
    }
    ++counts[number];
  }
  for (const double count : counts)
    EXPECT_TRUE(is_within(count, 1000, 300));  // the network is not ideal on four cells
}

TEST(LatinHypercube, PlacesAreEvenWithinTheCells) {
  constexpr std::size_t points = 50000;
  const std::vector<double> u = all_points(Design::latin_hypercube, 2, points, 9);
  std::vector<double> counts(100);
  for (const double coordinate : u) {
    const double place = coordinate * points - std::floor(coordinate * points);
    ++counts[static_cast<std::size_t>(place * 100)];
  }
  expect_as_likely(counts, "places");
}

TEST(Sobol, HasOnePointInEachIntervalOfOneDimension) {
  constexpr std::size_t dimensions = 20;
  const std::vector<double> u = all_points(Design::sobol, dimensions, 4096, 5);
  for (const std::size_t points : {1, 2, 4, 64, 1024, 4096})
    for (std::size_t d = 0; d < dimensions; ++d) expect_one_in_each_cell(u, dimensions, d, points);
}

// The first two dimensions are a (0, m, 2)-net.
TEST(Sobol, HasOnePointInEachElementaryIntervalOfTheFirstTwoDimensions) {
  for (const std::uint64_t seed : {1, 2}) {
    const std::vector<double> u = all_points(Design::sobol, 2, 4096, seed);
    for (const unsigned m : {1U, 3U, 8U, 12U})
      for (unsigned k = 0; k <= m; ++k) {
        const std::uint64_t columns = std::uint64_t{1} << k, rows = std::uint64_t{1} << (m - k);
        std::vector<int> hits(columns * rows);
        for (std::size_t i = 0; i < hits.size(); ++i)
          ++hits[cell_of(u[2 * i], columns) * rows + cell_of(u[2 * i + 1], rows)];
        EXPECT_EQ(hits, std::vector<int>(columns * rows, 1)) << columns << " by " << rows;
      }
  }
}

// Joe and Kuo's first points (new-joe-kuo-6.21201), which the shift moves by one pattern of bits.
TEST(Sobol, IsJoeAndKuosSequenceButForTheShift) {
  const std::vector<double> u = all_points(Design::sobol, 4, 8, 11);
  constexpr std::array<std::array<double, 4>, 8> expected{{{0, 0, 0, 0},
                                                           {0.5, 0.5, 0.5, 0.5},
                                                           {0.75, 0.25, 0.25, 0.25},
                                                           {0.25, 0.75, 0.75, 0.75},
                                                           {0.375, 0.375, 0.625, 0.875},
                                                           {0.875, 0.875, 0.125, 0.375},
                                                           {0.625, 0.125, 0.875, 0.625},
                                                           {0.125, 0.625, 0.375, 0.125}}};
  const auto bits = [](double x) { return static_cast<std::uint64_t>(x * 0x1p52); };
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t d = 0; d < 4; ++d)
      EXPECT_EQ(bits(u[i * 4 + d]) ^ bits(u[d]), bits(expected[i][d])) << i << ", " << d;
}

TEST(Sobol, IntegratesBetterThanMonteCarlo) {
  constexpr std::size_t dimensions = 6, points = 4096;
  const auto error = [&](Design design) {
    double squares = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const std::vector<double> u = all_points(design, dimensions, points, seed);
      double mean = 0;
      for (std::size_t i = 0; i < points; ++i) {
        double product = 1;
        for (std::size_t d = 0; d < dimensions; ++d)
          product *= 1 + 0.5 * (u[i * dimensions + d] - 0.5);
        mean += product / points;
      }
      squares += (mean - 1) * (mean - 1) / 20;
    }
    return std::sqrt(squares);
  };
  EXPECT_LT(error(Design::sobol), error(Design::monte_carlo) / 10);
  EXPECT_LT(error(Design::latin_hypercube), error(Design::monte_carlo) / 2);
}

}  // namespace
}  // namespace tribo::verification
