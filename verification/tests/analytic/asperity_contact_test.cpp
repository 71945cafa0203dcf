// SPDX-License-Identifier: Apache-2.0
// The prefactors of Greenwood–Tripp and Greenwood–Williamson against Hertz contacts of paraboloids
// summed by nested quadrature: this settles 16√2/15, π² and 4π, the offset and its sign, and would
// reject 8√2/15 with E*.
#include "tribo/asperity_contact.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <functional>

#include "support/judge.hpp"
#include "tribo/hertz.hpp"

namespace tribo::verification {
namespace {

double integrate(const std::function<double(double)>& f, double low, double high) {
  gsl_set_error_handler_off();
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(400);
  gsl_function function{
      [](double x, void* p) { return (*static_cast<const std::function<double(double)>*>(p))(x); },
      const_cast<std::function<double(double)>*>(&f)};
  double value = 0, error = 0;
  gsl_integration_qag(&function, low, high, 0, 1e-10, 400, GSL_INTEG_GAUSS31, workspace, &value,
                      &error);
  gsl_integration_workspace_free(workspace);
  return value;
}

double gaussian(double z, double sd) {
  return std::exp(-z * z / (2 * sd * sd)) / (sd * std::sqrt(2 * M_PI));
}

// One pair of summits pressed together by w > 0; curvature radius of the pair.
struct Pair {
  double load, area;
};
Pair hertz_pair(double w, double radius, double modulus) {
  return {4.0 / 3 * modulus * std::sqrt(radius) * std::pow(w, 1.5), M_PI * radius * w};
}

// A rough surface under load; its summits stand δσ_s above its mean plane in the mean.
struct Case {
  double density = 7e10, radius = 1.3e-5, sd = 6e-8, modulus = 9e10, load = 30, body_radius = 0.012;
  double offset = 0.4;
  double area = hertz_point(load, modulus, body_radius).nominal_area;
};

// A smooth plane against summits: n per area, heights Gaussian, pair radius β.
TEST(GreenwoodWilliamson, IsHertzContactsOfParaboloidsOnAPlane) {
  const Case c;
  const auto contact = asperity_contact(AsperityModel::greenwood_williamson, c.density, c.radius,
                                        c.sd, c.offset, c.modulus, c.area, c.load);
  for (const double separation : {0.0, 0.7, 1.9, 3.5}) {
    const double d = (separation - c.offset) * c.sd;
    const auto sum = [&](auto&& quantity) {
      return c.density * c.area *
             integrate([&](double z) { return gaussian(z, c.sd) * quantity(z - d); }, d,
                       d + 12 * c.sd);
    };
    const double load = sum([&](double w) { return hertz_pair(w, c.radius, c.modulus).load; });
    const double area = sum([&](double w) { return hertz_pair(w, c.radius, c.modulus).area; });
    const double count = sum([](double) { return 1.0; });
    EXPECT_TRUE(is_close(
        moment_product(contact.stiffness, load_order(contact.model), separation - c.offset),
        load / c.load, 1e-8, {{"separation", separation}}));
    EXPECT_TRUE(is_close(real_area_ratio(contact, separation), area / c.area, 1e-8,
                         {{"separation", separation}}));
    EXPECT_TRUE(
        is_close(summit_count(contact, separation), count, 1e-8, {{"separation", separation}}));
  }
}

// Two faces of n summits per area each: a pair at the lateral offset x meets at a slope, pressed by
// w = z − d − x²/(4β) with z the sum of the heights (standard deviation σ_s), pair radius β/2.
TEST(GreenwoodTripp, IsHertzContactsOfPairsOfParaboloidsAtRandomOffsets) {
  const Case c;
  const auto contact = asperity_contact(AsperityModel::greenwood_tripp, c.density, c.radius, c.sd,
                                        c.offset, c.modulus, c.area, c.load);
  for (const double separation : {0.0, 0.7, 1.9, 3.5}) {
    const double d = (separation - c.offset) * c.sd;
    const auto sum = [&](auto&& quantity) {
      return c.density * c.density * c.area *
             integrate(
                 [&](double z) {
                   const double reach = std::sqrt(4 * c.radius * (z - d));
                   return gaussian(z, c.sd) * integrate(
                                                  [&](double x) {
                                                    const double w = z - d - x * x / (4 * c.radius);
                                                    return w > 0 ? 2 * M_PI * x * quantity(w) : 0.0;
                                                  },
                                                  0, reach);
                 },
                 d, d + 12 * c.sd);
    };
    const double load = sum([&](double w) { return hertz_pair(w, c.radius / 2, c.modulus).load; });
    const double area = sum([&](double w) { return hertz_pair(w, c.radius / 2, c.modulus).area; });
    const double count = sum([](double) { return 1.0; });
    EXPECT_TRUE(is_close(
        moment_product(contact.stiffness, load_order(contact.model), separation - c.offset),
        load / c.load, 1e-8, {{"separation", separation}}));
    EXPECT_TRUE(is_close(real_area_ratio(contact, separation), area / c.area, 1e-8,
                         {{"separation", separation}}));
    EXPECT_TRUE(
        is_close(summit_count(contact, separation), count, 1e-8, {{"separation", separation}}));
  }
}

}  // namespace
}  // namespace tribo::verification
