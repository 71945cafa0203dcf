// SPDX-License-Identifier: Apache-2.0
// F_n against quadrature and closed forms that share nothing with the implementation, and the
// relations between the orders.
#include "tribo/gaussian_moment.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "support/judge.hpp"
#include "support/orders.hpp"

namespace tribo::verification {
namespace {

constexpr std::array orders{Order::zero,         Order::half, Order::one,
                            Order::three_halves, Order::two,  Order::five_halves};

constexpr double contract = gaussian_moment_contract.ulp * 0x1p-52;

class OfEachOrder : public testing::TestWithParam<Order> {};

// exp-sinh quadrature of ∫ tⁿ e^{−t²/2−dt} dt, in 50 digits: no expansion in common.
TEST_P(OfEachOrder, FiftyDigitsAgreeWithBoostQuadrature) {
  boost::math::quadrature::exp_sinh<Reference> quadrature(12);
  const Reference n = value_of<Reference>(GetParam());
  for (const double d :
       {-16.0, -9.5, -3.2, -1.0, -0.3, 0.0, 0.4, 1.0, 2.5, 7.0, 15.0, 16.9, 37.0}) {
    const Reference shift = d < 0 ? Reference(d) : Reference(0);
    const auto integrand = [&](const Reference& t) -> Reference {
      if (t > 200) return 0;
      // below zero the scale e^{d²/2} stays inside
      return pow(t, n) * exp(-t * t / 2 - t * Reference(d) - shift * shift / 2);
    };
    const Reference integral =
        quadrature.integrate(integrand, Reference("1e-44")) / sqrt_two_pi<Reference>();
    const Reference got = scaled_gaussian_moment(GetParam(), Reference(d));
    EXPECT_LT(abs((got - integral) / integral), Reference("1e-38")) << describe({{"d", d}});
  }
}

TEST_P(OfEachOrder, ValueAtZeroIsTheClosedForm) {
  const Reference n = value_of<Reference>(GetParam());
  const Reference expected = pow(Reference(2), n / 2 - 1) *
                             boost::math::tgamma(Reference((n + 1) / 2)) / sqrt(pi<Reference>());
  EXPECT_TRUE(is_close(gaussian_moment(GetParam(), 0.0), expected, contract, {{"d", 0}}));
  EXPECT_EQ(gaussian_moment(GetParam(), 0.0), gaussian_moment(GetParam(), -0.0));
}

TEST_P(OfEachOrder, FallsWithItsArgumentAndIsConvexAndLogConcave) {
  // In steps wide enough that the second differences stand far above rounding.
  const double h = 0.05;
  for (double d = -39; d < 36; d += h) {
    const double left = gaussian_moment(GetParam(), d - h);
    const double here = gaussian_moment(GetParam(), d);
    const double right = gaussian_moment(GetParam(), d + h);
    const double rounding = 3 * contract * left;
    if (GetParam() != Order::zero || d > -8) {  // F_0 is 1 to rounding below
      EXPECT_GT(left, here) << describe({{"d", d}});
    }
    if (GetParam() >= Order::one) {  // F_n″ = n(n−1)F_{n−2} > 0; F_0 and F_{1/2} turn below 0
      EXPECT_GT(left + right + rounding, 2 * here) << describe({{"d", d}});
    }
    EXPECT_LT(log_gaussian_moment(GetParam(), d - h) + log_gaussian_moment(GetParam(), d + h),
              2 * log_gaussian_moment(GetParam(), d) + 4 * contract * (1 + d * d))
        << describe({{"d", d}});
  }
}

TEST_P(OfEachOrder, LogarithmIsThatOfFiftyDigitsAndDoesNotUnderflow) {
  for (double d = -40; d < 2000; d = d < 30 ? d + 0.61 : d * 1.3) {
    const Reference expected = log(scaled_gaussian_moment(GetParam(), Reference(d))) -
                               (d > 0 ? Reference(d) * d / 2 : Reference(0));
    // Absolute where the logarithm is near 0.
    EXPECT_LE(static_cast<double>(abs(log_gaussian_moment(GetParam(), d) - expected)),
              contract + 4 * 0x1p-53 * static_cast<double>(abs(expected)))
        << describe({{"d", d}});
  }
}

TEST_P(OfEachOrder, EndsOfTheLineAreExact) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(gaussian_moment(GetParam(), infinity), 0);
  EXPECT_EQ(gaussian_moment(GetParam(), 1e300), 0);
  EXPECT_EQ(gaussian_moment(GetParam(), -infinity), GetParam() == Order::zero ? 1 : infinity);
  EXPECT_EQ(log_gaussian_moment(GetParam(), infinity), -infinity);
  EXPECT_TRUE(std::isnan(gaussian_moment(GetParam(), std::nan(""))));
  EXPECT_TRUE(std::isnan(log_gaussian_moment(GetParam(), std::nan(""))));
}

TEST_P(OfEachOrder, ProductUndoesUnderflow) {
  for (const double d : {36.0, 37.5, 38.5, 39.0, 45.0, 50.0}) {
    const Reference expected = Reference(1e300) * gaussian_moment(GetParam(), Reference(d));
    if (expected < Reference(1e-300)) continue;
    EXPECT_TRUE(is_close(moment_product(1e300, GetParam(), d), expected, 8 * 0x1p-52,
                         {{"d", d}}));  // two exponentials, three products
  }
}

INSTANTIATE_TEST_SUITE_P(GaussianMoment, OfEachOrder, testing::ValuesIn(orders), order_name);

TEST(GaussianMoment, IntegerOrdersAreTheErrorFunctionForms) {
  for (const double d : {-12.0, -4.0, -1.0, -0.5, 0.0, 0.5, 1.0, 3.0, 8.0}) {
    const Reference x = d;
    const Reference density = exp(-x * x / 2) / sqrt_two_pi<Reference>();
    const Reference tail = boost::math::erfc(Reference(x / sqrt(Reference(2)))) / 2;
    // The closed forms cancel: 1e-46·d^4e^{...} of 50 digits are left, 30 are asked.
    const auto close = [&](Order n, const Reference& expected) {
      EXPECT_LT(abs((gaussian_moment(n, x) - expected) / expected), Reference("1e-30"))
          << describe({{"d", d}, {"2n", 2 * value_of<double>(n)}});
    };
    close(Order::zero, tail);
    close(Order::one, density - x * tail);
    close(Order::two, (1 + x * x) * tail - x * density);
  }
}

// F_{1/2}(d) = Γ(3/2)/√(2π) e^{−d²/4} U(1, d), with U(1, d) = 2/√π (d/2)^{3/2} (K_{3/4} − K_{1/4})
// of d²/4 for d > 0 (Abramowitz and Stegun, 19.15).
TEST(GaussianMoment, OrderOneHalfIsTheBesselForm) {
  for (const double d : {0.3, 0.775, 1.0, 2.0, 5.0, 12.0}) {
    const Reference x = d;
    const Reference z = x * x / 4;
    const Reference k14 = boost::math::cyl_bessel_k(Reference(1) / 4, z);
    const Reference k34 = boost::math::cyl_bessel_k(Reference(3) / 4, z);
    const Reference u = 2 / sqrt(pi<Reference>()) * (x / 2) * sqrt(Reference(x / 2)) * (k34 - k14);
    const Reference expected =
        boost::math::tgamma(Reference(3) / 2) / sqrt_two_pi<Reference>() * exp(-z) * u;
    EXPECT_LT(abs((gaussian_moment(Order::half, x) - expected) / expected), Reference("1e-35"))
        << describe({{"d", d}});
  }
}

TEST(GaussianMoment, OrdersObeyTheRecurrence) {
  Sampler sampler(11);
  for (int i = 0; i < 2000; ++i) {
    const double d = sampler.uniform(-30, 30);
    for (const Order n : {Order::one, Order::three_halves}) {
      const double above = gaussian_moment(static_cast<Order>(twice(n) + 2), d);
      const double middle = d * gaussian_moment(n, d);
      const double below = value_of<double>(n) * gaussian_moment(lower(n), d);
      // F_{n+1} + dF_n = nF_{n−1}: backward error of each term
      const double scale = above + std::abs(middle) + below;
      // and the rounding of d F_n and of the sum
      EXPECT_LE(std::abs(above + middle - below), 2 * contract * scale) << describe({{"d", d}});
    }
  }
}

TEST(GaussianMoment, SlopeIsMinusNTimesTheLowerOrder) {
  const Reference h("1e-16");
  for (double d = -20; d < 30; d += 0.7)
    for (const Order n : {Order::one, Order::three_halves, Order::two, Order::five_halves}) {
      const Reference slope =
          (gaussian_moment(n, Reference(d + h)) - gaussian_moment(n, Reference(d - h))) / (2 * h);
      const Reference expected = -value_of<Reference>(n) * gaussian_moment(lower(n), Reference(d));
      EXPECT_LT(abs((slope - expected) / expected), Reference("1e-28")) << describe({{"d", d}});
    }
}

TEST(GaussianMoment, IsLogConvexInTheOrder) {
  for (double d = -35; d < 36; d += 0.25)
    for (int k = 1; k < 5; ++k) {
      const double below = log_gaussian_moment(static_cast<Order>(k - 1), d);
      const double here = log_gaussian_moment(static_cast<Order>(k), d);
      const double above = log_gaussian_moment(static_cast<Order>(k + 1), d);
      EXPECT_LE(2 * here, below + above + 1e-12 * (1 + d * d)) << describe({{"d", d}});
    }
}

}  // namespace
}  // namespace tribo::verification
