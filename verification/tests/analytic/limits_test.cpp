// SPDX-License-Identifier: Apache-2.0
// Limits that are known formulas (smooth film, Hertz' single contact), independence of the units,
// and continuity where the code changes from one form to another.
#include <gtest/gtest.h>

#include <functional>

#include "support/condition.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/onset.hpp"

namespace tribo::verification {
namespace {

using enum StarvationClosure;

constexpr double ulp = 0x1p-52;

// ---- smooth surfaces

// A flooded surface with the paper's nβσ_s and summit heights of standard deviation `sd`.
Scene smoother_scene(AsperityModel model, double sd) {
  Scene scene = paper_scene(PaperSurface::smooth, model);
  scene.supply = {};
  scene.surface.summit_height_sd = sd;
  scene.surface.summit_density = 0.05 / (scene.surface.summit_radius * sd);
  return scene;
}

// h/h₀ = (1−A)^−0.14, and A falls with λ = h/σ_s faster than any power.
TEST(SmoothLimit, FilmIsThatOfSmoothFacesToTheLastBit) {
  for (const auto model : asperity_models)
    for (const double sd : {3e-10, 1e-10, 1e-20, 1e-100, 1e-250}) {
      const Scene scene = smoother_scene(model, sd);
      const MixedContact<double> contact(scene);
      for (const double u : {0.1, 3.0}) {
        const OperatingPoint<double> p = contact.solve(u);
        const std::initializer_list<Input> inputs{{"sd", sd}, {"u", u}};
        EXPECT_EQ(p.film_parameter, contact.flooded_film_parameter(u)) << describe(inputs);
        EXPECT_EQ(p.film, p.film_flooded);
        EXPECT_EQ(p.separation, p.film);
        EXPECT_EQ(p.asperity_load_share, 0);
        EXPECT_EQ(p.fluid_load_share, 1);
        EXPECT_EQ(p.real_area_ratio, 0);
        EXPECT_EQ(p.summit_count, 0);
        const Reference h0 = hamrock_dowson_central(
            Reference(u), Reference(scene.lubricant.viscosity),
            Reference(scene.lubricant.pressure_viscosity), Reference(scene.load),
            Reference(scene.bodies.effective_modulus), Reference(scene.bodies.reduced_radius),
            Reference(scene.bodies.ellipticity));
        const Conditions condition = conditions_at(scene, u);
        EXPECT_TRUE(keeps(operating_point_contract, p.film, h0, condition[1], 1, inputs));
        // The film is sheared on all of Hertz' area, under the mean pressure.
        const HertzPoint<Reference> hertz =
            hertz_point(Reference(scene.load), Reference(scene.bodies.effective_modulus),
                        Reference(scene.bodies.reduced_radius));
        const Reference tau0 = *scene.lubricant.eyring_stress;
        const Reference eta =
            Reference(scene.lubricant.viscosity) *
            exp(Reference(scene.lubricant.pressure_viscosity) * hertz.mean_pressure);
        const Reference friction =
            tau0 * asinh(eta * Reference(u) / (h0 * tau0)) * hertz.nominal_area / scene.load;
        EXPECT_TRUE(keeps(operating_point_contract, p.friction, friction, condition[8], 1, inputs));
      }
    }
}

// Before this limit 1 ≤ h/h₀ = (1−A)^−0.14. A ≤ (K F_p(0) e^{−(λ₀−δ)²/2})^q, because e^{−td} ≤ 1 in
// F_p(d), and λ ≥ λ₀.
TEST(SmoothLimit, FilmFallsToThatOfSmoothFacesUnderAProvenBound) {
  for (const auto model : asperity_models) {
    double previous = 2;
    for (double sd = 1e-7; sd > 2e-9; sd *= 0.8) {
      const MixedContact<double> contact(smoother_scene(model, sd));
      const double u = 1;
      const double thicker = contact.solve(u).film_parameter / contact.flooded_film_parameter(u);
      const double d = contact.flooded_film_parameter(u) - contact.sharing().offset();
      EXPECT_GE(thicker, 1) << describe({{"sd", sd}});
      EXPECT_LE(thicker, previous * (1 + 16 * ulp)) << describe({{"sd", sd}});
      previous = thicker;
      if (d < 0) continue;
      const double share =
          std::pow(contact.sharing().stiffness() * gaussian_moment(load_order(model), 0.0) *
                       std::exp(-d * d / 2),
                   sharing_exponent<double>(model));
      if (share >= 1) continue;
      EXPECT_LE(thicker, std::pow(1 - share, -0.14) * (1 + 16 * ulp)) << describe({{"sd", sd}});
    }
  }
}

// The other end is u → 0 without a floor: A → A(0) < 1, h/h₀ → (1−A(0))^−0.14. A is convex, so h/h₀
// is at most 0.14 (1−A(0))^−1.14 |A′(0)| λ below that limit.
TEST(SmoothLimit, ThinnestFilmsAreThickenedByTheSharesAtContact) {
  for (const auto model : asperity_models) {
    Scene scene = paper_scene(PaperSurface::smooth, model);
    scene.supply = {};
    scene.surface.summit_density /= model == AsperityModel::greenwood_tripp ? 1 : 2;
    const MixedContact<double> contact(scene);
    const LoadSharing<double>& sharing = contact.sharing();
    ASSERT_FALSE(sharing.has_floor());
    const double share = sharing.asperity_share(0);
    EXPECT_GT(share, 0.1);
    const double limit = std::pow(1 - share, -0.14);
    const double tiny = 1e-100;  // |A′(0)| from d ln A/d ln λ at a λ that is nearly 0
    const double slope = -share * sharing.asperity_share_slope(tiny) / tiny;
    for (const double u : {1e-5, 1e-10, 1e-30, 1e-200}) {
      const LoadShares<double> at = contact.flooded(u).shares;
      const double thicker = at.film_parameter / contact.flooded_film_parameter(u);
      EXPECT_TRUE(is_within(thicker, limit,
                            0.14 * std::pow(1 - share, -1.14) * slope * at.film_parameter +
                                32 * ulp * limit / (1 - share)));
      EXPECT_LE(thicker, limit * (1 + 32 * ulp / (1 - share)));
    }
  }
}

// ---- one summit

// Summits of nearly the same height, pressed by w = Dσ_s: each is Hertz' contact. With Z normal,
// F_n(−D)/Dⁿ = E[(1+x)₊ⁿ] at x = Z/D. The remainder of Taylor's cubic of (1+x)ⁿ at 0 has the sign
// of the fourth derivative, which is monotone. So the remainder is at most x⁴ times its size at x =
// −1: 1/16 for n = 3/2 (positive) and n = 5/2 (negative). With E x² = 1/D², E x⁴ = 3/D⁴,
//   F_{3/2}: 3/(8D²) to 3/(8D²) + 3/(16D⁴),  F_{5/2}: 15/(8D²) − 3/(16D⁴) to 15/(8D²),
// and F_1(−D) = D + F_1(D). The part at x < −1 weighs less than e^{−D²/2}.
struct Excess {
  double low, high;
};
void expect_excess(double got_over_hertz, const Excess& excess, double depth) {
  // Rounding of the moment, of the prefactor (asperity_contact.hpp), and of this test's products.
  const double rounding = (gaussian_moment_contract.ulp + 10 + 5) * ulp;
  const double tail = std::exp(-depth * depth / 2);
  EXPECT_TRUE(is_within(got_over_hertz - 1, (excess.low + excess.high) / 2,
                        (excess.high - excess.low) / 2 + tail + rounding))
      << describe({{"D", depth}});
}

TEST(SingleSummit, CarriesHertzLoadOnHertzArea) {
  const double density = 7e10, radius = 1.3e-5, modulus = 9e10, load = 30, area = 7e-8;
  const double w = 2e-7;
  // One pressed summit, and one pair of summits within the lateral offset x² ≤ 4βw. Averaged over
  // x², the load (4/3)E*√(β/2)(w − x²/4β)^{3/2} is 2/5 of its greatest value, and the area πβ(w −
  // x²/4β)/2 is 1/2 of its greatest.
  const double one_load = 4.0 / 3 * modulus * std::sqrt(radius) * w * std::sqrt(w);
  const double one_area = M_PI * radius * w;
  const double pairs = density * density * area * M_PI * 4 * radius * w;
  const double pair_load = 0.4 * 4.0 / 3 * modulus * std::sqrt(radius / 2) * w * std::sqrt(w);
  const double pair_area = 0.5 * M_PI * radius / 2 * w;
  for (const double depth : {3.0, 6.0, 9.0, 30.0, 1e3, 1e5, 1e8}) {
    const double sd = w / depth, square = depth * depth;
    const auto contact = [&](AsperityModel model) {
      return asperity_contact(model, density, radius, sd, depth, modulus, area, load);
    };
    // λ = 0 and δ = D: the mean of the summits lies w above the plane
    const auto single = contact(AsperityModel::greenwood_williamson);
    const double summits = density * area;
    expect_excess(
        moment_product(single.stiffness, Order::three_halves, -depth) * load / (summits * one_load),
        {3 / (8 * square), 3 / (8 * square) + 3 / (16 * square * square)}, depth);
    expect_excess(real_area_ratio(single, 0.0) * area / (summits * one_area), {0, 0}, depth);
    expect_excess(summit_count(single, 0.0) / summits, {0, 0}, depth);
    const auto pair = contact(AsperityModel::greenwood_tripp);
    expect_excess(
        moment_product(pair.stiffness, Order::five_halves, -depth) * load / (pairs * pair_load),
        {15 / (8 * square) - 3 / (16 * square * square), 15 / (8 * square)}, depth);
    // F_2(−D) = D² + 1 less a tail
    expect_excess(real_area_ratio(pair, 0.0) * area / (pairs * pair_area), {1 / square, 1 / square},
                  depth);
    expect_excess(summit_count(pair, 0.0) / pairs, {0, 0}, depth);
  }
}

// ---- units

// New units of length, mass and time: the factors by which the numbers grow in them.
struct Units {
  explicit Units(Sampler& sampler)
      : m(sampler.log_uniform(0.01, 100)),
        kg(sampler.log_uniform(0.01, 100)),
        s(sampler.log_uniform(0.01, 100)) {}
  double m, kg, s;
  double newton = kg * m / (s * s), pascal = newton / (m * m);

