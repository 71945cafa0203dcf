// SPDX-License-Identifier: Apache-2.0
// e^x and ln x of many numbers on each instruction set: against long double, at the ends of their
// ranges, and with the same bits at any place of a batch of any size.
#include "tribo/elementary.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "support/instruction_sets.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Batch = void (*)(std::span<const double>, std::span<double>);

std::vector<double> of(Batch batch, const std::vector<double>& x) {
  std::vector<double> result(x.size());
  batch(x, result);
  return result;
}

// Exponents x at which e^x is a normal number, and small ones, at which it is next to 1.
std::vector<double> exponents() {
  std::vector<double> all{0, -0.0, 1, -1, 709.78, -708.39};
  Sampler sampler(71);
  for (int i = 0; i < 10000; ++i) {
    all.push_back(sampler.uniform(-708.39, 709.78));
    all.push_back(sampler.log_uniform(1e-20, 1) * sampler.pick({-1.0, 1.0}));
  }
  return all;
}

// Numbers of all sizes, and numbers next to 1, where the logarithm vanishes.
std::vector<double> positive_numbers() {
  std::vector<double> all{1, 2, 0x1p-1022, 0x1p-1074, 1.7e308};
  Sampler sampler(72);
  for (int i = 0; i < 10000; ++i) {
    all.push_back(sampler.log_uniform(1e-307, 1e307));
    all.push_back(1 + sampler.log_uniform(1e-15, 0.5) * sampler.pick({-1.0, 1.0}));
  }
  return all;
}

void hold_to_one_ulp(Batch batch, const std::vector<double>& x, long double (*exact)(long double)) {
  const std::vector<double> got = of(batch, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const long double expected = exact(x[i]);
    const double ulp =
        expected == 0 ? 0 : std::ldexp(1.0, std::ilogb(static_cast<double>(expected)) - 52);
    EXPECT_TRUE(is_within(static_cast<double>(got[i] - expected), 0, ulp))
        << describe({{"x", x[i]}, {"got", got[i]}});
  }
}

TEST(Elementary, AreOffByNoMoreThanOneUlpOnEachInstructionSet) {
  on_each_instruction_set([] {
    hold_to_one_ulp(exponential, exponents(), std::exp);
    hold_to_one_ulp(logarithm, positive_numbers(), std::log);
  });
}

TEST(Elementary, AtTheEndsOfTheLineAreThoseOfTheStandardLibrary) {
  on_each_instruction_set([] {
    EXPECT_EQ(of(exponential, {710, infinity, -infinity, -1e300}),
              (std::vector{infinity, infinity, 0.0, 0.0}));
    EXPECT_EQ(of(logarithm, {0, -0.0, infinity, 1}),
              (std::vector{-infinity, -infinity, infinity, 0.0}));
    for (const double number : of(logarithm, {-1, -infinity, nan}))
      EXPECT_EQ(std::isnan(number), true);
    EXPECT_EQ(std::isnan(of(exponential, {nan})[0]), true);
  });
}

TEST(Elementary, HaveTheSameBitsWhateverThePlaceAndSize) {
  on_each_instruction_set([] {
    for (const auto& [batch, all] :
         {std::pair<Batch, std::vector<double>>{exponential, exponents()},
          std::pair<Batch, std::vector<double>>{logarithm, positive_numbers()}}) {
      const std::span<const double> x(all.data(), 60);
      hold_bits_whatever_place_and_size(
          x.size(), [&, batch = batch](std::size_t first, std::size_t count, auto result) {
            batch(x.subspan(first, count), result);
          });
    }
  });
}

}  // namespace
}  // namespace tribo::verification
