// SPDX-License-Identifier: Apache-2.0
// F_n and S_n in double, on each instruction set, to one unit in the last place: at random, at the
// piece edges and their neighbours, where results are subnormal, and far out.
#include <gtest/gtest.h>

#include <vector>

#include "support/instruction_sets.hpp"
#include "support/judge.hpp"
#include "support/orders.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::verification {
namespace {

constexpr int samples = 1500;  // of each order and range

std::vector<double> arguments(Sampler& sampler) {
  std::vector<double> all{0.0,  -0.0, 5e-324, -5e-324,  1e-300, -1e-300, 36.0, 37.3, 37.5,
                          38.0, 38.4, 38.56,  32.27553, 0.775,  39.9,    40,   -40};
  for (double x = 3; x < 48; x += x < 4 ? 0.125 : x < 8 ? 0.25 : x < 16 ? 0.5 : x < 32 ? 1 : 2)
    for (const double sign : {1.0, -1.0}) {
      const double edge = sign * (x - 3);
      for (const double d : {edge, std::nextafter(edge, -100.0), std::nextafter(edge, 100.0)})
        all.push_back(d);
    }
  for (int i = 0; i < samples; ++i) {
    all.push_back(sampler.uniform(-45, 0));
    all.push_back(sampler.uniform(0, 38.6));
    all.push_back(sampler.log_uniform(1e-20, 1) * sampler.pick({-1.0, 1.0}));
    if (i % 10 == 0) all.push_back(-sampler.log_uniform(45, 1e60));
  }
  return all;
}

// In units in the last place of the expected, one subnormal unit at least.
double error_in_ulp(double got, const Reference& expected) {
  if (Reference(got) == expected) return 0;
  int exponent = 0;
  std::frexp(static_cast<double>(expected), &exponent);
  const double unit = std::ldexp(1.0, std::max(exponent - 53, -1074));
  return static_cast<double>(abs(Reference(got) - expected) / unit);
}

class MomentKernel : public testing::TestWithParam<Order> {
 protected:
  static void hold(const char* which, double got, const Reference& expected, double d) {
    const double error = error_in_ulp(got, expected);
    record_part_of_bound(error / gaussian_moment_contract.ulp);
    EXPECT_LE(error, gaussian_moment_contract.ulp)
        << which << describe({{"d", d}, {"got", got}}) << "\n  expected " << expected.str(25);
  }
};

TEST_P(MomentKernel, IsOffByNoMoreThanOneUnit) {
  Sampler sampler(81);
  for (const double d : arguments(sampler)) {
    const Reference scaled = scaled_gaussian_moment(GetParam(), Reference(d));
    const Reference moment = unscaled_product(Reference(1), scaled, Reference(d));
    on_each_instruction_set([&] {
      hold("F", gaussian_moment(GetParam(), d), moment, d);
      hold("S", scaled_gaussian_moment(GetParam(), d), scaled, d);
    });
  }
}

TEST_P(MomentKernel, GivesWhatTheHeaderSaysAtTheEndsOfTheLine) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Order n = GetParam();
  on_each_instruction_set([&] {
    EXPECT_EQ(gaussian_moment(n, infinity), 0);
    EXPECT_EQ(gaussian_moment(n, 1e300), 0);
    EXPECT_EQ(gaussian_moment(n, -infinity), n == Order::zero ? 1 : infinity);
    EXPECT_EQ(gaussian_moment(n, -1e300) > 1e149, twice(n) >= 1);
    const double nan = gaussian_moment(n, std::numeric_limits<double>::quiet_NaN());
    EXPECT_NE(nan, nan);
  });
}

INSTANTIATE_TEST_SUITE_P(OfEachOrder, MomentKernel,
                         testing::Values(Order::zero, Order::half, Order::one, Order::three_halves,
                                         Order::two, Order::five_halves),
                         order_name);

}  // namespace
}  // namespace tribo::verification