  Scene of(Scene scene) const {
    scene.load *= newton;
    for (double* u : {&scene.speeds.from, &scene.speeds.to}) *u *= m / s;
    for (double& u : scene.speeds.list) u *= m / s;
    scene.surface.summit_density /= m * m;
    scene.surface.summit_radius *= m;
    scene.surface.summit_height_sd *= m;
    scene.bodies.effective_modulus *= pascal;
    for (double* length : {&scene.bodies.reduced_radius, &scene.bodies.radius_x,
                           &scene.bodies.radius_y, &scene.bodies.length})
      *length *= m;
    scene.lubricant.viscosity *= pascal * s;
    scene.lubricant.pressure_viscosity /= pascal;
    *scene.lubricant.eyring_stress *= pascal;
    if (scene.supply.kind == SupplyKind::inlet_film) scene.supply.value *= m;
    if (scene.supply.kind == SupplyKind::inlet_flow) scene.supply.value *= m * m / s;
    return scene;
  }
};

// ln(η/η₀) after Roelands in any units, from the two constants that have a unit: p_R and the
// viscosity e^−9.67 Pa·s to which all oils tend.
double roelands(double viscosity, double pressure_viscosity, double pressure,
                double roelands_pascals, double roelands_viscosity) {
  const double scale = std::log(viscosity / roelands_viscosity);
  const double z = pressure_viscosity * roelands_pascals / scale;
  return scale * (std::pow(1 + pressure / roelands_pascals, z) - 1);
}

// Friction under Roelands' law by the model in SI, against friction in other units. There the
// shares and the area are the model's; this law, the shear laws and the sum of friction are written
// out. A density in place of a viscosity, or a constant left in SI, would be noticed.
TEST(Units, FrictionUnderRoelandsLawDoesNotDependOnThem) {
  Sampler sampler(72);
  for (int i = 0; i < 500; ++i) {
    Scene scene = random_scene(sampler);
    scene.friction.viscosity = ViscosityLaw::roelands;
    const Units units(sampler);
    const double u = scene.speeds[0];
    const OperatingPoint<double> here = MixedContact<double>(scene).solve(u);
    if (here.regime == Regime::collapsed) continue;
    Scene moved = units.of(scene);
    moved.friction.viscosity = ViscosityLaw::ambient;
    const MixedContact<double> contact(moved);
    const OperatingPoint<double> there = contact.solve(moved.speeds[0]);
    const double mean = contact.hertz().mean_pressure;
    const double viscosity = moved.lubricant.viscosity;
    const double log_ratio =
        roelands(viscosity, moved.lubricant.pressure_viscosity, there.fluid_load_share * mean,
                 0.196e9 * units.pascal, std::exp(-9.67) * units.pascal * units.s);
    const double tau0 = *moved.lubricant.eyring_stress;
    const double x = viscosity * std::exp(log_ratio) * moved.friction.slide_roll_ratio *
                     moved.speeds[0] / there.separation / tau0;
    const double tau =
        scene.friction.fluid == FluidShear::eyring ? tau0 * std::asinh(x) : tau0 * -std::expm1(-x);
    const double friction = *scene.friction.boundary_coefficient * there.asperity_load_share +
                            tau * std::max(0.0, 1 - there.real_area_ratio) / mean;
    EXPECT_TRUE(keeps(operating_point_contract, friction, here.friction, conditions_at(scene, u)[8],
                      2, {{"m", units.m}, {"kg", units.kg}, {"s", units.s}, {"u", u}},
                      64 * ulp * (1 + log_ratio)));
  }
}

// The summit density in place of the viscosity in eqs 1.19 and 1.32, or the reverse, fails here.
// Roelands' constants have units, so his law is in the test above.
TEST(Units, DimensionlessOutputsDoNotDependOnThem) {
  Sampler sampler(63);
  for (int i = 0; i < 200; ++i) {
    Scene scene = random_scene(sampler);
    if (scene.friction.viscosity == ViscosityLaw::roelands)
      scene.friction.viscosity = ViscosityLaw::barus;
    const Scene moved = Units(sampler).of(scene);
    const double u = scene.speeds[0];
    const auto here = numbers_of(MixedContact<double>(scene).solve(u));
    const auto there = numbers_of(MixedContact<double>(moved).solve(moved.speeds[0]));
    const Conditions condition = conditions_at(scene, u);
    for (auto k = static_cast<std::size_t>(Output::film_parameter); k < number_count; ++k) {
      EXPECT_EQ(std::isnan(here[k]), std::isnan(there[k]));  // NaN where it has collapsed
      if (!(here[k] >= 1e-290)) continue;
      // The inputs in other units are rounded once more.
      EXPECT_TRUE(keeps(operating_point_contract, there[k], here[k], condition[k], 2, {}))
          << output_infos[k].name << describe_scene(scene);
    }
  }
}

TEST(Units, PartsScaleWithTheirDimension) {
  Sampler sampler(73);
  for (int i = 0; i < 200; ++i) {
    const Scene scene = random_scene(sampler);
    const Units units(sampler);
    const Scene moved = units.of(scene);
    const MixedContact<double> here(scene), there(moved);
    const auto same = [&](double got, double expected, const char* what) {
      EXPECT_TRUE(
          is_close(got, expected, 64 * ulp, {{"m", units.m}, {"kg", units.kg}, {"s", units.s}}))
          << what;
    };
    same(there.hertz().semi_axis_x, here.hertz().semi_axis_x * units.m, "a");
    same(there.hertz().nominal_area, here.hertz().nominal_area * units.m * units.m, "A_nom");
    same(there.hertz().peak_pressure, here.hertz().peak_pressure * units.pascal, "peak pressure");
    if (scene.bodies.shape() != ContactShape::line)
      same(there.hertz().approach, here.hertz().approach * units.m, "approach");
    same(there.asperities().stiffness, here.asperities().stiffness, "K");
    same(there.asperities().area_factor, here.asperities().area_factor, "area");
    same(there.asperities().count_factor, here.asperities().count_factor, "count");
    same(there.flooded_film_parameter(moved.speeds[0]),
         here.flooded_film_parameter(scene.speeds[0]), "h0/sd");
    if (scene.supply.kind != SupplyKind::flooded)
      same(there.inlet_film_parameter(moved.speeds[0]), here.inlet_film_parameter(scene.speeds[0]),
           "h_oil/sd");
    const double x = sampler.log_uniform(1e-3, 30), thickening = sampler.uniform(0, 20);
    const double film = here.hertz().semi_axis_x, speed = x * film;
    same(fluid_shear_stress(scene.friction.fluid, *moved.lubricant.eyring_stress,
                            moved.lubricant.viscosity, thickening, speed * units.m / units.s,
                            film * units.m),
         fluid_shear_stress(scene.friction.fluid, *scene.lubricant.eyring_stress,
                            scene.lubricant.viscosity, thickening, speed, film) *
             units.pascal,
         "tau");
  }
}

TEST(Units, OnsetsScaleAsSpeedsAndFilms) {
  Sampler sampler(74);
  for (const auto model : asperity_models)
    for (const auto closure : starvation_closures)
      for (const auto kind :
           {SupplyKind::inlet_film, SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow}) {
        const Scene scene = starved_scene(PaperSurface::medium, closure, kind, model);
        const Units units(sampler);
        const Scene moved = units.of(scene);
        for (const auto criterion : {OnsetCriterion::film_maximum, OnsetCriterion::film_departure,
                                     OnsetCriterion::asperity_minimum}) {
          const auto found = [&](const Scene& s) {
            return onset(MixedContact<double>(s), s, criterion, default_departure);
          };
          const Onset<double> here = found(scene), there = found(moved);
          EXPECT_EQ(there.exists, here.exists) << name(criterion);
          if (!here.exists) continue;
          EXPECT_TRUE(is_close(there.speed, here.speed * units.m / units.s, 2e-13, {}))
              << name(criterion);
          EXPECT_TRUE(is_close(there.film, here.film * units.m, 2e-13, {})) << name(criterion);
        }
      }
}

// ---- continuity

// A surface with a floor behind an inlet film of h_oil = `inlet_film` σ_s.
Scene scene_with_floor(AsperityModel model, StarvationClosure closure, double inlet_film) {
  Scene scene = starved_scene(PaperSurface::rough, closure, SupplyKind::inlet_film_ratio, model);
  scene.surface.offset_planes = 2;
  scene.supply.value = inlet_film;
  return scene;
}

// Two neighbouring doubles.
struct Edge {
  double below, above;
};
Edge edge_at(double x) { return {std::nextafter(x, -INFINITY), x}; }

// The neighbouring doubles between which a predicate changes; it changes between low and high.
template <class Predicate>
Edge edge_of(double low, double high, Predicate&& predicate) {
  const bool at_low = predicate(low);
  EXPECT_NE(at_low, predicate(high)) << "no edge" << describe({{"low", low}, {"high", high}});
  while (std::nextafter(low, high) != high) {
    double middle =
        low > 0 && high > 4 * low ? std::sqrt(low) * std::sqrt(high) : low / 2 + high / 2;
    if (middle == low || middle == high) middle = std::nextafter(low, high);
    (predicate(middle) == at_low ? low : high) = middle;
  }
  return {low, high};
}

// The values of f at both neighbours differ by at most the error that each may have plus the change
// of the exact function between the neighbours, condition × ε.
template <class Function>
void expect_no_step(const char* where, const Edge& edge, const Contract& contract,
                    Function&& function, double condition = 1) {
  EXPECT_TRUE(keeps(contract, function(edge.below), function(edge.above), condition, 2,
                    {{"below", edge.below}, {"above", edge.above}, {"condition", condition}},
                    condition * ulp))
      << where;
}

// Starvation.KeepsItsContractOnBothSidesOfEachBranch checks the values on both sides of r = 1.
TEST(Continuity, StarvedFilmsHaveNoStepAtAnyBranch) {
  for (const auto closure : {starved_inlet, printed_exponents}) {
    const InletCurve<double> curve{closure};
    // ψ so small that arctan v = v: below it no step refines ψ
    const double least = std::numeric_limits<double>::min_exponent / 4.0;
    const Edge lengths = edge_at(least);
    const Contract logarithm{20, 0};  // starvation.hpp
    expect_no_step("ln y", lengths, logarithm, [&](double t) { return curve.log_film_ratio(t); });
    expect_no_step("ln 1/r", lengths, logarithm, [&](double t) { return curve.log_inverse_r(t); });
    const double r = std::exp(-curve.log_inverse_r(least));
    const Edge ratios = edge_of(
        r / 2, 2 * r, [&](double x) { return curve.log_inverse_r(least) + std::log(x) < 0; });
    // without the refining step the error of t is ε × |t| there
    const double slope = std::abs(InletLaw<double>{closure, 3}.slope(r));
    expect_no_step(
        "y", ratios, starvation_ratio_contract,
        [&](double x) { return starvation_ratio(closure, x, 3.0); }, slope);
  }
  // The two terms of 1/r change places; for printed_exponents one term is always the greater.
  for (const auto closure : {flooded_inlet, starved_inlet}) {
    const InletCurve<double> curve{closure};
    const Edge terms = edge_of(-20, 20, [&](double t) {
      const double log_y = curve.log_film_ratio(t);
      return curve.log_crook_term(t, log_y) > (closure == flooded_inlet ? 0 : log_y);
    });
    for (const bool slope : {false, true})
      expect_no_step(
          "ln 1/r", terms, {20, 0},
          [&](double t) {
            return slope ? curve.slope_of_log_inverse_r(t) : curve.log_inverse_r(t);
          },
          std::max(1.0, std::abs(terms.below)));
  }
  expect_no_step("d ln y/d ln psi",
                 edge_of(1e-40, 1e-20,
                         [](double psi) {
                           const double v = wolveridge_factor<double>() * psi;
                           return v > epsilon<double>() * epsilon<double>();
                         }),
                 starvation_ratio_contract, [](double psi) { return wolveridge_slope(psi); });
}

TEST(Continuity, LoadSharingHasNoStepAtAnyBranch) {
  for (const auto model : asperity_models)
    for (const double stiffness : {3.0, 50.0})
      for (const double offset : {0.0, 1.146}) {
        const LoadSharing<double> sharing(model, stiffness, offset);
        const auto film = [&](double lambda0) { return sharing.solve(lambda0).film_parameter; };
        const auto at_root = [&](const char* where, const Edge& edge) {
          expect_no_step(where, edge, load_sharing_contract, film,
                         root_condition(model, stiffness, offset, edge.above));
        };
        ASSERT_TRUE(sharing.has_floor());
        const double floor = sharing.floor();
        at_root("lambda0 = floor", edge_at(floor));
        at_root("lambda0 = lambda/2", edge_of(floor / 100, floor, [&](double lambda0) {
                  return (lambda0 - film(lambda0)) / film(lambda0) > -0.5;
                }));
        // A is computed from w, or from the moments
        const Edge half = edge_of(floor / 2, 2 * floor + 10, [&](double lambda0) {
          return sharing.solve(lambda0).fluid < 0.5;
        });
        at_root("w = 1/2", half);
        const double w_condition = 1 + root_condition(model, stiffness, offset, half.above) / 0.14;
        expect_no_step(
            "A at w = 1/2", half, load_sharing_contract,
            [&](double lambda0) { return sharing.solve(lambda0).asperity; }, w_condition);
        // 1 − A is by a Taylor series or a difference; 45 ulp are 1e-14, as in load_sharing_test
        const Edge series = edge_of(1e-6, 10, [&](double distance) {
          return sharing.shares_above_floor(distance).asperity < 0.75;
        });
        const double condition =
            1 - sharing.asperity_share_slope(floor + series.above) * 3;  // A/(1−A)
        expect_no_step(
            "1 - A at A = 3/4", series, {45, 45},
            [&](double x) { return sharing.shares_above_floor(x).fluid; }, condition);
        expect_no_step(
            "A at A = 3/4", series, {45, 45},
            [&](double x) { return sharing.shares_above_floor(x).asperity; }, condition);
        // the inverse by the series: the distance at which w is nearly 1/4
        const double quarter = std::nextafter(0.25, 0.0);
        const double distance = sharing.distance_above_floor(quarter);
        EXPECT_TRUE(is_close(1 - sharing.asperity_share(floor + distance), quarter, 90 * ulp,
                             {{"K", stiffness}, {"delta", offset}}, condition));
      }
}

// K at which a floor appears, A(0) = 1, and at which Newton's start changes, K F_p(0) = 1.
TEST(Continuity, RootsHaveNoStepWhereAFloorAppears) {
  for (const auto model : asperity_models)
    for (const double offset : {0.0, 1.146}) {
      const Edge appears = edge_of(1e-3, 1e3, [&](double stiffness) {
        return LoadSharing<double>(model, stiffness, offset).has_floor();
      });
      EXPECT_EQ(LoadSharing<double>(model, appears.below, offset).floor(), 0);
      // λ_b = (ln A(0))/|d ln A/dλ| comes from the rounding of A(0) alone
      EXPECT_LE(LoadSharing<double>(model, appears.above, offset).floor(),
                2 * gaussian_moment_contract.ulp * ulp);
      const Edge start = edge_of(1e-3, 1e3, [&](double stiffness) {
        return std::log(stiffness) + log_gaussian_moment(load_order(model), 0.0) > 0;
      });
      for (const double lambda0 : {1e-12, 1e-3, 0.3, 2.0})
        for (const Edge& edge : {appears, start})
          expect_no_step(
              "lambda", edge, load_sharing_contract,
              [&](double stiffness) {
                return LoadSharing<double>(model, stiffness, offset).solve(lambda0).film_parameter;
              },
              root_condition(model, edge.above, offset, lambda0));
      if (offset > 0)
        expect_no_step(
            "floor at delta", start, load_sharing_contract,
            [&](double stiffness) { return LoadSharing<double>(model, stiffness, offset).floor(); },
            2 + 1 / offset);
    }
}

// All outputs of a scene at neighbouring speeds.
void expect_no_step_of_outputs(const char* where, const Scene& scene, const Edge& speeds) {
  const MixedContact<double> contact(scene);
  const auto below = numbers_of(contact.solve(speeds.below));
  const auto above = numbers_of(contact.solve(speeds.above));
  const Conditions condition = conditions_at(scene, speeds.above);
  const Conditions other = conditions_at(scene, speeds.below);
  for (std::size_t k = 0; k < number_count; ++k) {
    const double worst = std::max(condition[k], other[k]);
    if (above[k] == 0 || below[k] == 0) {
      // a share that vanishes may change by the rounding of the other share
      EXPECT_LE(std::abs(below[k] - above[k]), 64 * ulp * worst)
          << where << ' ' << output_infos[k].name;
      continue;
    }
    EXPECT_TRUE(keeps(operating_point_contract, below[k], above[k], worst, 2,
                      {{"u below", speeds.below}, {"u above", speeds.above}}, worst * ulp))
        << where << ' ' << output_infos[k].name;
  }
}

TEST(Continuity, OperatingPointsHaveNoStepAtAnyBranch) {
  for (const auto model : asperity_models)
    for (const auto closure : starvation_closures) {
      const Scene scene = scene_with_floor(model, closure, 60);
      const MixedContact<double> contact(scene);
      ASSERT_TRUE(contact.sharing().has_floor());
      // the distance above the floor is computed from the flooded share, or as a difference
      expect_no_step_of_outputs("w = 1/4", scene, edge_of(1e-4, 3, [&](double u) {
                                  return contact.flooded(u).shares.fluid < 0.25;
                                }));
      // at r = 1, and at 0.95 of the flooded film, only the inlet's word changes
      if (closure != flooded_inlet)
        expect_no_step_of_outputs("r = 1", scene, edge_of(1e-4, 1e5, [&](double u) {
                                    return contact.inlet(contact.flooded(u)).flooded_over_inlet < 1;
                                  }));
      expect_no_step_of_outputs("y = 0.95", scene, edge_of(1e-4, 1e5, [&](double u) {
                                  return contact.inlet(contact.flooded(u)).film_ratio >= 0.95;
                                }));
    }
}

// λ* falls to the floor: the asperities take the rest of the load.
TEST(Continuity, OutputsHaveNoStepWhereTheStarvedFilmMeetsTheFloor) {
  for (const auto model : asperity_models)
    for (const auto closure : {flooded_inlet, printed_exponents}) {
      const Scene scene = scene_with_floor(model, closure, 12);
      const MixedContact<double> contact(scene);
      const double floor = contact.sharing().floor();
      const double top =
          onset(contact, scene, OnsetCriterion::film_maximum, default_departure).speed;
      const Edge edge =
          edge_of(top, 1e4 * top, [&](double u) { return contact.solve(u).fluid_load_share > 0; });
      const auto before = contact.solve(edge.below), after = contact.solve(edge.above);
      EXPECT_EQ(after.asperity_load_share, 1);
      EXPECT_EQ(after.separation, floor * contact.summit_height_sd());
      // 1 − A = |A′| (λ* − λ_b); u is known to one ulp, and λ* to its condition
      const Conditions condition = conditions_at(scene, edge.above);
      const double lambda_error =
          (2 * std::max(8.0, 16 * condition[3]) + condition[3]) * ulp * floor;
      const double rate = contact.sharing().surface().hazard;
      EXPECT_LE(before.fluid_load_share, rate * lambda_error);
      for (const Output output :
           {Output::film, Output::separation, Output::real_area_ratio, Output::summit_count}) {
        const auto k = static_cast<std::size_t>(output);
        const double worst = std::max(condition[k], condition[3]);
        EXPECT_TRUE(keeps(operating_point_contract, numbers_of(before)[k], numbers_of(after)[k],
                          worst, 2, {{"u", edge.above}}, worst * ulp))
            << info(output).name;
      }
      // μ_b A + τA_H/F: τ hardly changes, and A changes by the bound above
      EXPECT_TRUE(is_close(before.friction, after.friction,
                           (rate * lambda_error + 64 * ulp) * (1 + 30 / after.friction),
                           {{"u", edge.above}}));
    }
}

// At r = 1 the flooded inlet's film is gone, and without a floor the faces touch: λ* → 0 as
// (1−r)^{2/3}, A → A(0) by |A′(0)|λ*. From there on nothing balances the load.
TEST(Continuity, SharesHaveNoStepWhereTheInletCollapses) {
  for (const auto model : asperity_models) {
    const Scene scene = paper_scene(PaperSurface::smooth, model);
    const MixedContact<double> contact(scene);
    ASSERT_FALSE(contact.sharing().has_floor());
    const Edge edge =
        edge_of(1e-3, 100, [&](double u) { return contact.solve(u).inlet == Inlet::collapsed; });
    const auto before = contact.solve(edge.below), after = contact.solve(edge.above);
    EXPECT_EQ(after.film, 0);
    EXPECT_GT(before.film, 0);
    // r is known to its contract, and 1 − r to the same number of ulp of r
    const double gap = 64 * ulp * conditions_at(scene, 0.9 * edge.below)[0];
    const double lambda = 4 * 5.4 / M_PI * std::pow(gap * 0.53033008588991064, 2.0 / 3);
    EXPECT_LE(before.film_parameter, lambda);
    EXPECT_EQ(after.regime, Regime::collapsed);
    const double at_contact = contact.sharing().asperity_share(0);
    EXPECT_LE(before.asperity_load_share, at_contact);
    const double tiny = 1e-100;
    const double slope = -contact.sharing().asperity_share_slope(tiny) / tiny;
    EXPECT_TRUE(is_close(before.asperity_load_share, at_contact, slope * lambda + 64 * ulp,
                         {{"u", edge.above}}));
  }
}

// Where the real area fills the nominal one, no area is left for the film to shear: A_H → 0.
TEST(Continuity, FrictionHasNoStepWhereTheRealAreaFillsTheNominalOne) {
  Scene scene = paper_scene(PaperSurface::rough, AsperityModel::greenwood_williamson);
  scene.supply = {};
  scene.surface.summit_density *= 8;
  scene.surface.summit_plane_offset = 3;
  scene.bodies.effective_modulus = 1e7;  // soft: much area under little share
  const MixedContact<double> contact(scene);
  const Edge edge =
      edge_of(1e-9, 1e3, [&](double u) { return contact.solve(u).real_area_ratio < 1; });
  expect_no_step_of_outputs("A_r = A_nom", scene, edge);
}

// The walk's branches: next to the floor, differences of G near it, and the series of 1 − A.
TEST(Continuity, WalkHasNoStepAtAnyBranch) {
  for (const auto model : asperity_models)
    for (const auto closure : starvation_closures) {
      const MixedContact<long double> contact(scene_with_floor(model, closure, 12));
      const StribeckWalk<long double> walk(contact);
      const auto walk_at = [&](double place) { return walk.at(static_cast<long double>(place)); };
      std::vector<Edge> edges{edge_at(-1), {0, 0x1p-1074}, {-0x1p-1074, 0}};
      // at the fluid shares ε/4, below which the film counts as on the floor, and 1/4
      for (const long double share : {epsilon<long double>() / 4, 0.25L}) {
        const Edge edge =
            edge_of(-200, 5, [&](double s) { return walk_at(s).flooded.shares.fluid < share; });
        // the code compares ln w and A, so that the place is off by some ulp
        edges.push_back({edge.below - 1e-13, edge.above + 1e-13});
      }
      for (const Edge& edge : edges) {
        const WalkPoint<long double> below = walk_at(edge.below), above = walk_at(edge.above);
        ASSERT_GT(above.rate, 0) << "the bound below would be infinite";
        // Coordinates near −40 are logarithms: one ulp of them is 32 ε of the number itself. A
        // change of ln u by 1/`rate` for each unit of s is no step.
        const double bound =
            2 * (16 + std::abs(edge.above)) * 16 * ulp +
            10 * std::abs(edge.above - edge.below) * (1 + 1 / static_cast<double>(above.rate));
        const auto numbers = [](const WalkPoint<long double>& p) {
          const auto input = [](std::string_view name, long double value) {
            return Input{name, static_cast<double>(value)};
          };
          return std::array{
              input("u", p.flooded.speed),        input("lambda", p.flooded.shares.film_parameter),
              input("w", p.flooded.shares.fluid), input("y", p.inlet.film_ratio),
              input("slope", p.film_slope),       input("rate", p.rate)};
        };
        for (std::size_t i = 0; i < numbers(above).size(); ++i)
          EXPECT_TRUE(is_close(numbers(below)[i].value, numbers(above)[i].value, bound,
                               {{"s", edge.above}}))
              << numbers(above)[i].name << " closure " << static_cast<int>(closure);
      }
    }
}

// As h_oil falls, the film maximum comes down to the floor and ends there: its film tends to the
// floor's, its speed to 0.
TEST(Continuity, OnsetEndsOnTheFloor) {
  for (const auto model : asperity_models)
    for (const auto closure : {flooded_inlet, printed_exponents}) {
      const auto at = [&](double inlet_film) {
        const Scene scene = scene_with_floor(model, closure, inlet_film);
        return onset(MixedContact<double>(scene), scene, OnsetCriterion::film_maximum,
                     default_departure);
      };
      const Edge edge = edge_of(0.01, 100, [&](double h) { return at(h).exists; });
      const MixedContact<double> contact(scene_with_floor(model, closure, edge.above));
      const double floor = contact.sharing().floor();
      const InletLaw<double> law{closure, 3};
      const double r = law.at_film_maximum();
      const Onset<double> last = at(edge.above);
      EXPECT_TRUE(is_close(last.film_parameter, Reference(floor) * Reference(law.film_ratio(r)),
                           64 * ulp, {{"h_oil", edge.above}}));
      EXPECT_GT(last.speed, 0);
      // 1 − A is at most the rounding of λ; u is proportional to (1 − A)^{0.14/0.67}
      const double fluid = contact.sharing().surface().hazard * 8 * ulp * floor;
      EXPECT_LE(last.speed, contact.speed_at(contact.sharing().flooded_film_parameter(
                                floor * (1 + 8 * ulp), fluid)));
    }
}

}  // namespace
}  // namespace tribo::verification
