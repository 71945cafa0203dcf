// SPDX-License-Identifier: Apache-2.0
// Quantiles against the distribution functions in 50 digits. The error of a value is the function
// there minus u, over the slope of the function.
#include "sweep/distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "support/judge.hpp"
#include "sweep/design.hpp"
#include "sweep/small_sweep.hpp"

namespace tribo::verification {
namespace {

using sweep::Distribution;
using sweep::least_unit_number;
using sweep::unit_number;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ulp = std::numeric_limits<double>::epsilon();

Reference part_above(const Reference& z) {
  return boost::math::erfc(Reference(z / sqrt(Reference(2)))) / 2;
}
Reference density(const Reference& z) {
  return exp(Reference(-z * z / 2)) / sqrt(2 * boost::math::constants::pi<Reference>());
}

// The error of z as the quantile of u of a standard normal truncated at the given bounds, by parts
// above a number where `from` is above 0, else by parts below. one_minus_u is as exact as u.
Reference miss(const Reference& z, const Reference& u, const Reference& one_minus_u,
               const std::optional<Reference>& from, const std::optional<Reference>& to) {
  const bool mirrored = from && *from > 0;
  const Reference sign = mirrored ? -1 : 1;  // −1: parts are those above a number
  const auto part = [&](const std::optional<Reference>& bound, int beyond) {
    return bound ? part_above(Reference(-sign * *bound)) : Reference(beyond);
  };
  const Reference low = mirrored ? part(to, 0) : part(from, 0);
  const Reference high = mirrored ? part(from, 1) : part(to, 1);
  const Reference wanted = low + (mirrored ? one_minus_u : u) * (high - low);
  return Reference(sign * (part_above(Reference(-sign * z)) - wanted)) / density(z);
}

double quantile_of_normal(const Distribution& d, double z) {
  double value = 0;
  d.quantiles_of_normals({&z, 1}, {&value, 1}, 1);
  return value;
}

std::vector<double> unit_numbers(std::uint64_t seed, int count) {
  std::mt19937_64 words(seed);
  std::vector<double> numbers{
      least_unit_number,       3 * least_unit_number,     0.5 - least_unit_number, 0.5,
      0.5 + least_unit_number, 1 - 3 * least_unit_number, 1 - least_unit_number};
  for (int i = 0; i < count; ++i) {
    const double even = unit_number(words());
    const double small = unit_number(words() >> (words() % 52));
    numbers.insert(numbers.end(), {even, small, 1 - small});
  }
  return numbers;
}

TEST(Uniform, QuantilesAreExactToOneAndAHalfUlp) {
  Sampler sampler(1);
  for (int i = 0; i < 40; ++i) {
    const double from = sampler.pick({1, -1}) * sampler.log_uniform(1e-12, 1e12);
    const double to = from + std::abs(from) * sampler.log_uniform(1e-6, 1e6);
    const auto d = Distribution::uniform(from, to);
    for (const double u : unit_numbers(static_cast<std::uint64_t>(i), 20)) {
      const Reference expected = from + Reference(u) * (Reference(to) - from);
      const double scale = std::max(std::abs(from), std::abs(to));
      EXPECT_TRUE(is_within(static_cast<double>(d.quantile(u) - expected), 0, 1.5 * ulp * scale))
          << describe({{"from", from}, {"to", to}, {"u", u}});
    }
  }
}

TEST(LogUniform, QuantilesAreExactToThreeUlp) {
  Sampler sampler(2);
  for (int i = 0; i < 40; ++i) {
    const double from = sampler.log_uniform(1e-30, 1e10);
    const double to = from * sampler.log_uniform(1.001, 1e30);
    const auto d = Distribution::log_uniform(from, to);
    for (const double u : unit_numbers(static_cast<std::uint64_t>(i), 10)) {
      const Reference expected = from * exp(Reference(u * log(Reference(to) / from)));
      EXPECT_TRUE(
          is_close(d.quantile(u), expected, 3 * ulp, {{"from", from}, {"to", to}, {"u", u}}));
    }
  }
}

struct NormalCase {
  double mean, sd, from, to;
};
const std::vector<NormalCase> normal_cases{
    {0, 1, -infinity, infinity},
    {0.0202, 0.001, -infinity, infinity},
    {0.0202, 0.001, 0.01, 0.04},
    {0, 1, -1, 2},
    {0, 1, 0.1, 0.1001},
    {0, 1, 10, infinity},
    {0, 1, 10, 10.5},
    {0, 1, 30, 31},
    {0, 1, 35, infinity},
    {0, 1, -infinity, -10},
    {0, 1, -31, -30},
    {0, 1, 4, 1e6},
    {5, 2, 5, infinity},
    {5, 2, -infinity, 5},
    {1e6, 1, 1e6 + 3, 1e6 + 3.25},
    {-3, 0.5, -3.1, 40},
    {0, 1, -40, 40},
    {0, 1e-9, 1e-10, infinity},
};

// Expects x to be the quantile of u. For the value at a standard normal z, u is P(Z < z).
void expect_normal(const NormalCase& c, double x, const Reference& u,
                   const Reference& one_minus_u) {
  const auto standard = [&](double bound) { return Reference((Reference(bound) - c.mean) / c.sd); };
  const auto bound = [&](double of) {
    return std::isfinite(of) ? std::optional(standard(of)) : std::nullopt;
  };
  const Reference error = c.sd * miss(standard(x), u, one_minus_u, bound(c.from), bound(c.to));
  const double scale = std::max({std::abs(x), std::abs(c.mean), c.sd});
  EXPECT_TRUE(is_within(static_cast<double>(error), 0, 4 * ulp * scale))
      << describe({{"mean", c.mean},
                   {"sd", c.sd},
                   {"from", c.from},
                   {"to", c.to},
                   {"u", static_cast<double>(u)},
                   {"x", x}});
}

TEST(Normal, QuantilesAreExactToFourUlpOfValueMeanAndSd) {
  for (const NormalCase& c : normal_cases) {
    const auto d = Distribution::normal(c.mean, c.sd, c.from, c.to);
    for (const double u : unit_numbers(3, 12)) expect_normal(c, d.quantile(u), u, 1 - Reference(u));
  }
}

TEST(Normal, TakesAStandardNormalInPlaceOfU) {
  for (const NormalCase& c : normal_cases) {
    const auto d = Distribution::normal(c.mean, c.sd, c.from, c.to);
    for (const double z : {-8.2, -5.0, -1.5, -0.3, 0.0, 1e-9, 0.7, 2.5, 6.0, 8.2})
      expect_normal(c, quantile_of_normal(d, z), part_above(-z), part_above(z));
  }
}

TEST(LogNormal, QuantilesAreExactToAFewUlpOfTheLogarithm) {
  struct Case {
    double median, log_sd, from, to;
  };
  for (const Case& c :
       {Case{1e-8, 0.3, 0, infinity}, Case{2e-8, 0.1, 1.5e-8, 3e-8}, Case{1e11, 2, 1e10, infinity},
        Case{1, 1, 1e5, 1e6}, Case{3, 0.01, 0, 2.9}, Case{3e-300, 0.5, 1e-300, 1e-299}}) {
    const auto d = Distribution::log_normal(c.median, c.log_sd, c.from, c.to);
    const auto standard = [&](double x) {
      return Reference(log(Reference(Reference(x) / c.median)) / c.log_sd);
    };
    const auto bound = [&](double of) {
      return of > 0 && of < infinity ? std::optional(standard(of)) : std::nullopt;
    };
    for (const double u : unit_numbers(4, 12)) {
      const double x = d.quantile(u);
      const Reference error =
          c.log_sd * miss(standard(x), u, 1 - Reference(u), bound(c.from), bound(c.to));
      const double allowed = ulp * (3 + 3 * std::abs(std::log(x / c.median)) + 3 * c.log_sd);
      EXPECT_TRUE(is_within(static_cast<double>(error), 0, allowed))
          << d.text() << describe({{"u", u}, {"x", x}});
    }
  }
}

TEST(UniformOnes, TakeAStandardNormalInPlaceOfU) {
  const auto flat = Distribution::uniform(-2, 5);
  const auto even = Distribution::log_uniform(1e-9, 1e-3);
  for (const double z : {-8.2, -5.0, -1.5, -0.3, 0.0, 0.7, 2.5, 6.0, 8.2}) {
    const Reference u = part_above(-z);
    EXPECT_TRUE(
        is_within(static_cast<double>(quantile_of_normal(flat, z) - (-2 + 7 * u)), 0, 8 * ulp * 5))
        << describe({{"z", z}});
    EXPECT_TRUE(is_close(quantile_of_normal(even, z),
                         Reference(1e-9) * exp(Reference(u * log(Reference(1e-3) / 1e-9))),
                         16 * ulp, {{"z", z}}));
  }
}

Distribution random_distribution(Sampler& sampler) {
  const double centre = sampler.log_uniform(1e-12, 1e12);
  const double sd = sampler.log_uniform(1e-4, 10);
  const double reach = sampler.uniform(-35, 34);
  const double width = sampler.log_uniform(1e-12, 70);
  switch (sampler.pick({0, 1, 2, 3})) {
    case 0:
      return Distribution::uniform(-centre, centre * sd);
    case 1:
      return Distribution::log_uniform(centre, centre * (1 + sd));
    case 2: {
      const double from = centre * (1 + sd * reach);
      return Distribution::normal(
          centre, centre * sd, from,
          std::max(from + centre * sd * width, std::nextafter(from, infinity)));
    }
    default: {
      const double from = centre * std::exp(sd * reach);
      return Distribution::log_normal(
          centre, sd, from, std::max(from * std::exp(sd * width), std::nextafter(from, infinity)));
    }
  }
}

// The bounds from the text, in which they stand as they were given.
std::pair<double, double> bounds(const Distribution& d) {
  const std::string text = d.text();
  return {std::stod(text.substr(text.find(" from ") + 6)),
          std::stod(text.substr(text.find(" to ") + 4))};
}

TEST(Distribution, ComesToNoValueBeyondItsBounds) {
  Sampler sampler(5);
  for (int i = 0; i < 2000; ++i) {
    const Distribution d = random_distribution(sampler);
    const auto [from, to] = bounds(d);
    for (const double u : unit_numbers(static_cast<std::uint64_t>(i), 5)) {
      EXPECT_GE(d.quantile(u), from) << d.text() << describe({{"u", u}});
      EXPECT_LE(d.quantile(u), to) << d.text() << describe({{"u", u}});
    }
    for (const double z : {-infinity, -40.0, -9.0, 0.0, 9.0, 40.0, infinity}) {
      EXPECT_GE(quantile_of_normal(d, z), from) << d.text() << describe({{"z", z}});
      EXPECT_LE(quantile_of_normal(d, z), to) << d.text() << describe({{"z", z}});
    }
    EXPECT_LE(d.least(), d.median()) << d.text();
    EXPECT_LE(d.median(), d.greatest()) << d.text();
  }
}

TEST(Distribution, GrowsWithU) {
  for (const Distribution& d :
       {Distribution::uniform(-1, 3), Distribution::log_uniform(1e-6, 1e6),
        Distribution::normal(0, 1, -infinity, infinity), Distribution::normal(0, 1, 3, 40),
        Distribution::normal(0, 1, -2, 0.5), Distribution::log_normal(1e-8, 1, 0, infinity)}) {
    std::vector<double> numbers = unit_numbers(6, 20000);
    std::sort(numbers.begin(), numbers.end());
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      const double before = d.quantile(numbers[i - 1]), after = d.quantile(numbers[i]);
      // The values at neighbouring u may differ by less than their rounding.
      EXPECT_LE(before - after, 4 * ulp * std::abs(after))
          << d.text() << describe({{"u", numbers[i - 1]}, {"u", numbers[i]}});
      if (numbers[i] - numbers[i - 1] > 1e-12) {
        EXPECT_LT(before, after) << d.text()
                                 << describe({{"u", numbers[i - 1]}, {"u", numbers[i]}});
      }
    }
  }
}

TEST(Distribution, SaysWhatItIs) {
  EXPECT_EQ(Distribution::uniform(0.02015, 0.02025).text(), "uniform from 0.02015 to 0.02025");
  EXPECT_EQ(Distribution::log_uniform(1e-9, 1e-7).text(), "log_uniform from 1e-09 to 1e-07");
  EXPECT_EQ(Distribution::normal(0.0202, 0.001, 0.01, 0.04).text(),
            "normal, mean 0.0202, sd 0.001, from 0.01 to 0.04");
  EXPECT_EQ(Distribution::normal(1, 2, -infinity, infinity).text(), "normal, mean 1, sd 2");
  EXPECT_EQ(Distribution::normal(1, 2, 0, infinity).text(), "normal, mean 1, sd 2, from 0");
  EXPECT_EQ(Distribution::log_normal(2e-8, 0.1, 0, infinity).text(),
            "log_normal, median 2e-08, log_sd 0.1");
  EXPECT_EQ(Distribution::log_normal(2e-8, 0.1, 0, 1e-7).text(),
            "log_normal, median 2e-08, log_sd 0.1, to 1e-07");
}

TEST(Distribution, BoundsBeyondAllValuesAreRefused) {
  const struct {
    double mean, sd, from, to;
    bool is_refused;
  } cases[] = {{0, 1, 38, infinity, true}, {0, 1, -infinity, -38, true},
               {5, 0.01, 4, 4.5, true},    {0, 1, 36.9, infinity, false},
               {0, 1, -1000, 1000, false}, {0, 1, -1000, -36.9, false}};
  for (const auto& c : cases)
    EXPECT_EQ(sweep::error_of([&] { Distribution::normal(c.mean, c.sd, c.from, c.to); }),
              c.is_refused ? "its bounds are too far out: next to nothing lies within" : "none");
}

}  // namespace
}  // namespace tribo::verification
