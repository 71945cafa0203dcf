// SPDX-License-Identifier: Apache-2.0
// Sobol indices of functions whose indices are known.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "support/judge.hpp"
#include "sweep/design.hpp"
#include "sweep/sensitivity.hpp"

namespace tribo::verification {
namespace {

using sweep::block_of;
using sweep::Bounded;
using sweep::Design;
using sweep::jackknife_blocks;
using sweep::SensitivityBlocks;
using sweep::SensitivitySums;
using sweep::SobolIndices;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Function = std::function<double(const std::vector<double>&)>;  // on the unit cube

// A takes the first half of the coordinates of a point in 2k dimensions, B the second.
SensitivityBlocks sums_of(const Function& f, std::size_t k, std::uint64_t groups, Design design,
                          std::uint64_t seed) {
  SensitivityBlocks blocks;
  sweep::UnitPoints points(design, 2 * k, groups, seed);
  std::vector<double> u(2 * k * groups);
  points.points(0, u);
  const double nominal = f(std::vector<double>(k, 0.5));
  for (std::uint64_t group = 0; group < groups; ++group) {
    const auto at = u.begin() + static_cast<std::ptrdiff_t>(2 * k * group);
    const auto half = at + static_cast<std::ptrdiff_t>(k);
    std::vector<double> a(at, half);
    const std::vector<double> b(half, half + static_cast<std::ptrdiff_t>(k));
    std::vector<double> values{f(a), f(b)};
    for (std::size_t i = 0; i < k; ++i) {
      const double kept = a[i];
      a[i] = b[i];
      values.push_back(f(a));
      a[i] = kept;
    }
    blocks[block_of(group, groups)].add(values, nominal);
  }
  return blocks;
}

struct Known {
  std::vector<double> first_order, total;
};

// sin x₁ + a sin² x₂ + b x₃⁴ sin x₁ for x in (−π, π)³ (Ishigami and Homma 1990), a = 7, b = 0.1.
double ishigami(const std::vector<double>& u) {
  const auto x = [&](std::size_t i) { return std::numbers::pi * (2 * u[i] - 1); };
  return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) +
         0.1 * std::pow(x(2), 4) * std::sin(x(0));
}
Known known_ishigami() {
  const double pi4 = std::pow(std::numbers::pi, 4), pi8 = pi4 * pi4;
  const double one = 0.5 * std::pow(1 + 0.1 * pi4 / 5, 2);
  const double two = 49.0 / 8;
  const double both = 0.01 * pi8 * 8 / 225;
  const double variance = one + two + both;
  return {{one / variance, two / variance, 0},
          {(one + both) / variance, two / variance, both / variance}};
}

constexpr std::array weights{4.0, -2.0, 1.0, 0.5, 0.0};
double linear(const std::vector<double>& u) {
  double sum = 100;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * u[i];
  return sum;
}
Known known_linear() {
  double squares = 0;
  for (const double weight : weights) squares += weight * weight;
  Known known;
  for (const double weight : weights) known.first_order.push_back(weight * weight / squares);
  known.total = known.first_order;
  return known;
}

void expect_known(const SobolIndices& got, const Known& known, double tolerance) {
  for (std::size_t i = 0; i < known.total.size(); ++i) {
    EXPECT_TRUE(is_within(got.first_order[i].value, known.first_order[i], tolerance)) << i;
    EXPECT_TRUE(is_within(got.total[i].value, known.total[i], tolerance)) << i;
  }
}

TEST(SobolIndices, AreThoseOfIshigamisFunction) {
  const SobolIndices got =
      sobol_indices(sums_of(ishigami, 3, std::uint64_t{1} << 15, Design::sobol, 1));
  EXPECT_EQ(got.groups, std::uint64_t{1} << 15);
  expect_known(got, known_ishigami(), 0.001);
}

TEST(SobolIndices, AreThoseOfASum) {
  const SobolIndices got =
      sobol_indices(sums_of(linear, 5, std::uint64_t{1} << 14, Design::sobol, 2));
  expect_known(got, known_linear(), 1e-4);
  EXPECT_EQ(got.first_order[4].value, 0) << "a variable on which nothing depends";
  EXPECT_EQ(got.total[4].value, 0);
}

// The indices by their definitions, from the values of all groups: means over groups, the variance
// of a sample, and intervals of 1.96 standard errors by the jackknife, which leaves out one block
// at a time. The intervals hold in 94.1 of 100 sweeps.
TEST(SobolIndices, AreTheirDefinitionsAndTheirIntervalsTheJackknifes) {
  constexpr std::size_t k = 3, groups = 333;
  Sampler sampler(8);
  std::vector<std::vector<double>> values(groups);
  SensitivityBlocks blocks;
  constexpr double nominal = 0.3;
  for (std::size_t g = 0; g < groups; ++g) {
    for (std::size_t i = 0; i < k + 2; ++i) values[g].push_back(sampler.uniform(0, 1) - 0.2);
    blocks[block_of(g, groups)].add(values[g], nominal);
  }
  // S and T of variable i, from all blocks but one.
  const auto index = [&](std::size_t i, std::size_t without) {
    double sum = 0, first = 0, total = 0, squares = 0, n = 0;
    for (const bool second : {false, true})
      for (std::size_t g = 0; g < groups; ++g) {
        if (block_of(g, groups) == without) continue;
        const double a = values[g][0], b = values[g][1], mixed = values[g][2 + i];
        if (!second) {
          sum += a + b;
          ++n;
          continue;
        }
        squares += std::pow(a - sum / (2 * n), 2) + std::pow(b - sum / (2 * n), 2);
        first += (b - nominal) * (mixed - a) / n;
        total += (a - mixed) * (a - mixed) / (2 * n);
      }
    const double variance = squares / (2 * n - 1);
    return std::array{first / variance, total / variance};
  };
  const SobolIndices got = sobol_indices(blocks);
  for (std::size_t i = 0; i < k; ++i)
    for (const std::size_t kind : {0U, 1U}) {
      double mean = 0, squares = 0;
      for (std::size_t b = 0; b < jackknife_blocks; ++b)
        mean += index(i, b)[kind] / jackknife_blocks;
      for (std::size_t b = 0; b < jackknife_blocks; ++b)
        squares += std::pow(index(i, b)[kind] - mean, 2);
      const double reach = 1.96 * std::sqrt(squares * (jackknife_blocks - 1) / jackknife_blocks);
      const double value = index(i, jackknife_blocks)[kind];
      const Bounded& one = kind == 0 ? got.first_order[i] : got.total[i];
      EXPECT_TRUE(is_within(one.value, value, 1e-12));
      EXPECT_TRUE(is_within(one.low, value - reach, 1e-12));
      EXPECT_TRUE(is_within(one.high, value + reach, 1e-12));
    }
}

TEST(SobolIndices, DoNotDependOnUnitAndOrigin) {
  const auto indices = [](const Function& f) {
    return sobol_indices(sums_of(f, 3, 3000, Design::latin_hypercube, 3));
  };
  const SobolIndices expected = indices(ishigami);
  const auto expect_equal = [&](const SobolIndices& got, double tolerance, const char* what) {
    for (std::size_t i = 0; i < 3; ++i)
      for (double Bounded::*const part : {&Bounded::value, &Bounded::low, &Bounded::high}) {
        EXPECT_TRUE(is_within(got.first_order[i].*part, expected.first_order[i].*part, tolerance))
            << what;
        EXPECT_TRUE(is_within(got.total[i].*part, expected.total[i].*part, tolerance)) << what;
      }
  };
  expect_equal(indices([](const auto& u) { return 1e-9 * ishigami(u); }), 1e-13, "smaller");
  expect_equal(indices([](const auto& u) { return -3e7 * ishigami(u); }), 1e-13, "upside down");
  expect_equal(indices([](const auto& u) { return 1e6 + ishigami(u); }), 1e-9, "far from zero");
}

TEST(SobolIndices, OfWhatDoesNotVaryAreNoNumbers) {
  const SobolIndices got =
      sobol_indices(sums_of([](const auto&) { return 0.1; }, 2, 1000, Design::sobol, 4));
  ASSERT_EQ(got.total.size(), 2U);
  EXPECT_EQ(got.groups, 1000U);
  for (const auto& indices : {got.first_order, got.total})
    for (const Bounded& index : indices)
      for (const double part : {index.value, index.low, index.high})
        EXPECT_EQ(std::isnan(part), true) << part;
}

TEST(SobolIndices, OfWhatVariesByItsRoundingAloneAreNoNumbers) {
  const auto index_of = [](double step) {
    const SobolIndices got = sobol_indices(sums_of(
        [step](const auto& u) { return 3 + (u[0] < 0.5 ? step : 0); }, 2, 1000, Design::sobol, 4));
    return got.total[0].value;
  };
  const double ulp = 3 * std::numeric_limits<double>::epsilon();
  EXPECT_TRUE(std::isnan(index_of(ulp)));
  EXPECT_TRUE(std::isnan(index_of(8 * ulp)));
  EXPECT_TRUE(is_within(index_of(1e6 * ulp), 1, 0.1));
}

TEST(SobolIndices, LeaveOutGroupsWithAnUndefinedValue) {
  SensitivitySums with, without;
  Sampler sampler(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<double> values(5);
    for (double& value : values) value = sampler.uniform(0, 1);
    with.add(values, 0.5);
    without.add(values, 0.5);
    values[static_cast<std::size_t>(i % 5)] = i % 2 == 0 ? nan : -1 / 0.0;
    with.add(values, 0.5);
  }
  EXPECT_EQ(with.left_out, 300U);
  EXPECT_EQ(with.both.count, 600U);
  EXPECT_EQ(with.first_order, without.first_order);
  EXPECT_EQ(with.total, without.total);
  EXPECT_EQ(with.both.squares, without.both.squares);

  SensitivityBlocks none;
  none[3].add(std::vector<double>{nan, 1, 2, 3}, 0);
  const SobolIndices got = sobol_indices(none);
  EXPECT_EQ(got.groups, 0U);
  ASSERT_EQ(got.total.size(), 2U);
  EXPECT_EQ(std::isnan(got.total[0].value), true);
  EXPECT_EQ(sobol_indices(SensitivityBlocks{}).total.size(), 0U);
}

TEST(SobolIndices, AreNoneWhereMoreThanAFewGroupsHaveNoValue) {
  constexpr std::uint64_t groups = 3000;
  // The sums of a result that is undefined in this part of the groups.
  const auto indices_with = [&](double undefined) {
    Sampler sampler(8);
    SensitivityBlocks blocks;
    for (std::uint64_t group = 0; group < groups; ++group) {
      std::vector<double> values(4);
      for (double& value : values) value = sampler.uniform(0, 1);
      if (static_cast<double>(group) < undefined * static_cast<double>(groups)) values[3] = nan;
      blocks[block_of(group, groups)].add(values, 0.5);
    }
    return sobol_indices(blocks);
  };
  for (const double few : {0.0, 0.001, 0.01}) {
    const SobolIndices got = indices_with(few);
    EXPECT_EQ(static_cast<double>(got.groups), (1 - few) * groups);
    for (const auto* const list : {&got.first_order, &got.total})
      for (const sweep::Bounded& index : *list) EXPECT_TRUE(index.low < index.high) << few;
  }
  for (const double many : {0.011, 0.3, 1.0}) {
    const SobolIndices got = indices_with(many);
    EXPECT_EQ(static_cast<double>(got.groups), std::round((1 - many) * groups));
    ASSERT_EQ(got.total.size(), 2U);
    for (const auto* const list : {&got.first_order, &got.total})
      for (const sweep::Bounded& index : *list)
        for (const double number : {index.value, index.low, index.high})
          EXPECT_EQ(std::isnan(number), true) << many;
  }
}

TEST(SobolIndices, OfOneBlockHaveNoInterval) {
  SensitivityBlocks blocks;
  blocks[0] = sums_of(linear, 5, 32, Design::monte_carlo, 1)[0];
  for (int i = 0; i < 4; ++i)
    blocks[0].add(std::vector<double>{1.0 * i, 2.0, 3.0 * i, 1, 1, 1, 1}, nan);
  const SobolIndices got = sobol_indices(blocks);
  EXPECT_EQ(std::isfinite(got.total[0].value), true);
  EXPECT_EQ(std::isnan(got.total[0].low), true);
  EXPECT_EQ(std::isnan(got.total[0].high), true);
}

TEST(SensitivitySums, MergedAreThoseOfAllGroups) {
  SensitivitySums at_once, merged, part;
  Sampler sampler(6);
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> values(6);
    for (double& value : values) value = sampler.uniform(9, 10);
    at_once.add(values, 9.5);
    part.add(values, 9.5);
    if (i % 70 == 0 || i == 999) {
      merged.merge(part);
      part = {};
    }
  }
  merged.merge(part);
  EXPECT_EQ(merged.both.count, at_once.both.count);
  EXPECT_TRUE(is_within(merged.both.squares, at_once.both.squares, 1e-10));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(is_within(merged.first_order[i], at_once.first_order[i], 1e-11));
    EXPECT_TRUE(is_within(merged.total[i], at_once.total[i], 1e-11));
  }
}

