// SPDX-License-Identifier: Apache-2.0
// The batches of F_n, S_n and ln F_n on each instruction set: each number has the same bits alone
// and at any place of a batch of any size.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "support/instruction_sets.hpp"
#include "support/judge.hpp"
#include "support/orders.hpp"

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Batch = void (*)(Order, std::span<const double>, std::span<double>);
constexpr std::array<Batch, 3> batches{gaussian_moment, scaled_gaussian_moment,
                                       log_gaussian_moment};

std::vector<double> evaluated(Batch batch, Order n, std::span<const double> d) {
  std::vector<double> result(d.size());
  batch(n, d, result);
  return result;
}

class BatchMoment : public testing::TestWithParam<Order> {};

TEST_P(BatchMoment, GivesWhatTheHeaderSaysAtTheEndsOfTheLine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double far_below = GetParam() == Order::zero ? 1 : infinity;
  // The ends stand between ordinary points, whose results they must not change.
  const std::vector<double> d{1, infinity, -2, -infinity, 3, nan, 0.0, -0.0, -44, infinity, nan};
  on_each_instruction_set([&] {
    for (const Batch batch : batches) {
      const std::vector<double> got = evaluated(batch, GetParam(), d);
      const bool is_logarithm = batch == batches[2];
      for (std::size_t i = 0; i < d.size(); ++i) {
        const double expected = std::isnan(d[i])   ? nan
                                : d[i] == infinity ? (is_logarithm ? -infinity : 0)
                                : d[i] == -infinity
                                    ? (is_logarithm ? std::log(far_below) : far_below)
                                    : evaluated(batch, GetParam(), std::vector<double>(3, d[i]))[1];
        if (std::isnan(d[i]))
          EXPECT_NE(got[i], got[i]);
        else
          EXPECT_EQ(got[i], expected) << d[i];
      }
      EXPECT_EQ(got[6], got[7]);  // ±0
    }
  });
}

// Points of all kinds side by side; each kind is computed in another way.
std::vector<double> mixed_arguments() {
  Sampler sampler(142);
  std::vector<double> d;
  for (int i = 0; i < 12; ++i) {
    d.push_back(sampler.uniform(0, 36));
    d.push_back(sampler.uniform(-44, 0));
    d.push_back(sampler.pick({-50.0, 41.0, 37.9, -1e20, 46.0, -0.0}));
    d.push_back(sampler.uniform(-3, 3));
  }
  return d;
}

TEST_P(BatchMoment, BitsDoNotDependOnPlaceOrSize) {
  const std::vector<double> d = mixed_arguments();
  on_each_instruction_set([&] {
    for (const Batch batch : batches)
      hold_bits_whatever_place_and_size(
          d.size(), [&](std::size_t first, std::size_t count, std::span<double> result) {
            batch(GetParam(), std::span(d).subspan(first, count), result);
          });
  });
}

TEST_P(BatchMoment, GivesTheBitsOfEachNumberAlone) {
  std::vector<double> d = mixed_arguments();
  d.insert(d.end(), {infinity, -infinity, 1e300, -1e300});
  Sampler sampler(141);
  for (int i = 0; i < 10000; ++i) d.push_back(sampler.uniform(-45, 39));
  for (int i = 0; i < 500; ++i)
    d.push_back(sampler.log_uniform(1e-310, 1e300) * sampler.pick({-1.0, 1.0}));
  on_each_instruction_set([&] {
    const auto moment = evaluated(gaussian_moment, GetParam(), d);
    const auto scaled = evaluated(scaled_gaussian_moment, GetParam(), d);
    for (std::size_t i = 0; i < d.size(); ++i) {
      EXPECT_EQ(moment[i], gaussian_moment(GetParam(), d[i])) << describe({{"d", d[i]}});
      EXPECT_EQ(scaled[i], scaled_gaussian_moment(GetParam(), d[i])) << describe({{"d", d[i]}});
    }
  });
}

TEST_P(BatchMoment, TheResultMayOverwriteTheArgument) {
  const std::vector<double> d = mixed_arguments();
  on_each_instruction_set([&] {
    for (const Batch batch : batches)
      for (std::size_t count = 1; count <= d.size(); ++count) {
        const std::vector<double> apart = evaluated(batch, GetParam(), std::span(d).first(count));
        std::vector<double> over(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(count));
        batch(GetParam(), over, over);
        ASSERT_EQ(std::memcmp(over.data(), apart.data(), count * sizeof(double)), 0) << count;
      }
  });
}

INSTANTIATE_TEST_SUITE_P(OfEachOrder, BatchMoment, testing::ValuesIn(orders), order_name);

TEST(InstructionSets, AreChosenByNameAndRefusedWhereUnknown) {
  ASSERT_GE(instruction_sets().size(), 1u);
  EXPECT_EQ(instruction_set(), instruction_sets().front());
  EXPECT_EQ(use_instruction_set("no such set"), false);
  EXPECT_EQ(instruction_set(), instruction_sets().front());
}

}  // namespace
}  // namespace tribo::verification
