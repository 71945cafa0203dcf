// SPDX-License-Identifier: Apache-2.0
// The prefactors of Greenwood–Tripp and Greenwood–Williamson against Hertz contacts of paraboloids
// summed by nested quadrature: this settles 16√2/15, π² and 4π, and would reject 8√2/15 with E*.
#include "tribo/asperity_contact.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <functional>

#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"

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

struct Case {
  double density = 7e10, radius = 1.3e-5, sd = 6e-8, modulus = 9e10, load = 30, body_radius = 0.012;
  double area = hertz_point(load, modulus, body_radius).nominal_area;
};

// A smooth plane against summits: n per area, heights Gaussian, pair radius β.
TEST(GreenwoodWilliamson, IsHertzContactsOfParaboloidsOnAPlane) {
  const Case c;
  const auto contact = asperity_contact(AsperityModel::greenwood_williamson, c.density, c.radius,
                                        c.sd, 0.0, c.modulus, c.area, c.load);
  for (const double separation : {0.0, 0.7, 1.9, 3.5}) {
    const double d = separation * c.sd;
    const auto sum = [&](auto&& quantity) {
      return c.density * c.area *
             integrate([&](double z) { return gaussian(z, c.sd) * quantity(z - d); }, d,
                       d + 12 * c.sd);
    };
    const double load = sum([&](double w) { return hertz_pair(w, c.radius, c.modulus).load; });
    const double area = sum([&](double w) { return hertz_pair(w, c.radius, c.modulus).area; });
    const double count = sum([](double) { return 1.0; });
    EXPECT_TRUE(is_close(moment_product(contact.stiffness, load_order(contact.model), separation),
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
                                        0.0, c.modulus, c.area, c.load);
  for (const double separation : {0.0, 0.7, 1.9, 3.5}) {
    const double d = separation * c.sd;
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
    EXPECT_TRUE(is_close(moment_product(contact.stiffness, load_order(contact.model), separation),
                         load / c.load, 1e-8, {{"separation", separation}}));
    EXPECT_TRUE(is_close(real_area_ratio(contact, separation), area / c.area, 1e-8,
                         {{"separation", separation}}));
    EXPECT_TRUE(
        is_close(summit_count(contact, separation), count, 1e-8, {{"separation", separation}}));
  }
}

// Near a high floor the model takes the moments from the load share, not from the separation; in
// long double the separation is good enough.
TEST(AsperityContact, NearAHighFloorAreaAndCountAreTheMomentsAtTheSeparation) {
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const double planes_apart : {0.0, 2.0, 8.0})
      for (const double stiffer : {10.0, 1e3, 1e6}) {
        Scene scene = paper_scene(PaperSurface::rough, model);
        scene.surface.summit_plane_offset = planes_apart;
        scene.surface.summit_density *= stiffer;
        scene.supply = {};
        const MixedContact<double> contact(scene);
        const MixedContact<long double> wide(scene);
        const double floor = contact.sharing().floor();
        if (!(floor > 3)) continue;
        for (const double part : {0.1, 0.5, 0.7, 0.8, 0.9, 1.1}) {
          const double speed = contact.speed_at(part * floor);
          const OperatingPoint<double> got = contact.solve(speed);
          const long double separation = wide.flooded(speed).shares.film_parameter;
          const auto close = [&](double value, long double expected) {
            EXPECT_TRUE(
                is_close(value, Reference(expected), 1e-13, {{"floor", floor}, {"part", part}}));
          };
          close(got.real_area_ratio, real_area_ratio(wide.asperities(), separation));
          close(got.summit_count, summit_count(wide.asperities(), separation));
        }
      }
}

TEST(AsperityContact, PrefactorsAgreeWithFiftyDigits) {
  Sampler sampler(5);
  for (int i = 0; i < 300; ++i) {
    const double density = sampler.log_uniform(1e8, 1e13), radius = sampler.log_uniform(1e-7, 1e-3);
    const double sd = sampler.log_uniform(1e-9, 1e-5), modulus = sampler.log_uniform(1e8, 1e12);
    const double area = sampler.log_uniform(1e-10, 1e-4), load = sampler.log_uniform(1e-3, 1e5);
    for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson}) {
      const auto got = asperity_contact(model, density, radius, sd, 1.146, modulus, area, load);
      const auto exact =
          asperity_contact(model, Reference(density), Reference(radius), Reference(sd),
                           Reference(1.146), Reference(modulus), Reference(area), Reference(load));
      const auto close = [&](double value, const Reference& expected) {
        EXPECT_TRUE(is_close(value, expected, 10 * 0x1p-52, {{"density", density}, {"sd", sd}}));
      };
      close(got.stiffness, exact.stiffness);
      close(got.area_factor, exact.area_factor);
      close(got.count_factor, exact.count_factor);
    }
  }
}

}  // namespace
}  // namespace tribo::verification