TEST(SensitivitySums, AreReadAsTheyWereWritten) {
  const SensitivitySums sums = sums_of(ishigami, 3, 100, Design::monte_carlo, 7)[1];
  sweep::Bytes bytes;
  sums.write(bytes);
  sweep::Receiver receiver(bytes);
  const SensitivitySums read = SensitivitySums::read(receiver);
  EXPECT_EQ(receiver.empty(), true);
  EXPECT_EQ(read.first_order, sums.first_order);
  EXPECT_EQ(read.total, sums.total);
  EXPECT_EQ(read.both.squares, sums.both.squares);
}

TEST(JackknifeBlocks, DifferByOneGroupAtMostAndFollowEachOther) {
  for (const std::uint64_t groups : {1, 5, 31, 32, 33, 63, 64, 1000, 4099}) {
    std::array<std::uint64_t, jackknife_blocks> sizes{};
    std::size_t previous = 0;
    for (std::uint64_t group = 0; group < groups; ++group) {
      const std::size_t block = block_of(group, groups);
      ASSERT_LT(block, jackknife_blocks);
      EXPECT_GE(block, previous);
      previous = block;
      ++sizes[block];
    }
    for (const std::uint64_t size : sizes) {
      EXPECT_GE(size, groups / jackknife_blocks);
      EXPECT_LE(size, (groups + jackknife_blocks - 1) / jackknife_blocks);
    }
  }
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(block_of(most - 1, most), jackknife_blocks - 1);
}

}  // namespace
}  // namespace tribo::verification
