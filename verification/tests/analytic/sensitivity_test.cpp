// SPDX-License-Identifier: Apache-2.0
// Slopes and exponents by automatic differentiation in 50 digits, against closed forms derived on
// paper: of the film in the speed, of h₀ in every input, and of the onset speed in every input.
#include <gtest/gtest.h>

#include "support/autodiff.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/onset.hpp"

namespace tribo::verification {
namespace {

using enum StarvationClosure;

// d ln λ/d ln u with all else constant (model/README.md, section 6).
Reference film_slope(const LoadSharing<Reference>& sharing, const LoadShares<Reference>& at) {
  const Reference hardening =
      -at.asperity * sharing.asperity_share_slope(at.film_parameter) / at.fluid;  // −λA′/(1−A)
  const FilmLaw& film = sharing.film();
  return ratio<Reference>(film.speed_exponent) /
         (1 + ratio<Reference>(film.sharing_exponent) * hardening);
}

// The error of 50 digits. Near the floor it grows by 1/(1 − A), because `sharing_residual` cancels.
constexpr double rounding = 1e-48;

TEST(Sensitivity, StarvationSlopeIsTheDerivativeOfTheRatio) {
  Sampler sampler(82);
  for (const auto closure : starvation_closures)
    for (int i = 0; i < 25; ++i) {
      const Reference r = closure == flooded_inlet ? sampler.uniform(1e-3, 1 - 1e-3)
                                                   : sampler.log_uniform(1e-4, 1e6);
      const Reference gamma = sampler.uniform(0.5, 6);
      const Dual y = starvation_ratio(closure, variable(r), Dual(gamma));
      // the slope of y in ln r cancels where the inlet is flooded and y = 1
      const Reference condition = 1 / abs(log_slope(y, r));
      EXPECT_TRUE(is_close(log_slope(y, r), InletLaw<Reference>{closure, gamma}.slope(r), rounding,
                           {{"closure", static_cast<double>(closure)},
                            {"r", static_cast<double>(r)},
                            {"gamma", static_cast<double>(gamma)}},
                           std::max(1.0, static_cast<double>(condition))));
    }
}

// d ln h*/d ln u = s + e·d ln y/d ln r with e = d ln r/d ln u: s at constant h_oil, 1 + s at
// constant flow. The derivative of the whole model is compared with slopes of its parts.
TEST(Sensitivity, StarvedFilmSlopeIsThatOfFilmAndInlet) {
  Sampler sampler(83);
  int compared = 0;
  while (compared < 65) {
    const Scene scene = random_scene(sampler);
    const Reference u = scene.speeds[0];
    const MixedContact<Reference> contact(scene);
    const FloodedFilm<Reference> film = contact.flooded(u);
    const InletState<Reference> inlet = contact.inlet(film);
    if (inlet.collapsed || film.shares.fluid < 1e-9 || film.shares.asperity < 1e-100) continue;
    ++compared;
    const Reference s = film_slope(contact.sharing(), film.shares);
    const Reference r_slope = contact.supply() == SupplyKind::inlet_flow ? Reference(1 + s) : s;
    const Reference expected =
        contact.supply() == SupplyKind::flooded
            ? s
            : Reference(s + r_slope * contact.inlet_law().slope(inlet.flooded_over_inlet));
    const std::initializer_list<Input> inputs{
        {"u", scene.speeds[0]},
        {"supply", static_cast<double>(scene.supply.kind)},
        {"closure", static_cast<double>(scene.closures.starvation)}};
    // s + e·slope may cancel
    const double condition = static_cast<double>(1 / (film.shares.fluid * abs(expected)));
    EXPECT_TRUE(
        is_close(film_log_slope(scene, u), expected, rounding, inputs, std::max(1.0, condition)));
    // The model as its users call it. Newton's loop may end one step early, and the derivative that
    // it gives is then no better than the square root of ε.
    EXPECT_TRUE(is_close(log_slope(MixedContact<Dual>(scene).solve(variable(u)).film, u), expected,
                         1e-22, inputs, std::max(1.0, condition)));
  }
}

// Exponents, derived by hand.
//   film  ∂ln h₀/∂ln x · 1000: h₀ ~ R U^0.67 G^0.53 W^−0.067 with U = ηu/(2E*R), G = 2αE*,
//         W = F/(2E*R²). So E* has −0.67 + 0.53 + 0.067, and R has 1 − 0.67 + 2·0.067
//   tripp, williamson  ∂ln K/∂ln x · 6: K ~ n²β^{3/2}σ_s^{5/2} and nβ^{1/2}σ_s^{3/2}, both times
//         E*A_nom/F with A_nom ~ (FR/E*)^{2/3}
//   separation  ∂ln h/∂ln x at an onset, where h_ff = r h_oil
enum class Variable : std::size_t {
  viscosity,
  pressure_viscosity,
  load,
  modulus,
  radius,
  inlet_film,
  summit_density,
  summit_radius,
  summit_height_sd,
};
struct Exponents {
  const char* name;
  int film;
  int tripp, williamson;
  int separation;
};
constexpr std::array exponents{
    Exponents{"viscosity", 670, 0, 0, 0},       Exponents{"pressure_viscosity", 530, 0, 0, 0},
    Exponents{"load", -67, -2, -2, 0},          Exponents{"effective_modulus", -73, 2, 2, 0},
    Exponents{"reduced_radius", 464, 4, 4, 0},  Exponents{"inlet_film", 0, 0, 0, 1},
    Exponents{"summit_density", 0, 12, 6, 0},   Exponents{"summit_radius", 0, 9, 3, 0},
    Exponents{"summit_height_sd", 0, 15, 9, 0},
};

// The variables of a scene, in that order; h_oil in m.
using Variables = std::array<Dual, exponents.size()>;
Variables variables_of(const Scene& scene) {
  const Reference sd = scene.surface.summit_height_sd;
  return {
      Dual(scene.lubricant.viscosity),
      Dual(scene.lubricant.pressure_viscosity),
      Dual(scene.load),
      Dual(scene.bodies.effective_modulus),
      Dual(detail::numbers_of<double>(scene).radius_x),
      Dual(scene.supply.kind == SupplyKind::inlet_film_ratio ? Reference(scene.supply.value * sd)
                                                             : Reference(scene.supply.value)),
      Dual(scene.surface.summit_density),
      Dual(scene.surface.summit_radius),
      Dual(sd)};
}
const Dual& at(const Variables& variables, Variable v) {
  return variables[static_cast<std::size_t>(v)];
}

Dual film_at(const Dual& speed, const Variables& v, const Dual& ellipticity) {
  return hamrock_dowson_central(speed, at(v, Variable::viscosity),
                                at(v, Variable::pressure_viscosity), at(v, Variable::load),
                                at(v, Variable::modulus), at(v, Variable::radius), ellipticity);
}

// ∂ln h₀/∂ln k = 0.61·0.73k e^{−0.73k}/(1 − 0.61 e^{−0.73k})
Reference ellipticity_exponent(const Reference& k) {
  const Reference decay = Reference("0.61") * exp(Reference("-0.73") * k);
  return decay * Reference("0.73") * k / (1 - decay);
}

TEST(Sensitivity, FilmHasTheDerivedExponentOfEachInput) {
  Sampler sampler(84);
  for (int i = 0; i < 10; ++i) {
    const Scene scene = random_scene(sampler);
    const Dual speed(scene.speeds[0]), k(sampler.uniform(0.5, 4));
    const Variables base = variables_of(scene);
    for (std::size_t j = 0; j < exponents.size(); ++j) {
      Variables moved = base;
      moved[j] = variable(value(base[j]));
      EXPECT_TRUE(is_close(log_slope(film_at(speed, moved, k), value(base[j])),
                           Reference(exponents[j].film) / 1000, rounding, {}))
          << exponents[j].name;
    }
    EXPECT_TRUE(is_close(log_slope(film_at(variable(value(speed)), base, k), value(speed)),
                         Reference("0.67"), rounding, {}));
    EXPECT_TRUE(is_close(log_slope(film_at(speed, base, variable(value(k))), value(k)),
                         ellipticity_exponent(value(k)), rounding, {}));
  }
}

// The r = h_ff/h_oil of a criterion, a constant of the closure.
double onset_ratio(OnsetCriterion criterion, StarvationClosure closure) {
  const InletLaw<double> law{closure, 3};
  return criterion == OnsetCriterion::film_maximum ? law.at_film_maximum()
                                                   : law.at_departure(default_departure);
}

// The chain of closed forms that leads to the onset speed at constant h_oil (model/README.md,
// section 9), written out here because `onset` takes its scene in double.
Dual onset_speed(const Scene& scene, const Variables& v, const Dual& ellipticity, double r) {
  const auto hertz =
      hertz_point(at(v, Variable::load), at(v, Variable::modulus), at(v, Variable::radius));
  const Dual& sd = at(v, Variable::summit_height_sd);
  const Dual offset(Reference(scene.surface.summit_plane_offset) * scene.surface.offset_planes);
  const auto contact = asperity_contact(
      scene.closures.asperity, at(v, Variable::summit_density), at(v, Variable::summit_radius), sd,
      offset, at(v, Variable::modulus), hertz.nominal_area, at(v, Variable::load));
  const LoadSharing<Dual> sharing(contact.model, contact.stiffness, contact.offset);
  const Dual lambda = Dual(r) * at(v, Variable::inlet_film) / sd;
  const auto fluid = Dual(1) - sharing.asperity_share(lambda);
  const Dual film = sd * sharing.flooded_film_parameter(lambda, fluid);
  return pow(Dual(film / film_at(Dual(1), v, ellipticity)), ratio<Dual>(100, 67));
}

// With a = d ln A/d ln λ and q of A = (K F_p)^q,
//   0.67 ∂ln u/∂ln x = ∂ln h − ∂ln h₀ − 0.14 A/(1−A) (q ∂ln K + a ∂ln λ).
// K and λ do not depend on η₀, α and k, and h₀ depends on u by the product η₀u. So with asperities
// or without, the exponent of η₀ is exactly −1, and that of α is −0.53/0.67.
TEST(Sensitivity, OnsetSpeedHasTheDerivedExponentOfEachInput) {
  Sampler sampler(85);
  for (const auto model : asperity_models)
    for (const auto criterion : {OnsetCriterion::film_maximum, OnsetCriterion::film_departure})
      for (const bool asperities : {false, true})
        for (const auto closure : starvation_closures) {
          if (criterion == OnsetCriterion::film_maximum && closure != flooded_inlet &&
              closure != printed_exponents)
            continue;  // no maximum at constant h_oil
          Scene scene =
              starved_scene(PaperSurface::medium, closure, SupplyKind::inlet_film_ratio, model);
          scene.bodies.ellipticity = sampler.uniform(0.5, 4);
          scene.supply.value = sampler.uniform(3.5, 5);
          if (!asperities) scene.surface.summit_density = 1e-30;
          const double r = onset_ratio(criterion, closure);
          const Variables base = variables_of(scene);
          const Dual k(scene.bodies.ellipticity);
          const Dual speed = onset_speed(scene, base, k, r);
          const Onset<double> found =
              onset(MixedContact<double>(scene), scene, criterion, default_departure);
          EXPECT_TRUE(is_close(found.speed, value(speed), 1e-13, {{"r", r}}));

          const MixedContact<Reference> contact(scene);
          const Reference lambda = r * Reference(scene.supply.value);
          const Reference share = contact.sharing().asperity_share(lambda);
          const Reference weight = Reference("0.14") * share / (1 - share);
          if (asperities) {
            EXPECT_GT(weight, Reference("1e-3"));
          } else {
            EXPECT_LT(weight, Reference("1e-30"));
          }
          for (std::size_t j = 0; j < exponents.size(); ++j) {
            Variables moved = base;
            moved[j] = variable(value(base[j]));
            const Exponents& e = exponents[j];
            const int stiffness = model == AsperityModel::greenwood_tripp ? e.tripp : e.williamson;
            const int lambda_exponent =
                static_cast<Variable>(j) == Variable::summit_height_sd ? -1 : e.separation;
            const Reference share_slope =
                sharing_exponent<Reference>(model) * stiffness / 6 +
                contact.sharing().asperity_share_slope(lambda) * lambda_exponent;
            const Reference expected =
                (e.separation - Reference(e.film) / 1000 - weight * share_slope) * 100 / 67;
            const Reference got = log_slope(onset_speed(scene, moved, k, r), value(base[j]));
            // 1 − A loses digits where A is near 1. Without asperities the summits' exponents are
            // nearly 0.
            const Reference condition = 1 + abs(weight * share_slope) / (1 - share);
            EXPECT_LT(abs(got - expected), Reference(rounding) * condition)
                << e.name << " got " << got << " expected " << expected << " condition "
                << condition;
          }
          EXPECT_TRUE(is_close(log_slope(onset_speed(scene, base, variable(value(k)), r), value(k)),
                               Reference(-ellipticity_exponent(value(k)) * 100 / 67), rounding,
                               {}));
        }
}

// `onset` itself in double: if x grows by a factor f, u grows by f to the exponent. At constant
// flow h_oil = q/u, and without asperities u^{0.67+1} ~ q/(h₀/u^0.67). 1e-13 is the contract of an
// onset speed, and two speeds are compared.
TEST(Sensitivity, OnsetItselfFollowsThePowerLaws) {
  Sampler sampler(86);
  const std::array<double* (*)(Scene&), 6> inputs{
      [](Scene& s) { return &s.lubricant.viscosity; },
      [](Scene& s) { return &s.lubricant.pressure_viscosity; },
      [](Scene& s) { return &s.load; },
      [](Scene& s) { return &s.bodies.effective_modulus; },
      [](Scene& s) { return &s.bodies.reduced_radius; },
      [](Scene& s) { return &s.supply.value; }};
  const auto speed = [](const Scene& scene, OnsetCriterion criterion) {
    return onset(MixedContact<double>(scene), scene, criterion, default_departure).speed;
  };
  for (const auto criterion : {OnsetCriterion::film_maximum, OnsetCriterion::film_departure})
    for (const auto supply : {SupplyKind::inlet_film, SupplyKind::inlet_flow})
      for (const auto closure : starvation_closures) {
        const Scene scene = starved_scene(PaperSurface::medium, closure, supply);
        const double unstretched = speed(scene, criterion);
        if (unstretched == 0) continue;  // the closure has no such onset
        for (const bool asperities : {false, true})
          for (std::size_t j = 0; j < inputs.size(); ++j) {
            // with asperities only η₀ and α, at constant h_oil
            if (asperities && (j > 1 || supply == SupplyKind::inlet_flow)) continue;
            Scene base = scene;
            if (!asperities) base.surface.summit_density = 1e-30;
            Scene stretched = base;
            const double factor = sampler.log_uniform(0.3, 3);
            *inputs[j](stretched) *= factor;
            const double exponent = (exponents[j].separation - exponents[j].film / 1000.0) /
                                    (supply == SupplyKind::inlet_flow ? 1.67 : 0.67);
            EXPECT_TRUE(is_close(
                speed(stretched, criterion) / speed(base, criterion),
                pow(Reference(*inputs[j](stretched) / *inputs[j](base)), Reference(exponent)),
                2e-13, {{"factor", factor}, {"closure", static_cast<double>(closure)}}))
                << exponents[j].name << ' ' << name(criterion) << " asperities " << asperities;
          }
      }
}

}  // namespace
}  // namespace tribo::verification
