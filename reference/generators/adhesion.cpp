// SPDX-License-Identifier: Apache-2.0
// Smooth bodies that adhere, and the shear stress below a contact.

#include "generators/sampler.hpp"
#include "generators/table.hpp"
#include "generators/zeros.hpp"

namespace tribo::reference {
namespace {

// Inputs: F, w, E* and R. The first way takes the formula of a^3. The second way takes a root of
// F = 4E*a^3/(3R) - sqrt(8 pi w E* a^3), which follows from the balance of energy.
Ball jkr_radius(const Balls& x) {
  const Ball adhesive = 3 * ball_pi() * x[1] * x[3];
  const Ball bracket = x[0] + adhesive + sqrt(2 * adhesive * x[0] + adhesive * adhesive);
  return pow(3 * x[3] / (4 * x[2]) * bracket, fraction(1, 3));
}
Ball jkr_radius_by_force(const Balls& x) {
  const auto force = [&](const Ball& root) {  // root = sqrt(a^3)
    return 4 * x[2] * root * root / (3 * x[3]) - sqrt(8 * ball_pi() * x[1] * x[2]) * root - x[0];
  };
  // The force is least at the pull-off, and rises with the radius beyond it.
  const Ball least = sqrt(8 * ball_pi() * x[1] * x[2]) * 3 * x[3] / (8 * x[2]);
  const Ball root = zero_between(force, least, least * pow(Ball(10), Ball(40)));
  return exp(fraction(2, 3) * log(root));
}

Table jkr_radii() {
  Table table{
      {"jkr_radius", "a^3 = 3R/(4E*) (F + 3 pi w R + sqrt(6 pi w R F + (3 pi w R)^2))", "m",
       "F/(pi w R) in [-1.4, 1e5], w [1e-3, 1] J/m2, E* [1e5, 1e12] Pa, R [1e-8, 1] m; end: "
       "w [1e-4, 10] J/m2, R [1e-9, 10] m, F/(pi w R) [-1.5, 1e6]; far: from -1.5 (1 - "
       "1e-9), to 1e30",
       "the root of the cubic", "bisection on the force at a radius",
       "load,work_of_adhesion,effective_modulus,reduced_radius"},
      "aj"};
  const auto add = [&table](const Numbers& x, const char* region) {
    table.add({}, x, jkr_radius, jkr_radius_by_force, region);
  };
  constexpr double pi = 3.14159265358979323846;
  Sampler sampler(1540);
  for (int i = 0; i < 60; ++i) {
    const bool usual = i < 48;
    const double work = sampler.log_uniform(1e-3, 1), modulus = sampler.log_uniform(1e5, 1e12);
    const double radius = sampler.log_uniform(1e-8, 1);
    const double relative = i % 3 == 0 ? -1.5 * (usual ? sampler.uniform(0.01, 0.93)
                                                       : 1 - sampler.log_uniform(1e-9, 0.1))
                            : usual    ? sampler.log_uniform(1e-3, 1e5)
                                       : sampler.log_uniform(1e-30, 1e30);
    add({relative * pi * work * radius, work, modulus, radius}, usual ? "ordinary" : "far");
  }
  add({0, 0.05, 1e9, 0.01}, "ordinary");
  for (const Numbers& x : steps({1e-3, 0.05, 1e6, 0.01}, {4e-3, 0.09, 3e6, 0.025}))
    add(x, "ordinary");
  for (const Numbers& x : {Numbers{-10, 5, 1e9, 1},
                           {1e6, 5, 1e11, 1},
                           {1e-9, 1e-4, 1e9, 1e-5},
                           {1e-2, 10, 1e9, 1e-3},
                           {1e-3, 0.05, 1e5, 0.01},
                           {1e-3, 0.05, 1e12, 0.01},
                           {1e-9, 0.05, 1e9, 1e-9},
                           {1, 0.05, 1e9, 10},
                           {-1.5 * next_to_end * pi * 0.05 * 0.01, 0.05, 1e6, 0.01},
                           {1e6 * next_to_end * pi * 0.05 * 0.01, 0.05, 1e9, 0.01}})
    add(x, "end");
  return table;
}

Table pull_off_forces() {
  Table table{{"pull_off_force", "jkr 3/2 pi w R, dmt 2 pi w R", "N",
               "w [1e-4, 10] J/m2, R [1e-9, 10] m; far: [1e-90, 1e90] each", "the product",
               "logarithms", "adhesion,work_of_adhesion,reduced_radius"},
              "ap"};
  const auto add = [&table](bool is_jkr, const Numbers& x, const char* region) {
    table.add(
        {is_jkr ? "jkr" : "dmt"}, x,
        [=](const Balls& y) {
          return ball_pi() * y[0] * y[1] * (is_jkr ? fraction(3, 2) : Ball(2));
        },
        [=](const Balls& y) {
          const Ball product = exp(log(y[0]) + log(y[1]));
          return is_jkr ? 3 * product * ball_pi() / 2 : product * (ball_pi() + ball_pi());
        },
        region);
  };
  Sampler sampler(1541);
  for (const bool is_jkr : {true, false})
    for (int i = 0; i < 20; ++i) {
      const bool usual = i < 15;
      const double work = usual ? sampler.log_uniform(1e-4, 10) : sampler.log_uniform(1e-90, 1e90);
      const double radius =
          usual ? sampler.log_uniform(1e-9, 10) : sampler.log_uniform(1e-90, 1e90);
      add(is_jkr, {work, radius}, usual ? "ordinary" : "far");
    }
  // The second theory takes the steps backwards, so that it begins where the first one ends.
  const Numbers one{0.05, 0.01}, other{0.08, 0.03};
  for (const Numbers& x : steps(one, other)) add(true, x, "ordinary");
  for (const Numbers& x : steps(other, one)) add(false, x, "ordinary");
  for (const bool is_jkr : {true, false})
    for (const Numbers& x : at_ends(one, {{0, 1e-4, 10}, {1, 1e-9, 10}})) add(is_jkr, x, "end");
  return table;
}

// Inputs: p0, a, z and nu. The first way takes an arctangent, the second way an arccosine.
Ball shear(const Balls& x) {
  const Ball zeta = x[2] / x[1], q = 1 / (1 + zeta * zeta);
  const Ball arc = zeta * (ball_pi() / 2 - atan(zeta));
  return x[0] / 2 * abs(fraction(3, 2) * q - (1 + x[3]) * (1 - arc));
}
Ball shear_by_stresses(const Balls& x) {
  const Ball square = x[1] * x[1] + x[2] * x[2], axial = -x[0] * x[1] * x[1] / square;
  const Ball angle = acos(x[2] / sqrt(square));
  const Ball radial = -axial / 2 - x[0] * (1 + x[3]) * (x[1] - x[2] * angle) / x[1];
  return abs(axial - radial) / 2;
}

Table shear_stresses() {
  Table table{
      {"subsurface_shear",
       "p0/2 |3q/2 - (1 + nu)(1 - zeta atan(1/zeta))|, zeta = z/a, q = 1/(1 + zeta^2)", "Pa",
       "p0 [1e6, 5e9] Pa, a [1e-6, 1e-2] m, z/a 0 or [1e-3, 5], nu [0, 0.49]; end: p0 [1e4, "
       "2e10] Pa, a [1e-8, 0.1] m, z/a to 10; far: z/a [1e-9, 1e6], nu [-0.9, 0.5]",
       "an arc of a tangent", "both stresses, with an arc of a cosine",
       "peak_pressure,radius,depth,poisson_ratio"},
      "as"};
  const auto add = [&table](const Numbers& x, const char* region) {
    table.add({}, x, shear, shear_by_stresses, region);
  };
  Sampler sampler(1542);
  for (int i = 0; i < 60; ++i) {
    const bool usual = i < 45;
    const double pressure = sampler.log_uniform(1e6, 5e9), radius = sampler.log_uniform(1e-6, 1e-2);
    const double relative = usual ? sampler.log_uniform(1e-3, 5) : sampler.log_uniform(1e-9, 1e6);
    const double depth = i % 9 == 4 ? 0 : radius * relative;
    const double nu = i % 5 == 0 ? 0.3
                      : usual    ? sampler.uniform(0, 0.49)
                                 : sampler.uniform(-0.9, 0.5);
    add({pressure, radius, depth, nu}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({1e9, 1e-4, 5e-5, 0.3}, {2e9, 3e-4, 1e-4, 0.25}))
    add(x, "ordinary");
  for (const Numbers& x : {Numbers{1e4, 1e-4, 5e-5, 0.3},
                           {2e10, 1e-4, 5e-5, 0.3},
                           {1e9, 1e-8, 5e-9, 0.3},
                           {1e9, 0.1, 0.05, 0.3},
                           {1e9, 1e-4, 0, 0.3},
                           {1e9, 0.1, 1, 0.3},
                           {1e9, 1e-4, 5e-5, 0},
                           {1e9, 1e-4, 5e-5, 0.5},
                           {1e9, 1e-4, next_to_end * 1e-3, 0.3}})
    add(x, "end");
  return table;
}

}  // namespace

std::vector<Table> adhesion() { return {jkr_radii(), pull_off_forces(), shear_stresses()}; }

}  // namespace tribo::reference
