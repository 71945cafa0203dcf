// SPDX-License-Identifier: Apache-2.0
// The batches of F_n, S_n and ln F_n on each instruction set: to their contract against the
// certified rows and long double, and the same bits whatever the place and size.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "support/instruction_sets.hpp"
#include "support/long_double.hpp"
#include "support/orders.hpp"

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int samples = 3000;  // of each order and range

using Batch = void (*)(Order, std::span<const double>, std::span<double>);
constexpr std::array<Batch, 3> batches{gaussian_moment, scaled_gaussian_moment,
                                       log_gaussian_moment};

std::vector<double> evaluated(Batch batch, Order n, std::span<const double> d) {
  std::vector<double> result(d.size());
  batch(n, d, result);
  return result;
}

// Random, the piece edges of both kernels with their neighbours, subnormal results, and far out.
std::vector<double> arguments() {
  std::vector<double> all{0.0,   -0.0, 5e-324,   -5e-324, 1e-310, -1e-310, 1e-260, -1e-260, 1e-300,
                          36.0,  37.3, 32.27553, 37.5,    38.0,   38.4,    38.56,  38.8,    0.775,
                          1e100, 1e16, -1e16,    -1e100,  1e300,  -1e300,  -1e120};
  for (double x = 3; x < 50; x += x < 4 ? 0.0625 : x < 8 ? 0.125 : x < 16 ? 0.25 : x < 32 ? 0.5 : 1)
    for (const double sign : {1.0, -1.0}) {
      const double edge = sign * (x - 3);
      for (const double d : {edge, std::nextafter(edge, -100.0), std::nextafter(edge, 100.0)})
        all.push_back(d);
    }
  for (const double edge : {40.0, 45.0, 50.0})  // ends of the gaussian and of the pieces
    for (const double d : {edge, std::nextafter(edge, 0.0), std::nextafter(edge, 100.0)}) {
      all.push_back(d);
      all.push_back(-d);
    }
  Sampler sampler(141);
  for (int i = 0; i < samples; ++i) {
    all.push_back(sampler.uniform(-45, 0));
    all.push_back(sampler.uniform(0, 36));
    all.push_back(sampler.uniform(36, 39));  // subnormal from 37.1 … 37.6 on
    all.push_back(sampler.uniform(-1, 1));
    all.push_back(sampler.log_uniform(1e-20, 1) * sampler.pick({-1.0, 1.0}));
    if (i % 4 == 0) all.push_back(sampler.log_uniform(40, 1e60) * sampler.pick({-1.0, 1.0}));
  }
  return all;
}

class BatchMoment : public testing::TestWithParam<Order> {
 protected:
  static constexpr double allowed = gaussian_moment_contract.ulp;
  static void hold(const char* which, double got, long double expected, double d) {
    EXPECT_TRUE(is_within_ulp(got, expected, allowed, {{"d", d}})) << which;
  }
  static void hold_logarithm(double got, long double expected, double d) {
    const auto nearest = static_cast<double>(expected);
    if (!std::isfinite(nearest)) return hold("ln F", got, expected, d);
    constexpr double most = log_gaussian_moment_contract.ulp;
    const long double unit = 0x1p-52L * std::max(1.0L, std::fabs(expected));
    const auto error = static_cast<double>(std::fabs(got - expected) / unit);
    record_part_of_bound(error / most);
    EXPECT_LE(error, most) << "ln F" << describe({{"d", d}, {"got", got}, {"expected", nearest}});
  }
};

TEST_P(BatchMoment, KeepsItsContractAtRandomAndAtEdges) {
  const std::vector<double> d = arguments();
  std::vector<long double> moment, scaled, logarithm;
  for (const double x : d) {
    const auto wide = static_cast<long double>(x);
    scaled.push_back(scaled_gaussian_moment(GetParam(), wide));
    moment.push_back(unscaled_product(1.0L, scaled.back(), wide));
    logarithm.push_back(std::log(scaled.back()) - (x > 0 ? wide * wide / 2 : 0.0L));
  }
  on_each_instruction_set([&] {
    const auto got_moment = evaluated(gaussian_moment, GetParam(), d);
    const auto got_scaled = evaluated(scaled_gaussian_moment, GetParam(), d);
    const auto got_logarithm = evaluated(log_gaussian_moment, GetParam(), d);
    for (std::size_t i = 0; i < d.size(); ++i) {
      hold("F", got_moment[i], moment[i], d[i]);
      hold("S", got_scaled[i], scaled[i], d[i]);
      hold_logarithm(got_logarithm[i], logarithm[i], d[i]);
    }
  });
}

TEST_P(BatchMoment, KeepsItsContractOnTheCertifiedRows) {
  std::vector<ReferenceRow> rows;
  std::vector<double> d;
  for (const ReferenceRow& row :
       read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/exact/gaussian_moment.csv"))
    if (static_cast<int>(2 * row.number("order")) == twice(GetParam())) {
      rows.push_back(row);
      d.push_back(row.number("argument"));
    }
  ASSERT_GT(rows.size(), 500u);
  on_each_instruction_set([&] {
    const auto got = evaluated(gaussian_moment, GetParam(), d);
    for (std::size_t i = 0; i < d.size(); ++i) {
      const double error = rows[i].error_in_ulp(got[i]);
      record_part_of_bound(error / allowed);
      EXPECT_LE(error, allowed) << rows[i].text("id") << describe({{"d", d[i]}, {"got", got[i]}});
    }
  });
}

TEST_P(BatchMoment, GivesWhatTheHeaderSaysAtTheEndsOfTheLine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double far_below = GetParam() == Order::zero ? 1 : infinity;
  // Between ordinary points, which they must leave alone.
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

// All kinds of points side by side, each of which takes a way of its own.
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

INSTANTIATE_TEST_SUITE_P(OfEachOrder, BatchMoment,
                         testing::Values(Order::zero, Order::half, Order::one, Order::three_halves,
                                         Order::two, Order::five_halves),
                         order_name);

TEST(InstructionSets, AreChosenByNameAndRefusedWhereUnknown) {
  ASSERT_GE(instruction_sets().size(), 1u);
  EXPECT_EQ(instruction_set(), instruction_sets().front());
  EXPECT_EQ(use_instruction_set("no such set"), false);
  EXPECT_EQ(instruction_set(), instruction_sets().front());
}

}  // namespace
}  // namespace tribo::verification
