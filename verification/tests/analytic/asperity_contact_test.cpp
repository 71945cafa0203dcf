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

// Hertz' load and area of one pair of summits that is pressed together by w > 0. `radius` is the
// reduced radius of the pair.
struct Pair {
  double load, area;
};
Pair hertz_pair(double w, double radius, double modulus) {
  return {4.0 / 3 * modulus * std::sqrt(radius) * std::pow(w, 1.5), M_PI * radius * w};
}

// A rough surface under load. On average its summits are δσ_s above its mean plane.
struct Case {
  double density = 7e10, radius = 1.3e-5, sd = 6e-8, modulus = 9e10, load = 30, body_radius = 0.012;
  double offset = 0.4;
  double area = hertz_point(load, modulus, body_radius).nominal_area;
};

// Expects load, area and count of a contact to be sums over pairs of summits: sum(d, quantity) adds
// up a quantity of w over all pairs that are pressed by w > 0 at the distance d of the mean planes.
template <class Sum>
void expect_sums(const Case& c, AsperityModel model, double pair_radius, Sum&& sum) {
  const auto contact =
      asperity_contact(model, c.density, c.radius, c.sd, c.offset, c.modulus, c.area, c.load);
  for (const double separation : {0.0, 0.7, 1.9, 3.5}) {
    const double d = (separation - c.offset) * c.sd;
    const auto pair = [&](double w) { return hertz_pair(w, pair_radius, c.modulus); };
    const auto close = [&](double got, double expected) {
      EXPECT_TRUE(is_close(got, expected, 1e-8, {{"separation", separation}}));
    };
    close(moment_product(contact.stiffness, load_order(contact.model), separation - c.offset),
          sum(d, [&](double w) { return pair(w).load; }) / c.load);
    close(real_area_ratio(contact, separation),
          sum(d, [&](double w) { return pair(w).area; }) / c.area);
    close(summit_count(contact, separation), sum(d, [](double) { return 1.0; }));
  }
}

// A smooth plane against summits: n per area, heights Gaussian, pair radius β.
TEST(GreenwoodWilliamson, IsHertzContactsOfParaboloidsOnAPlane) {
  const Case c;
  expect_sums(c, AsperityModel::greenwood_williamson, c.radius, [&](double d, auto&& quantity) {
    return c.density * c.area *
           integrate([&](double z) { return gaussian(z, c.sd) * quantity(z - d); }, d,
                     d + 12 * c.sd);
  });
}

// Two faces of n summits per area each: a pair at the lateral offset x meets at a slope, pressed by
// w = z − d − x²/(4β) with z the sum of the heights (standard deviation σ_s), pair radius β/2.
TEST(GreenwoodTripp, IsHertzContactsOfPairsOfParaboloidsAtRandomOffsets) {
  const Case c;
  expect_sums(c, AsperityModel::greenwood_tripp, c.radius / 2, [&](double d, auto&& quantity) {
    const auto over_offsets = [&](double z) {
      const double reach = std::sqrt(4 * c.radius * (z - d));
      return integrate(
          [&](double x) {
            const double w = z - d - x * x / (4 * c.radius);
            return w > 0 ? 2 * M_PI * x * quantity(w) : 0.0;
          },
          0, reach);
    };
    return c.density * c.density * c.area *
           integrate([&](double z) { return gaussian(z, c.sd) * over_offsets(z); }, d,
                     d + 12 * c.sd);
  });
}

}  // namespace
}  // namespace tribo::verification
