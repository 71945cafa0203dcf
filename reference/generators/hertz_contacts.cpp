// SPDX-License-Identifier: Apache-2.0
// Hertz' contacts: the circle, the ellipse and the line.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "generators/ellipse_shape.hpp"
#include "generators/sampler.hpp"
#include "generators/table.hpp"

namespace tribo::reference {
namespace {

// Contacts with the load, the modulus or the radius at an end of its reach. To keep the contact
// small, the radius is set such that W, the load over 2E* R^power, is as usual; where the radius is
// at an end, the load is set so. Both stay within limits.
std::vector<Numbers> contacts_at_ends(const Numbers& usual, double power, double greatest_load) {
  const double number = usual[0] / (2 * usual[1] * std::pow(usual[2], power));  // W
  std::vector<Numbers> all;
  for (Numbers x : at_ends(usual, {{0, 1e-3, greatest_load}, {1, 1e5, 1e12}})) {
    const double radius = std::pow(x[0] / (2 * x[1] * number), 1 / power);
    x[2] = std::clamp(radius, 1e-5, 1.0);
    all.push_back(std::move(x));
  }
  for (const double radius : {1e-6, 10.0}) {
    const double load = number * 2 * usual[1] * std::pow(radius, power);
    all.push_back({std::clamp(load, 1e-3, greatest_load), usual[1], radius});
  }
  return all;
}

Table circular_contact_values() {
  Table table{
      {"hertz_point", "a^3 = 3FR/(4E*), mean pressure F/(pi a^2), peak 3/2 of it, approach a^2/R",
       "m, Pa, Pa, m", "load [1e-6, 1e6] N, effective modulus [1e6, 1e12] Pa, radius [1e-6, 10] m",
       "powers",
       "a by bisection on a^3; peak pressure as 2aE*/(pi R), approach as (9F^2/(16 E*^2 R))^(1/3)",
       "output,load,effective_modulus,reduced_radius"},
      "h"};
  Sampler sampler(404);
  std::vector<Numbers> contacts{{50, 107.9e9, 9.5e-3}};
  while (contacts.size() < 40) {
    const double f = sampler.log_uniform(1e-6, 1e6), e = sampler.log_uniform(1e6, 1e12);
    contacts.push_back({f, e, sampler.log_uniform(1e-6, 10)});
  }
  for (const Numbers& x : steps({40, 1.1e11, 0.01}, {250, 1.6e11, 0.025})) contacts.push_back(x);
  const std::size_t first_end = contacts.size();
  for (const Numbers& x : contacts_at_ends({40, 1.1e11, 0.01}, 2, 1e6)) contacts.push_back(x);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (int k = 0; k < 4; ++k)
      table.add([x = contacts[i], k, is_end = i >= first_end] {
        const Ball load(x[0]), modulus(x[1]), radius(x[2]);
        const Ball cube = 3 * load * radius / (4 * modulus);
        const Ball a = pow(cube, fraction(1, 3));
        const Ball b =
            zero_between([&](const Ball& y) { return y * y * y - cube; }, Ball(1e-12), Ball(1e4));
        const Ball mean = load / (ball_pi() * a * a);
        const Ball values[] = {a, mean, mean * 3 / 2, a * a / radius};
        const Ball others[] = {
            b, 4 * b * modulus / (3 * ball_pi() * radius), 2 * b * modulus / (ball_pi() * radius),
            pow(9 * load * load / (16 * modulus * modulus * radius), fraction(1, 3))};
        constexpr const char* names[] = {"radius", "mean_pressure", "peak_pressure", "approach"};
        return Row{{names[k]}, x, values[k], others[k], Ball(1), is_end ? "end" : "ordinary"};
      });
  return table;
}

struct EllipticalContact {
  double load, modulus, radius_x, radius_y;
  const char* region;
};

std::vector<EllipticalContact> elliptical_contacts() {
  std::vector<EllipticalContact> all{
      {50, 107.9e9, 9.5e-3, 19e-3, "ordinary"},
      {1e3, 113e9, 4.09e-3, 0.13, "ordinary"},   // a ball on the inner ring of a bearing
      {1e3, 113e9, 5.91e-3, 88e-3, "ordinary"},  // on the outer ring
      {2e4, 113e9, 7.5e-3, 1.2, "ordinary"},     // a crowned roller
      {8e4, 113e9, 0.46, 0.3, "ordinary"},       // a wheel on a rail
      {2e3, 2e9, 0.7, 0.35, "ordinary"},         // the cup of an artificial hip
      {30, 50e9, 20e-3, 12.7e-3, "ordinary"}};   // crossed cylinders
  for (const double ratio : {1.0, 1 + 0x1p-52, 1 + 1e-15, 1 + 1e-12, 1 + 1e-9, 1 + 1e-6, 1 + 1e-4,
                             1.001, 1.01, 1.1, 1.5, 2.0, 5.0, 10.0, 100.0, 1e3, 1e4}) {
    constexpr double radius = 0x1p-7;
    all.push_back({50, 107.9e9, radius, radius * ratio, "ordinary"});
    if (ratio > 1) all.push_back({50, 107.9e9, radius * ratio, radius, "ordinary"});
  }
  Sampler sampler(808);
  for (int i = 0; i < 24; ++i) {
    const double load = sampler.log_uniform(1e-3, 1e6), modulus = sampler.log_uniform(1e5, 1e12);
    const double radius = sampler.log_uniform(1e-4, 0.1);
    all.push_back({load, modulus, radius, radius * sampler.log_uniform(1e-2, 1e4), "ordinary"});
  }
  for (int i = 0; i < 12; ++i) {
    const double load = sampler.log_uniform(1e-60, 1e60),
                 modulus = sampler.log_uniform(1e-60, 1e60);
    const double radius = sampler.log_uniform(1e-60, 1e60);
    all.push_back({load, modulus, radius, radius * sampler.log_uniform(1e-30, 1e30), "far"});
  }
  for (const Numbers& x : steps({40, 1.1e11, 0.01, 0.03}, {250, 1.6e11, 0.025, 0.07}))
    all.push_back({x[0], x[1], x[2], x[3], "ordinary"});
  for (const Numbers& x : contacts_at_ends({40, 1.1e11, 0.01}, 2, 1e6))
    all.push_back({x[0], x[1], x[2], 3 * x[2], "end"});
  for (const Numbers& x :
       {Numbers{1e3, 10, 0.001 / next_to_end}, {40, 0.01, 100 * next_to_end}})  // R_y/R_x
    all.push_back({x[0], 1.1e11, x[1], x[2], "end"});
  for (const auto& [load, radius, other] : {std::array{1e-3, 1e-6, 4e-6}, {1e6, 1e3, 250.0}}) {
    all.push_back({load, 1.1e11, radius, other, "end"});
    all.push_back({load, 1.1e11, other, radius, "end"});
  }
  return all;
}

constexpr std::array ellipse_outputs{"semi_axis_x",   "semi_axis_y",   "ellipticity",
                                     "mean_pressure", "peak_pressure", "approach"};
using EllipseBalls = std::array<Ball, ellipse_outputs.size()>;

// The values in the order of ellipse_outputs.
EllipseBalls in_order(bool is_exchanged, const Ball& minor, const Ball& major, const Ball& k,
                      const Ball& mean, const Ball& approach) {
  return {is_exchanged ? major : minor,
          is_exchanged ? minor : major,
          is_exchanged ? 1 / k : k,
          mean,
          3 * mean / 2,
          approach};
}

// The sums of |d ln value/d ln input| over F, E*, R_x and R_y, with d/d ln α by a step of 2^-60.
EllipseBalls ellipse_conditions(bool is_exchanged, const Ball& alpha) {
  const Ball h = pow(Ball(2), Ball(-60));
  const auto at = [](const Ball& ratio) { return shape_by_newton(ratio); };
  const Associated here = at(alpha), there = at((alpha * (1 + h)).midpoint());
  const auto slope = [&](auto&& value) { return log(value(there) / value(here)) / log1p(h); };
  const Ball k = slope([](const Associated& s) { return s.k; });
  const Ball first = slope([](const Associated& s) { return s.b + s.d; });
  const Ball minor = slope([](const Associated& s) { return s.b / s.k; }) / 3;
  // Sums |exponents|. `radii` is that of both radii together, `ratio` that of the greater one.
  const auto sum = [](const Ball& force, const Ball& modulus, const Ball& radii,
                      const Ball& ratio) {
    const Ball all = force + modulus + abs(ratio) + abs(radii - ratio);
    return all < 1 ? Ball(1) : all;
  };
  const Ball third = fraction(1, 3);
  const Ball of_minor = sum(third, third, third, minor),
             of_major = sum(third, third, third, minor + k);
  const Ball of_pressure = sum(third, 2 * third, -2 * third, -2 * minor - k);
  return {is_exchanged ? of_major : of_minor,
          is_exchanged ? of_minor : of_major,
          sum(0, 0, 0, k),
          of_pressure,
          of_pressure,
          sum(2 * third, 2 * third, -third, first - minor - k)};
}

Table elliptical_contact_values() {
  Table table{
      {"hertz_ellipse",
       "alpha = R_y/R_x >= 1 (else x and y exchanged) = (k^2 E - K)/(K - E), integrals of "
       "parameter "
       "1 - 1/k^2; 1/R = 1/R_x + 1/R_y; a_x^3 = 3EFR/(pi k E*), a_y = k a_x; mean pressure "
       "F/(pi a_x a_y), peak 3/2 of it; approach a_x^2 K/(2RE)",
       "m, m, 1, Pa, Pa, m",
       "load [1e-3, 1e6] N, effective modulus [1e5, 1e12] Pa, radii [1e-6, 1e3] m, R_y/R_x [1e-4, "
       "1e4]; far: [1e-60, 1e60] each, R_y/R_x [1e-30, 1e30]",
       "k by bisection; K and E by arithmetic-geometric means; as defined",
       "k by Newton's method with a proof by signs on alpha = R_D(0, 1, 1/k^2)/R_D(0, 1/k^2, 1), "
       "Carlson's integrals; with B and D, of cos^2 and sin^2 over sqrt(1 - q sin^2), a_x^3 = "
       "3BFR_x/(pi k E*), a_y^3 = 3DFR_y/(pi E*), approach 3F(B + D)/(2 pi E* a_y)",
       "output,load,effective_modulus,radius_x,radius_y"},
      "x"};
  for (const EllipticalContact& one : elliptical_contacts())
    for (std::size_t i = 0; i < ellipse_outputs.size(); ++i)
      table.add([=] {
        const bool is_exchanged = one.radius_y < one.radius_x;
        const Ball smaller = std::min(one.radius_x, one.radius_y);
        const Ball greater = std::max(one.radius_x, one.radius_y);
        const Ball alpha = greater / smaller, load(one.load), modulus(one.modulus);
        const Ball third = fraction(1, 3), pi = ball_pi();

        const EllipseShape shape = shape_by_bisection(alpha);
        const Ball reduced = 1 / (1 / smaller + 1 / greater);
        const Ball minor = pow(3 * shape.second * load * reduced / (pi * shape.k * modulus), third);
        const EllipseBalls values = in_order(
            is_exchanged, minor, shape.k * minor, shape.k, load / (pi * shape.k * minor * minor),
            minor * minor * shape.first / (2 * reduced * shape.second));

        const Associated other = shape_by_newton(alpha);
        const Ball x = pow(3 * other.b * load * smaller / (pi * other.k * modulus), third);
        const Ball y = pow(3 * other.d * load * greater / (pi * modulus), third);
        const EllipseBalls others =
            in_order(is_exchanged, x, y, y / x, load / (pi * x * y),
                     3 * load * (other.b + other.d) / (2 * pi * modulus * y));
        return Row{{ellipse_outputs[i]},
                   {one.load, one.modulus, one.radius_x, one.radius_y},
                   values[i],
                   others[i],
                   ellipse_conditions(is_exchanged, alpha)[i],
                   one.region};
      });
  return table;
}

Table line_contact_values() {
  Table table{
      {"hertz_line",
       "b^2 = 4(F/L)R/(pi E*), mean pressure F/(2bL), peak 2F/(pi b L), greatest shear stress g - "
       "g^2/sqrt(1+g^2) of it, g^2 = (sqrt(5)-1)/2",
       "m, Pa, Pa, Pa",
       "load per length [1e-3, 1e8] N/m, effective modulus [1e5, 1e12] Pa, radius [1e-6, 10] m; "
       "far: [1e-90, 1e90] each",
       "square roots",
       "b by bisection on b^2; peak pressure as sqrt((F/L)E*/(pi R)), the mean as pi/4 of it; the "
       "depth of the greatest shear stress by bisection on the slope of z - z^2/sqrt(1+z^2)",
       "output,load_per_length,effective_modulus,reduced_radius"},
      "l"};
  Sampler sampler(909);
  std::vector<Numbers> contacts{{1e5, 107.9e9, 9.5e-3}};
  while (contacts.size() < 40) {
    const bool far = contacts.size() >= 30;
    const auto pick = [&](double low, double high) {
      return far ? sampler.log_uniform(1e-90, 1e90) : sampler.log_uniform(low, high);
    };
    const double f = pick(1e-3, 1e8), e = pick(1e5, 1e12);
    contacts.push_back({f, e, pick(1e-6, 10)});
  }
  for (const Numbers& x : steps({1e5, 1.1e11, 0.01}, {3e5, 1.6e11, 0.025})) contacts.push_back(x);
  const std::size_t first_end = contacts.size();
  for (const Numbers& x : contacts_at_ends({1e5, 1.1e11, 0.01}, 1, 1e8)) contacts.push_back(x);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      table.add([x = contacts[i], k,
                 region = i >= first_end      ? "end"
                          : i >= 30 && i < 40 ? "far"
                                              : "ordinary"] {
        const Ball load(x[0]), modulus(x[1]), radius(x[2]), pi = ball_pi();
        const Ball square = 4 * load * radius / (pi * modulus);
        const Ball width = sqrt(square), peak = 2 * load / (pi * width);
        const Ball found = zero_between([&](const Ball& y) { return y * y - square; },
                                        pow(Ball(10), Ball(-150)), pow(Ball(10), Ball(150)));
        const Ball other_peak = sqrt(load * modulus / (pi * radius));
        const auto shear = [](const Ball& z) { return z - z * z / sqrt(1 + z * z); };
        const Ball depth = sqrt((sqrt(Ball(5)) - 1) / 2);
        const Ball other_depth = zero_between(
            [&](const Ball& z) {
              const Ball s = 1 + z * z;
              return (2 * z + z * z * z) / (s * sqrt(s)) - 1;
            },
            fraction(1, 2), Ball(1));
        const Ball values[] = {width, load / (2 * width), peak, shear(depth) * peak};
        const Ball others[] = {found, pi * other_peak / 4, other_peak,
                               shear(other_depth) * other_peak};
        constexpr const char* names[] = {"half_width", "mean_pressure", "peak_pressure",
                                         "peak_shear"};
        return Row{{names[k]}, x, values[k], others[k], fraction(3, 2), region};
      });
  return table;
}

}  // namespace

std::vector<Table> hertz_contacts() {
  return {circular_contact_values(), elliptical_contact_values(), line_contact_values()};
}

}  // namespace tribo::reference
