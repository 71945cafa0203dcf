// SPDX-License-Identifier: Apache-2.0
// A whole operating point in ball arithmetic, formulas written out (model/README.md, sections 3 to
// 8).
#pragma once

#include <array>

#include "generators/ellipse_shape.hpp"
#include "generators/film_laws.hpp"
#include "generators/load_sharing_root.hpp"
#include "generators/starved_film.hpp"

namespace tribo::reference {

enum class Supply { flooded, inlet_film, inlet_film_ratio, inlet_flow };
enum class Shear { eyring, limiting };
enum class Viscosity { barus, ambient, roelands };
enum class Shape { circle, ellipse, line };

// The numbers of a scene; each is an input of the condition numbers.
struct Inputs {
  enum : std::size_t {
    load,
    speed,
    density,
    radius,
    sd,
    offset,
    modulus,
    radius_x,  // R for a circle
    across,    // k of the film's constant for a circle, R_y for an ellipse, the length for a line
    viscosity,
    pressure_viscosity,
    eyring_stress,
    supply,
    boundary,
    slide_roll,
    inlet_exponent,
    count
  };
  std::array<Ball, count> value;
  int planes = 1;
  Rough rough = Rough::tripp;
  Inlet inlet = Inlet::flooded_inlet;
  Supply supply_kind = Supply::flooded;
  Shear shear = Shear::eyring;
  Viscosity law = Viscosity::barus;
  Shape shape = Shape::circle;
  std::size_t film = 0;  // the place of its law in `laws`
};

// Hertz' results: A_nom, and k of the film's constant.
struct SmoothContact {
  Ball area, ellipticity;
};

// Hertz' ellipse: k ≥ 1, and the second elliptic integral.
struct EllipseAxes {
  Ball k, second;
};
inline EllipseAxes axes_by_newton(const Ball& alpha) {
  const Associated shape = shape_by_newton(alpha);
  return {shape.k, shape.b + shape.d / (shape.k * shape.k)};
}
inline EllipseAxes axes_by_bisection(const Ball& alpha) {
  const EllipseShape shape = shape_by_bisection(alpha);
  return {shape.k, shape.second};
}

// How roots, moments, film ratios and ellipses are computed. The two ways differ in all of these,
// but both use the hypergeometric moments while they search for a root, because quadrature would
// take hours there. The table of moments compares the two kinds of moments.
struct Way {
  Moment moment;
  Ball (*root)(const RoughContact&, const Ball&);
  Ball (*film_ratio)(Inlet, const Ball&, const Ball&);
  EllipseAxes (*ellipse)(const Ball& alpha);
};
inline const Way first_way{moment_by_hypergeometric, root_by_newton, film_ratio_by_inlet_length,
                           axes_by_newton};
inline const Way second_way{moment_by_quadrature, root_by_bisection, film_ratio_by_bisection,
                            axes_by_bisection};

// film_flooded, film, separation, film_parameter, asperity share, fluid share, real area ratio,
// summit count, friction. Without a film and a floor nothing balances the load; both shares and
// friction are then not finite.
using Outputs = std::array<Ball, 9>;

inline Ball fluid_stress(const Inputs& in, const Ball& fluid_pressure, const Ball& separation) {
  const auto& v = in.value;
  Ball exponent(0);
  if (in.law == Viscosity::barus) exponent = v[Inputs::pressure_viscosity] * fluid_pressure;
  if (in.law == Viscosity::roelands) {
    const Ball scale = log(v[Inputs::viscosity]) + fraction(967, 100);
    const Ball reference_pressure(196000000);
    const Ball z = v[Inputs::pressure_viscosity] * reference_pressure / scale;
    exponent = scale * (pow(1 + fluid_pressure / reference_pressure, z) - 1);
  }
  const Ball& stress = v[Inputs::eyring_stress];
  const Ball x = v[Inputs::viscosity] * exp(exponent) * v[Inputs::slide_roll] * v[Inputs::speed] /
                 separation / stress;
  return in.shear == Shear::eyring ? stress * asinh(x) : -stress * expm1(-x);
}

inline SmoothContact smooth_contact(const Inputs& in, const Way& way) {
  const auto& v = in.value;
  const Ball &load = v[Inputs::load], &modulus = v[Inputs::modulus];
  const Ball &radius = v[Inputs::radius_x], &across = v[Inputs::across];
  if (in.shape == Shape::line) {
    const Ball width = sqrt(4 * load / across * radius / (ball_pi() * modulus));
    return {2 * width * across, Ball(1)};
  }
  const Ball third = fraction(1, 3);
  if (in.shape == Shape::circle) {
    const Ball a = pow(3 * load * radius / (4 * modulus), third);
    return {ball_pi() * a * a, across};
  }
  const bool is_exchanged = across < radius;
  const Ball &smaller = is_exchanged ? across : radius, &greater = is_exchanged ? radius : across;
  const EllipseAxes axes = way.ellipse(greater / smaller);
  const Ball reduced = smaller * greater / (smaller + greater);
  const Ball minor = pow(3 * axes.second * load * reduced / (ball_pi() * axes.k * modulus), third);
  return {ball_pi() * axes.k * minor * minor, is_exchanged ? 1 / axes.k : axes.k};
}

inline Ball flooded_film(const Inputs& in, const Ball& ellipticity) {
  const auto& v = in.value;
  const Law& law = laws[in.film];
  const Ball e2 = 2 * v[Inputs::modulus], &radius = v[Inputs::radius_x];
  const Ball& load_length = law.is_of_lines ? v[Inputs::across] : radius;
  const auto power = [&](const Ball& x, int p) { return pow(x, fraction(p, law.q)); };
  return radius * fraction(law.constant, 1000) *
         power(v[Inputs::viscosity] * v[Inputs::speed] / (e2 * radius), law.a) *
         power(v[Inputs::pressure_viscosity] * e2, law.b) *
         power(v[Inputs::load] / (e2 * radius * load_length), law.c) *
         (1 - fraction(law.m, 100) * exp(-fraction(law.n, 100) * ellipticity));
}

inline Outputs solve(const Inputs& in, const Way& way) {
  const auto& v = in.value;
  const Ball &load = v[Inputs::load], &modulus = v[Inputs::modulus], &sd = v[Inputs::sd];
  const auto [area, ellipticity] = smooth_contact(in, way);
  const Ball product = v[Inputs::density] * v[Inputs::radius] * sd;
  const Ball slope = sqrt(sd / v[Inputs::radius]);
  const bool tripp = in.rough == Rough::tripp;
  const Ball stiffness = (tripp ? 16 * sqrt(Ball(2)) * ball_pi() / 15 * product * product * slope
                                : fraction(4, 3) * product * slope) *
                         modulus * area / load;
  const Ball exponent = fraction(laws[in.film].a - laws[in.film].b, laws[in.film].q);
  const RoughContact contact{in.rough, stiffness, Ball(in.planes) * v[Inputs::offset],
                             moment_by_hypergeometric, exponent};
  const RoughContact measured{in.rough, stiffness, contact.offset, way.moment, exponent};
  const Ball h0 = flooded_film(in, ellipticity);
  const Ball lambda0 = h0 / sd;
  const Ball flooded = way.root(contact, lambda0);

  Ball y(1);
  if (in.supply_kind != Supply::flooded) {
    const Ball& given = v[Inputs::supply];
    const Ball inlet_parameter = in.supply_kind == Supply::inlet_film_ratio ? given
                                 : in.supply_kind == Supply::inlet_film
                                     ? given / sd
                                     : given / v[Inputs::speed] / sd;
    y = way.film_ratio(in.inlet, flooded / inlet_parameter, v[Inputs::inlet_exponent]);
  }
  const Ball lambda = flooded * y;
  // The separation is the floor only where the film is below it.
  Ball apart = lambda, share = measured.share(lambda);
  Ball fluid = in.supply_kind == Supply::flooded ? pow(lambda0 / flooded, 1 / exponent) : 1 - share;
  if (share >= 1) {
    const auto above = [&](const Ball& x) {
      const Ball s = contact.share(x);
      return s > 1 ? -1 : s < 1 ? 1 : 0;
    };
    const Ball low = lambda > 0 ? lambda.midpoint() : pow(Ball(10), Ball(-30));
    apart = bisect(above, low, upper_bound(contact, lambda0));
    share = 1;
    fluid = 0;
  }
  const Ball d = apart - contact.offset;
  Outputs out;
  out[0] = flooded * sd;
  out[1] = lambda * sd;
  out[2] = apart * sd;
  out[3] = lambda;
  out[4] = share;
  out[5] = fluid;
  out[6] = tripp ? ball_pi() * ball_pi() * product * product * way.moment(4, d)
                 : ball_pi() * product * way.moment(2, d);
  out[7] = tripp ? 4 * ball_pi() * product * v[Inputs::density] * area * way.moment(2, d)
                 : v[Inputs::density] * area * way.moment(0, d);
  const Ball free = 1 - out[6];
  out[8] = v[Inputs::boundary] * share;
  if (!(apart > 0)) {
    for (const std::size_t undefined : {std::size_t{4}, std::size_t{5}, std::size_t{8}})
      arb_indeterminate(out[undefined].get());
  } else if (free > 0) {
    out[8] += fluid_stress(in, fluid * load / area, out[2]) * area * free / load;
  }
  return out;
}

}  // namespace tribo::reference
