// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/judge.hpp"
#include "sweep/correlation.hpp"
#include "sweep/design.hpp"
#include "sweep/summary.hpp"

namespace tribo::verification {
namespace {

using sweep::Bounded;
using sweep::Moments;
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

// Normally distributed values with this mean and sd.
std::vector<double> normals(std::size_t count, double mean, double sd, std::uint64_t seed) {
  std::mt19937_64 words(seed);
  std::vector<double> values(count);
  for (double& value : values) value = sweep::unit_number(words());
  sweep::standard_normals(values);
  for (double& value : values) value = mean + sd * value;
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
  // The error of the sd grows with the ratio of the mean to the sd.
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

TEST(Quantiles, OfNothingAreNoNumbersAndOfOneValueItself) {
  EXPECT_EQ(std::isnan(quantile_of(ValueSummary(), 0.5).value), true);
  EXPECT_EQ(std::isnan(quantile_of(ValueSummary(), 0.5).low), true);
  const Bounded one = quantile_of(summary_of({0.3}), 0.5);
  EXPECT_EQ(one.value, 0.3);
  EXPECT_EQ(one.low, -infinity);
  EXPECT_EQ(one.high, infinity);
  const Bounded equal = quantile_of(summary_of(std::vector<double>(100, 0.3)), 0.5);
  EXPECT_EQ(equal.low, 0.3);
  EXPECT_EQ(equal.value, 0.3);
  EXPECT_EQ(equal.high, 0.3);
}

// A sample in which a value determines its rank: each value is alone in a bin of the sketch.
constexpr std::int32_t bins_apart = 3;
ValueSummary ranked(std::size_t n) {
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i)
    values[i] = QuantileSketch::edge(bins_apart * static_cast<std::int32_t>(i + 1));
  return summary_of(values);
}
// The rank of a value or an interval's end; 1 for the least value, 0 at −∞, n + 1 at ∞.
double rank_in(std::size_t n, double value) {
  if (std::isinf(value)) return value < 0 ? 0 : static_cast<double>(n + 1);
  return std::round(static_cast<double>(QuantileSketch::bin_of(value)) / bins_apart);
}

// Against the binomial distribution: the value of rank l is above the quantile if at most l − 1
// values are below the quantile, and the value of rank h is below it if at least h values are. For
// many values the bounds come from an expansion. Few of them differ from these ranks, by one.
TEST(Quantiles, IntervalsHaveTheRanksOfTheBinomialDistribution) {
  int asked = 0, other = 0;
  double sum_of_others = 0;
  for (const std::size_t n : {10, 100, 1000, 1600, 1783, 3000, 5000, 17011, 60001}) {
    const ValueSummary summary = ranked(n);
    std::vector<double> parts{0.001, 0.025, 0.84, 0.99, 0.999};
    for (int i = 1; i < 40; ++i) parts.push_back(i / 40.0);
    for (const double p : parts) {
      const auto count = static_cast<double>(n);
      const boost::math::binomial_distribution<double> below(count, p);
      const auto least_with = [&](double part) {  // k with P(K ≤ k) ≥ part
        double k = std::max(0.0, std::floor(count * p - 6 * std::sqrt(count * p * (1 - p)) - 6));
        while (cdf(below, k) < part) ++k;
        return k;
      };
      const Bounded quantile = quantile_of(summary, p);
      const auto inputs = describe({{"n", count}, {"p", p}});
      EXPECT_EQ(rank_in(n, quantile.value), std::ceil(count * p)) << inputs;
      const double low = rank_in(n, quantile.low) - least_with(0.025);
      const double high = rank_in(n, quantile.high) - (least_with(0.975) + 1);
      if (count * p * (1 - p) < 400) {
        EXPECT_EQ(low, 0) << inputs;
        EXPECT_EQ(high, 0) << inputs;
        continue;
      }
      for (const double off : {low, high}) {
        EXPECT_LE(std::abs(off), 1) << inputs;
        ++asked;
        other += off != 0 ? 1 : 0;
        sum_of_others += off;
      }
    }
  }
  // The expansion is off by up to 1/50 of a rank, so that about one bound in 50 differs. If it were
  // off by half a rank, every second bound would differ.
  EXPECT_GT(asked, 300);
  EXPECT_LE(other, asked / 25);
  EXPECT_LE(std::abs(sum_of_others), asked / 25);
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
