// SPDX-License-Identifier: Apache-2.0
// The effective modulus of two bodies, and the radii of the gap between their faces.
#include <algorithm>
#include <array>
#include <cstddef>

#include "generators/sampler.hpp"
#include "generators/table.hpp"

namespace tribo::reference {
namespace {

struct Material {
  double modulus, poisson_ratio;
};
constexpr Material steel{206e9, 0.3}, glass{72e9, 0.22}, sapphire{435e9, 0.29},
    silicon_nitride{310e9, 0.26}, bronze{110e9, 0.34}, cast_iron{120e9, 0.27},
    tungsten_carbide{630e9, 0.22}, nylon{2.8e9, 0.39}, polyethylene{0.8e9, 0.46}, rubber{3e6, 0.5},
    gelatin{1e5, 0.5}, cork{30e6, 0};

struct Pair {
  Material first, second;
  const char* region;
};

std::vector<Pair> pairs() {
  std::vector<Pair> all;
  for (const auto& [first, second] : {std::pair{steel, steel},
                                      {steel, glass},
                                      {glass, steel},
                                      {steel, sapphire},
                                      {steel, silicon_nitride},
                                      {silicon_nitride, silicon_nitride},
                                      {steel, bronze},
                                      {steel, cast_iron},
                                      {tungsten_carbide, steel},
                                      {steel, nylon},
                                      {steel, polyethylene},
                                      {steel, rubber},
                                      {rubber, glass},
                                      {rubber, rubber},
                                      {gelatin, glass},
                                      {cork, glass}})
    all.push_back({first, second, "ordinary"});
  Sampler sampler(606);
  const auto material = [&](double least, double greatest, double low, double high) {
    const double modulus = sampler.log_uniform(least, greatest);
    return Material{modulus, sampler.uniform(low, high)};
  };
  for (int i = 0; i < 24; ++i) {
    const Material first = material(1e5, 1e12, 0, 0.5);
    all.push_back({first, material(1e5, 1e12, 0, 0.5), "ordinary"});
  }
  for (int i = 0; i < 12; ++i) {
    const Material first = material(1e-250, 1e250, -1, 0.5);
    all.push_back({first, material(1e-250, 1e250, -1, 0.5), "far"});
  }
  // Poisson's ratio of one body, and of both, near −1.
  for (const double above : {0x1p-53, 0x1p-30, 1e-3, 0.25}) {
    all.push_back({{1e9, above - 1}, {1e9, 0.3}, "far"});
    all.push_back({{2e11, above - 1}, {3e8, above - 1}, "far"});
  }
  for (const Numbers& x : steps({206e9, 0.3, 72e9, 0.22}, {110e9, 0.34, 310e9, 0.26}))
    all.push_back({{x[0], x[1]}, {x[2], x[3]}, "ordinary"});
  for (const Numbers& x : at_ends({206e9, 0.3, 72e9, 0.22},
                                  {{0, 1e5, 1e12}, {1, 0, 0.5}, {2, 1e5, 1e12}, {3, 0, 0.5}}))
    all.push_back({{x[0], x[1]}, {x[2], x[3]}, "end"});
  return all;
}

Table effective_moduli() {
  Table table{
      {"effective_modulus", "1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2", "Pa",
       "moduli [1e5, 1e12] Pa, Poisson's ratios [0, 0.5]; end: 1e12 Pa, and each end alone; far: "
       "[1e-250, 1e250] Pa, "
       "(-1, 0.5]",
       "as it is defined", "by the shear moduli G = E/(2(1+nu)): 2 G1 G2/((1-nu1) G2 + (1-nu2) G1)",
       "first_modulus,first_poisson_ratio,second_modulus,second_poisson_ratio"},
      "e"};
  for (const Pair& pair : pairs())
    table.add([=] {
      const Ball modulus[] = {pair.first.modulus, pair.second.modulus};
      const Ball ratio[] = {pair.first.poisson_ratio, pair.second.poisson_ratio};
      const auto compliance = [&](int i) { return (1 - ratio[i] * ratio[i]) / modulus[i]; };
      const auto shear = [&](int i) { return modulus[i] / (2 * (1 + ratio[i])); };
      const Ball value = 1 / (compliance(0) + compliance(1));
      const Ball by_shear =
          2 * shear(0) * shear(1) / ((1 - ratio[0]) * shear(1) + (1 - ratio[1]) * shear(0));
      Ball condition = 1;  // both moduli's share
      for (const int i : {0, 1}) condition += value * 2 * ratio[i] * ratio[i] / modulus[i];
      return Row{{},
                 {pair.first.modulus, pair.first.poisson_ratio, pair.second.modulus,
                  pair.second.poisson_ratio},
                 value,
                 by_shear,
                 condition,
                 pair.region};
    });
  return table;
}

struct Faces {
  std::array<double, 4> radii;  // R₁x, R₂x, R₁y, R₂y, m
  const char* region;
};

std::vector<Faces> faces() {
  constexpr double flat = 1e30;
  std::vector<Faces> all;
  for (const std::array<double, 4>& radii :
       {std::array{9.5e-3, flat, 9.5e-3, flat},    // a ball on a flat
        {flat, 12.7e-3, flat, 12.7e-3},            // a flat on a ball
        {9.525e-3, 9.525e-3, 9.525e-3, 9.525e-3},  // two balls
        {10e-3, 25e-3, 10e-3, 25e-3},              // two balls of different sizes
        {12e-3, flat, flat, 20e-3},                // two rollers crossed at right angles
        {15e-3, flat, flat, 15e-3},                // two crossed rollers of the same size
        {10e-3, flat, 1.5, flat},                  // a crowned roller on a flat
        {10e-3, 30e-3, 2, flat},                   // a crowned roller on a cylinder
        {8e-3, 35e-3, 3, -6},                      // a crowned roller in a hollow ring
        {22e-3, 31e-3, 4, 5},                      // two crowned teeth of gears
        {18e-3, -60e-3, 4, 5},                     // two crowned teeth, one of an inner gear
        {5e-3, 22.5e-3, 5e-3, -5.2e-3},            // a ball on the inner ring of a bearing
        {5e-3, -32.5e-3, 5e-3, -5.3e-3},           // a ball on the outer ring of a bearing
        {-32.5e-3, 5e-3, -5.3e-3, 5e-3},           // the outer ring of a bearing on a ball
        {3.5e-3, 14e-3, 3.5e-3, -3.6e-3},          // a ball on the inner ring of a smaller bearing
        {4e-3, flat, 4e-3, -4.4e-3},               // a ball in a straight groove
        {flat, 6e-3, -6.6e-3, 6e-3},               // a straight groove on a ball
        {14e-3, -14.05e-3, 14e-3, -14.05e-3},      // a ball in the cup of an artificial hip
        {0.46, flat, -0.5, 0.3},                   // a worn wheel on the head of a rail
        {-20e-3, 4e-3, 7e-3, flat}})               // a ball-like tappet on a hollow cam
    all.push_back({radii, "ordinary"});
  Sampler sampler(707);
  for (int i = 0; i < 14; ++i) {
    std::array<double, 4> radii{};
    for (double& radius : radii) radius = sampler.log_uniform(1e-4, 1);
    if (i % 2 == 1) radii[3] = -radii[2] * sampler.uniform(1.02, 3);      // a groove
    if (i % 4 == 3) radii[0] = -radii[1] * sampler.log_uniform(1.1, 30);  // a ring around
    all.push_back({radii, "ordinary"});
  }
  // Faces that nearly conform, so that the curvatures cancel, and radii of any size.
  for (const double wider : {1 + 0x1p-52, 1 + 0x1p-40, 1 + 1e-8, 1 + 1e-4})
    all.push_back({{5e-3, -5e-3 * wider, -0.7 * wider, 0.7}, "far"});
  for (int i = 0; i < 8; ++i) {
    std::array<double, 4> radii{};
    for (double& radius : radii) radius = sampler.log_uniform(1e-250, 1e250);
    if (i % 2 == 1) *std::max_element(radii.begin(), radii.begin() + 2) *= -1;
    all.push_back({radii, "far"});
  }
  for (const Numbers& x : steps({10e-3, 25e-3, 12e-3, 40e-3}, {15e-3, 30e-3, 18e-3, 60e-3}))
    all.push_back({{x[0], x[1], x[2], x[3]}, "ordinary"});
  // The widest concave faces, and the ends of the radii of the gap, along x and across.
  const double around = 1 / (0.1 + 0.001 / next_to_end), small = 2e-6 / next_to_end;
  for (const std::array<double, 4>& radii : {std::array{-10.0, 5.0, 0.01, 0.02},
                                             {5.0, -10.0, 0.01, 0.02},
                                             {0.01, 0.02, -10.0, 5.0},
                                             {0.01, 0.02, 5.0, -10.0},
                                             {around, -10.0, 0.01, 0.02},
                                             {small, small, 0.01, 0.02},
                                             {0.01, 0.02, around, -10.0},
                                             {0.01, 0.02, small, small}})
    all.push_back({radii, "end"});
  return all;
}

Ball parallel(const Ball& a, const Ball& b) { return a * b / (a + b); }

Table reduced_radii() {
  Table table{
      {"reduced_radius", "1/R_x = 1/R1x + 1/R2x, 1/R_y = 1/R1y + 1/R2y, 1/R = 1/R_x + 1/R_y", "m",
       "radii above 0, or below 0 where the sum of the curvatures is above 0: "
       "[1e-4, 1] m or 1e30 m; end: -10 m; far: [1e-250, 1e250] m, sums down to 2^-52 of them",
       "inverse of the sum of inverses", "product over sum",
       "output,first_radius_x,second_radius_x,first_radius_y,second_radius_y"},
      "g"};
  for (const Faces& one : faces())
    for (int k = 0; k < 3; ++k)
      table.add([=] {
        constexpr const char* names[] = {"radius_x", "radius_y", "reduced_radius"};
        const auto& radii = one.radii;
        const std::size_t from = k == 1 ? 2 : 0, to = k == 0 ? 2 : 4;
        Ball curvature = 0, sizes = 0;
        for (std::size_t i = from; i < to; ++i) {
          curvature += 1 / Ball(radii[i]);
          sizes += 1 / abs(Ball(radii[i]));
        }
        const Ball x = parallel(radii[0], radii[1]), y = parallel(radii[2], radii[3]);
        return Row{{names[k]},        {radii.begin(), radii.end()},
                   1 / curvature,     k == 0 ? x : k == 1 ? y : parallel(x, y),
                   sizes / curvature, one.region};
      });
  return table;
}

}  // namespace

std::vector<Table> two_bodies() { return {effective_moduli(), reduced_radii()}; }

}  // namespace tribo::reference
