// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "support/judge.hpp"
#include "sweep/correlation.hpp"
#include "sweep/design.hpp"
#include "sweep/summary.hpp"

namespace tribo::verification {
namespace {

using sweep::Moments;
using sweep::Quantile;
using sweep::quantile_of;
using sweep::QuantileSketch;
using sweep::ValueSummary;

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Mean and sum of squares in two passes.
struct TwoPass {
  long double mean = 0, squares = 0;
  explicit TwoPass(const std::vector<double>& values) {
    for (const double value : values) mean += value;
    mean /= static_cast<long double>(values.size());
    for (const double value : values) squares += (value - mean) * (value - mean);
  }
};

// Normal values of this mean and sd.
std::vector<double> normals(std::size_t count, double mean, double sd, std::uint64_t seed) {
  std::mt19937_64 words(seed);
  std::vector<double> values(count);
  for (double& value : values)
    value = mean + sd * sweep::standard_normal(sweep::unit_number(words()));
  return values;
}

void expect_moments(const Moments& got, const std::vector<double>& values, const char* how) {
  const TwoPass expected(values);
  EXPECT_EQ(got.count, values.size());
  EXPECT_EQ(got.least, *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(got.greatest, *std::max_element(values.begin(), values.end()));
  const auto sd = static_cast<double>(
      std::sqrt(expected.squares / static_cast<long double>(values.size() - 1)));
  const auto mean = static_cast<double>(expected.mean);
  // A mean that is much greater than the sd takes as many of its digits as it has more.
  EXPECT_TRUE(is_within(got.mean, mean, ulp * (std::abs(mean) + sd))) << how;
  EXPECT_TRUE(is_within(got.sd(), sd, ulp * (std::abs(mean) + sd))) << how;
}

TEST(Moments, AreThoseOfTwoPassesHoweverTheValuesAreSplit) {
  std::mt19937_64 words(1);
  for (const double mean : {0.0, 1.0, -1e3, 1e6, 1e9}) {
    const std::vector<double> values = normals(10000, mean, 1, 2);
    Moments at_once;
    at_once.add(values);
    expect_moments(at_once, values, "at once");
    for (int i = 0; i < 20; ++i) {
      Moments merged;
      for (std::size_t at = 0; at < values.size();) {
        const std::size_t end = std::min<std::size_t>(at + words() % 3000, values.size());
        Moments part;
        part.add(std::span(values).subspan(at, end - at));
        at = end;
        merged.merge(part);
      }
      expect_moments(merged, values, "in parts");
    }
  }
}

TEST(Moments, OfEqualValuesAreExact) {
  for (const double value : {0.1, -7e-9, 1e300, 0.0}) {
    Moments part, whole;
    part.add(std::vector(1000, value));
    for (int i = 0; i < 7; ++i) whole.merge(part);
    EXPECT_EQ(whole.mean, value);
    EXPECT_EQ(whole.sd(), 0);
    EXPECT_EQ(whole.count, 7000U);
  }
}

TEST(Moments, OfFewerThanTwoValuesHaveNoSd) {
  Moments moments;
  EXPECT_EQ(std::isnan(moments.sd()), true);
  moments.add(std::vector{3.0});
  EXPECT_EQ(std::isnan(moments.sd()), true);
  EXPECT_EQ(moments.mean, 3);
  moments.add(std::vector{5.0});
  EXPECT_EQ(moments.sd(), std::sqrt(2.0));
}

ValueSummary summary_of(const std::vector<double>& values) {
  ValueSummary summary;
  summary.add(values);
  return summary;
}

TEST(ValueSummary, LeavesOutWhatIsUndefined) {
  ValueSummary summary = summary_of({1, nan, 2, infinity, -infinity, 3, -nan});
  EXPECT_EQ(summary.undefined, 4U);
  EXPECT_EQ(summary.moments.count, 3U);
  EXPECT_EQ(summary.moments.mean, 2);
  EXPECT_EQ(summary.moments.greatest, 3);
  EXPECT_EQ(summary.sketch.count(), 3U);
  summary.merge(summary_of({nan, 4}));
  EXPECT_EQ(summary.undefined, 5U);
  EXPECT_EQ(summary.sketch.count(), 4U);
}

sweep::Bytes bytes_of(const ValueSummary& summary) {
  sweep::Bytes bytes;
  summary.write(bytes);
  return bytes;
}

TEST(ValueSummary, IsReadAsItWasWrittenAndRefusedIfCutOrOfTwoCounts) {
  std::vector<double> values = normals(500, 1e-7, 3e-8, 3);
  values.push_back(nan);
  const ValueSummary summary = summary_of(values);
  sweep::Bytes bytes = bytes_of(summary);
  sweep::ByteReader reader(bytes);
  const ValueSummary read = ValueSummary::read(reader);
  EXPECT_EQ(bytes_of(read), bytes);
  EXPECT_EQ(read.undefined, 1U);
  EXPECT_EQ(read.moments.mean, summary.moments.mean);
  EXPECT_EQ(read.moments.squares, summary.moments.squares);

  const auto is_refused = [](const sweep::Bytes& some) {
    sweep::ByteReader from(some);
    try {
      ValueSummary::read(from);
      return false;
    } catch (const std::runtime_error&) {
      return true;
    }
  };
  sweep::Bytes of_two_counts = bytes;
  of_two_counts.front() ^= std::byte{1};
  EXPECT_EQ(is_refused(of_two_counts), true);
  while (!bytes.empty()) {
    bytes.pop_back();
    EXPECT_EQ(is_refused(bytes), true) << bytes.size();
  }
}

TEST(Quantiles, OfNothingAreNoNumbersAndOfOneValueItself) {
  EXPECT_EQ(std::isnan(quantile_of(ValueSummary(), 0.5).value), true);
  EXPECT_EQ(std::isnan(quantile_of(ValueSummary(), 0.5).low), true);
  const Quantile one = quantile_of(summary_of({0.3}), 0.5);
  EXPECT_EQ(one.value, 0.3);
  EXPECT_EQ(one.low, -infinity);
  EXPECT_EQ(one.high, infinity);
  const Quantile equal = quantile_of(summary_of(std::vector<double>(100, 0.3)), 0.5);
  EXPECT_EQ(equal.low, 0.3);
  EXPECT_EQ(equal.value, 0.3);
  EXPECT_EQ(equal.high, 0.3);
}

// The ranks in a sample of 0, 1 … n − 1, whose values tell their ranks (to the sketch's error),
// against the distribution function of the binomial.
TEST(Quantiles, IntervalsHaveTheRanksOfTheBinomialDistribution) {
  for (const std::size_t n : {10, 100, 1000, 5000}) {
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<double>(i);
    const ValueSummary summary = summary_of(values);
    for (const double p : {0.001, 0.025, 0.25, 0.5, 0.84, 0.99, 0.999}) {
      const boost::math::binomial_distribution<double> below(static_cast<double>(n), p);
      const Quantile quantile = quantile_of(summary, p);
      // Rank r (from 0) is at or below the quantile if more than r values are.
      const auto part_above = [&](double rank) { return cdf(below, rank); };
      double low = 0, high = static_cast<double>(n) - 1;
      while (low + 1 < static_cast<double>(n) && part_above(low + 1) <= 0.025) ++low;
      while (high >= 1 && part_above(high - 1) >= 0.975) --high;
      const auto inputs = describe({{"n", static_cast<double>(n)}, {"p", p}});
      const double error = 2 * QuantileSketch::relative_error;
      if (part_above(0) > 0.025) {
        EXPECT_EQ(quantile.low, -infinity) << inputs;
      } else {
        // and at most one rank wider
        EXPECT_LE(quantile.low, low) << inputs;
        EXPECT_GE(quantile.low, (low - 1) * (1 - error)) << inputs;
      }
      if (part_above(static_cast<double>(n) - 1) < 0.975) {
        EXPECT_EQ(quantile.high, infinity) << inputs;
      } else {
        EXPECT_GE(quantile.high, high) << inputs;
        EXPECT_LE(quantile.high, (high + 1) * (1 + error)) << inputs;
      }
      EXPECT_TRUE(is_within(quantile.value, std::ceil(static_cast<double>(n) * p) - 1,
                            QuantileSketch::relative_error * static_cast<double>(n) * p))
          << inputs;
    }
  }
}

// Not for fewer values: the steps between ranks, and with them more than 95 of 100, become large.
TEST(Quantiles, IntervalsHoldTheDistributionsQuantileIn95Of100Sweeps) {
  constexpr int sweeps = 1000;
  constexpr std::array levels{0.1, 0.25, 0.5, 0.9};
  for (const std::size_t n : {1000, 2000}) {
    std::array<int, levels.size()> held{};
    for (std::uint64_t i = 0; i < sweeps; ++i) {
      ValueSummary summary;
      std::vector<double> values = normals(n, 0, 1, i);
      for (double& value : values) value = std::exp(0.5 * value);
      summary.add(values);
      for (std::size_t k = 0; k < levels.size(); ++k) {
        const double exact = std::exp(0.5 * sweep::standard_normal(levels[k]));
        const Quantile quantile = quantile_of(summary, levels[k]);
        EXPECT_LE(quantile.low, quantile.value);
        EXPECT_LE(quantile.value, quantile.high);
        if (quantile.low <= exact && exact <= quantile.high) ++held[k];
      }
    }
    for (std::size_t k = 0; k < levels.size(); ++k)
      EXPECT_TRUE(is_within(held[k], 0.95 * sweeps, 0.02 * sweeps))
          << describe({{"p", levels[k]}, {"n", static_cast<double>(n)}});
  }
}

TEST(Histogram, CountsAddUpAndBinsHaveNoGaps) {
  Sampler sampler(5);
  std::vector<std::vector<double>> samples{{1}, {-1, 1}, {0, 0}, {-1e300, 1e-300, 1e300}};
  samples.push_back(normals(5000, 0, 1, 6));
  samples.push_back(normals(5000, 1e-7, 1e-9, 7));
  samples.push_back(normals(5000, -50, 10, 8));
  for (std::vector<double>& values : samples) {
    const ValueSummary summary = summary_of(values);
    for (const std::size_t most : {1, 2, 7, 100, 1000}) {
      const auto histogram = sweep::histogram_of(summary.sketch, most);
      EXPECT_LE(histogram.size(), most);
      EXPECT_LE(histogram.front().low, summary.moments.least);
      EXPECT_GE(histogram.back().high, summary.moments.greatest);
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < histogram.size(); ++i) {
        if (i > 0) {
          EXPECT_EQ(histogram[i].low, histogram[i - 1].high);
        }
        const auto below = [&](double edge) {
          return std::count_if(values.begin(), values.end(), [&](double value) {
            return value < edge || (value == edge && value < 0);
          });
        };
        if (std::abs(histogram[i].high) < 1e308 && std::abs(histogram[i].low) < 1e308) {
          EXPECT_EQ(static_cast<std::int64_t>(histogram[i].count),
                    below(histogram[i].high) - below(histogram[i].low));
        }
        sum += histogram[i].count;
      }
      EXPECT_EQ(sum, values.size());
    }
  }
  EXPECT_EQ(sweep::histogram_of(QuantileSketch(), 10).size(), 0U);
}

}  // namespace
}  // namespace tribo::verification
