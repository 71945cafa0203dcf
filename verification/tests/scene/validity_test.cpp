// SPDX-License-Identifier: Apache-2.0
// Each limit of validity is passed just beyond its bound and not before it. The tests compute the
// bounds in another way than the model. Shipped scenes pass only limits that they accept.
#include "tribo/validity.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "../support/judge.hpp"
#include "../support/threshold.hpp"
#include "scene_text.hpp"
#include "sweep/plan_reader.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::scene_test {
namespace {

using std::numbers::pi;

Scene scene_of(const SceneText& text, SceneUse use = SceneUse::speeds) {
  SceneReading reading = read(Format::toml, text, use);
  for (const InputProblem& problem : reading.errors) ADD_FAILURE() << problem.line();
  return reading.scene.value_or(Scene{});
}

// The limit with this word. Its word is empty if the scene does not make the assumption.
Validity limit_of(const Scene& scene, std::string_view word, SceneUse use = SceneUse::speeds) {
  for (const Validity& one : validity_of(scene, use))
    if (one.word == word) return one;
  return {};
}

SceneText with(SceneText text, std::string_view path, double value) {
  return text.set(path, fmt::format("{}", value));
}

// A scene that passes no limit: a slow ball with a fine surface.
SceneText ordinary() {
  SceneText text = SceneText::good().remove_section("supply");
  text.set("friction.slide_roll_ratio", "1");
  text.set("surface.summit_density", "2e11").set("surface.summit_height_sd", "5e-9");
  return text.set("surface.summit_plane_offset", "0").set("surface.summit_radius", "5e-5");
}

TEST(Validity, OrdinaryScenesPassNothing) {
  EXPECT_EQ(words_passed(scene_of(ordinary())), std::vector<std::string_view>());
}

// The limits here are closed forms of one number of the scene.
TEST(Validity, EachLimitIsPassedJustBeyondItsBound) {
  using enum verification::True;
  // p₀³ = 6FE*²/(π³R²) of a circle.
  const double modulus = 107.9e9, radius = 9.5e-3, viscosity = 0.0202;
  const auto load_of = [&](double peak) {
    return std::pow(pi * peak, 3) * radius * radius / (6 * modulus * modulus);
  };
  const double peak = std::cbrt(6 * 50 * modulus * modulus / (radius * radius)) / pi;
  // z = α p_R/(ln η₀ + 9.67), p_R = 0.196 GPa.
  const double of_z = (std::log(viscosity) + 9.67) / 0.196e9;
  const SceneText ball = ordinary();
  const SceneText roelands = SceneText(ball).set("friction.viscosity", "\"roelands\"");
  struct Limit {
    std::string word;
    double limit;
    verification::True side;
    SceneText base;
    std::string path;
  };
  for (const Limit& one : std::initializer_list<Limit>{
           {"hertz_pressure", load_of(4e9), above, ball, "load"},
           {"alpha_p0", 30 / peak, above, ball, "lubricant.pressure_viscosity"},
           {"barus", load_of(1.5e9), above, ball, "load"},
           {"roelands_index", 1.2 * of_z, above, roelands, "lubricant.pressure_viscosity"},
           {"roelands_index", 0.2 * of_z, below, roelands, "lubricant.pressure_viscosity"},
           {"inlet_heating", std::sqrt(10 * 0.14 / viscosity), above, ball, "speed"}}) {
    const auto is_passed = [&one](double number) {
      return passes(with(one.base, one.path, number), one.word);
    };
    EXPECT_TRUE(
        verification::changes_at_its_limit({one.word, one.limit, one.side, is_passed, 1e-13}));
  }
}

TEST(Validity, AnyEllipticityButOneIsNoCircle) {
  for (const double k : {std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0)})
    EXPECT_EQ(passes(with(ordinary(), "bodies.ellipticity", k), "circular_hertz"), k != 1);
}

// The film and λ fall with the speed. Their limits are passed just below the speed at which the
// contact has the film of the limit.
TEST(Validity, FilmsAreJudgedAtTheSlowestSpeed) {
  using enum verification::True;
  for (const bool is_film : {false, true}) {
    const SceneText text = ordinary();
    const MixedContact<double> contact(scene_of(text));
    const double wanted = is_film ? 1e-9 : 0.5 * contact.summit_height_sd();
    double low = 1e-9, high = 1;
    while (high / low > 1 + 1e-14) {
      const double middle = std::sqrt(low * high);
      (contact.solve(middle).film < wanted ? low : high) = middle;
    }
    const auto is_passed = [&](double speed) {
      const SceneText range = SceneText(text).set("speed", fmt::format("[1, {}, 0.5]", speed));
      return passes(range, is_film ? "film_below_molecule" : "smooth_film_law");
    };
    EXPECT_TRUE(verification::changes_at_its_limit({"film", high, below, is_passed, 1e-12}));
  }
}

// The load of the summits over their area is (16√2/15π) E*√(σ/β) F_{5/2}/F_2 by Greenwood and
// Tripp, (4/3π) E*√(σ/β) F_{3/2}/F_1 by Greenwood and Williamson (model/README.md, section 4).
// Hertz' area and load cancel. As δ = λ, the moments are F_n(0) = 2^{n/2−1}Γ((n+1)/2)/√π.
TEST(Validity, SummitsPressOnEachOtherWithTheirLoadOverTheirArea) {
  const auto moment = [](double n) {
    return std::exp2(n / 2 - 1) * std::tgamma((n + 1) / 2) / std::sqrt(pi);
  };
  for (const bool is_of_both : {true, false}) {
    SceneText text = ordinary();
    text.set("surface.summit_height_sd", "1e-7").set("surface.summit_density", "5e10");
    text.set("surface.summit_radius", "1e-5");
    if (!is_of_both) text.set("closures.asperity", "\"greenwood_williamson\"");
    // The offset that the film itself has, by iteration: more offset, more film.
    double offset = 0;
    for (int i = 0; i < 200; ++i)
      offset = MixedContact<double>(scene_of(with(text, "surface.summit_plane_offset", offset)))
                   .solve(0.1)
                   .film_parameter;
    const Scene scene = scene_of(with(text, "surface.summit_plane_offset", offset));
    const double scale = 107.9e9 * std::sqrt(1e-7 / 1e-5) / pi;
    const double expected = is_of_both ? 16 * std::sqrt(2) / 15 * scale * moment(2.5) / moment(2)
                                       : 4.0 / 3 * scale * moment(1.5) / moment(1);
    const Validity found = limit_of(scene, "elastic_summits");
    EXPECT_NEAR(found.value / expected, 1, 1e-9);
    EXPECT_EQ(found.greatest, 2.8e9);
    EXPECT_EQ(found.holds(), expected <= 2.8e9);
  }
}

// The pressure is computed here from the point at each modulus. The limit is passed exactly where
// the pressure is above 2.8 GPa.
TEST(Validity, ElasticSummitsArePassedBeyondTheirBound) {
  bool seen[2] = {false, false};
  for (double modulus = 96e9; modulus < 3e11; modulus *= 1.0066) {
    SceneText text = ordinary();
    text.set("surface.summit_height_sd", "1e-7").set("surface.summit_density", "3.5e9");
    text = with(text.set("surface.summit_radius", "1.4e-4"), "bodies.effective_modulus", modulus);
    const Scene scene = scene_of(text);
    const OperatingPoint<double> point = MixedContact<double>(scene).solve(0.1);
    const double a = std::cbrt(3 * 50 * 9.5e-3 / (4 * modulus));
    const double pressure = 50 * point.asperity_load_share * point.asperity_load_share /
                            (pi * a * a * point.real_area_ratio);
    EXPECT_EQ(passes(text, "elastic_summits"), pressure > 2.8e9) << modulus;
    seen[pressure > 2.8e9 ? 1 : 0] = true;
  }
  EXPECT_TRUE(seen[0] && seen[1]);
}

// Bounds of bearing steel do not judge a softer body (by its E/(1 − ν²), else by 2E*).
TEST(Validity, OfSofterBodiesThePressureOfSteelIsNotKnown) {
  const auto of_effective = [](double modulus) {
    return scene_of(with(ordinary().set("load", "1e5"), "bodies.effective_modulus", modulus));
  };
  const auto of_first = [](const char* first) {
    SceneText text = ordinary().remove("bodies.effective_modulus").set("load", "1e5");
    text.set("bodies.first_modulus", first).set("bodies.second_modulus", "206e9");
    return scene_of(
        text.set("bodies.first_poisson_ratio", "0.3").set("bodies.second_poisson_ratio", "0.3"));
  };
  for (const Scene& steel : {of_effective(95.1e9), of_first("206e9"), of_first("600e9")}) {
    EXPECT_TRUE(limit_of(steel, "hertz_pressure").is_passed());
    EXPECT_EQ(limit_of(steel, "hertz_pressure").advice, "");
  }
  for (const Scene& softer : {of_effective(94.9e9), of_first("1e9"), of_first("110e9")}) {
    const Validity found = limit_of(softer, "hertz_pressure");
    EXPECT_FALSE(found.is_known());
    EXPECT_FALSE(found.is_passed());
    EXPECT_NE(found.advice.find("no yield stress"), std::string::npos) << found.advice;
  }
  SceneText summits = ordinary().set("surface.summit_height_sd", "1e-7");
  summits.set("surface.summit_density", "5e10").set("surface.summit_radius", "1e-5");
  EXPECT_TRUE(limit_of(scene_of(summits), "elastic_summits").is_known());
  summits.set("bodies.effective_modulus", "60e9");
  EXPECT_FALSE(limit_of(scene_of(summits), "elastic_summits").is_known());
  EXPECT_EQ(passes(summits, "elastic_summits"), false);
}

// The oil carries the whole load: τ = τ₀ asinh(ηSu/(hτ₀)), η by Barus at the mean pressure.
TEST(Validity, TheHeatOfSlidingInTheContactIsTold) {
  using enum verification::True;
  const double stress_of_eyring = 2.5e6, speed = 1;
  const SceneText smooth = ordinary().remove_section("surface").set("speed", "1");
  const MixedContact<double> contact(scene_of(smooth));
  const double film = contact.solve(speed).film, pressure = contact.hertz().mean_pressure;
  const auto heat = [&](double slip) {
    const double rate = 0.0202 * std::exp(2e-8 * pressure) * slip * speed / film;
    const double stress = stress_of_eyring * std::asinh(rate / stress_of_eyring);
    return std::array{stress * slip * speed * film / (8 * 0.14),
                      stress * contact.hertz().nominal_area * slip * speed};
  };
  const auto [rise, power] = heat(0.3);
  const Scene scene = scene_of(with(smooth, "friction.slide_roll_ratio", 0.3));
  EXPECT_TRUE(verification::is_within(limit_of(scene, "film_heating").value, rise, 1e-9 * rise));
  const Validity flash = limit_of(scene, "flash_temperature");
  EXPECT_TRUE(verification::is_within(flash.value, power, 1e-9 * power));
  EXPECT_FALSE(flash.is_known());
  EXPECT_FALSE(flash.is_passed());
  // Blok's formula: q is the circle's mean heat, 1.5 q its greatest, π/4 of that a band's mean.
  const double a = contact.hertz().semi_axis_x, q = power / (pi * a * a);
  const double kelvin =
      1.11 * pi / 4 * 1.5 * q * std::sqrt(2 * a) / (13e3 * (std::sqrt(1.15) + std::sqrt(0.85)));
  EXPECT_NE(flash.advice.find(fmt::format("by some {:.3g} K", kelvin)), std::string::npos)
      << flash.advice << kelvin;
  // The limit is passed just beyond the sliding that heats the film by 10 K.
  double low = 1e-3, high = 100;
  while (high / low > 1 + 1e-13) {
    const double middle = std::sqrt(low * high);
    (heat(middle)[0] < 10 ? low : high) = middle;
  }
  const auto is_passed = [&](double slip) {
    return passes(with(smooth, "friction.slide_roll_ratio", slip), "film_heating");
  };
  EXPECT_TRUE(verification::changes_at_its_limit({"film_heating", high, above, is_passed, 1e-9}));
  // Without friction or without sliding there is no heat.
  for (const SceneText& other : {SceneText(smooth).set("friction.slide_roll_ratio", "0"),
                                 SceneText(smooth).set("outputs", R"(["film"])")})
    for (const char* word : {"film_heating", "flash_temperature"})
      EXPECT_EQ(limit_of(scene_of(other), word).word, "") << word;
}

// Blok's 1.11: a fast band of heat √(1 − x²), −1 < x < 1, heats a face at x by the integral of
// √(1 − ξ²)/√(π(x − ξ)) over ξ from −1 to x. Its greatest value is divided by the mean heat π/4 and
// by √2, the root of the band's width.
TEST(Validity, TheFactorOfTheFlashTemperatureIsThatOfHertzDistribution) {
  const auto rise = [](double x) {
    constexpr int steps = 20000;  // in s = √(x − ξ), by midpoints
    const double width = std::sqrt(x + 1) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double s = (i + 0.5) * width, from = x - s * s;
      sum += 2 * std::sqrt(1 - from * from) * width;
    }
    return sum / std::sqrt(pi) / (pi / 4 * std::sqrt(2));
  };
  double greatest = 0;
  for (double x = 0; x < 1; x += 1e-2) greatest = std::max(greatest, rise(x));
  EXPECT_TRUE(verification::is_within(greatest, 1.11, 0.005));
}

// If the film has collapsed at the fastest speed, heat and films are judged at slower speeds.
TEST(Validity, ACollapsedSpeedDoesNotHideWhatIsBeforeIt) {
  SceneText text =
      ordinary().set("supply.inlet_film", "1e-6").set("surface.summit_height_sd", "1e-8");
  text.set("friction.slide_roll_ratio", "1");
  const auto of = [&text](const char* speeds) { return scene_of(text.set("speed", speeds)); };
  const Validity alone = limit_of(of("6.5"), "film_heating");
  EXPECT_TRUE(alone.is_passed());
  for (const char* speeds : {"[0.1, 6.5, 20]", "[20, 0.1, 0.2, 6.5, 30]"}) {
    const Scene scene = of(speeds);
    EXPECT_EQ(MixedContact<double>(scene).solve(20).film, 0);
    EXPECT_EQ(limit_of(scene, "film_heating").value, alone.value) << speeds;
    EXPECT_EQ(limit_of(scene, "flash_temperature").value,
              limit_of(of("6.5"), "flash_temperature").value);
  }
  // The hottest point of a range is found, though it may lie anywhere before the collapse.
  SceneText range = SceneText(text).remove("speed").set("speed.from", "0.1").set("speed.to", "20");
  range.set("speed.count", "60");
  const Scene scene = scene_of(range);
  double greatest = 0, least_film = 1;
  for (std::size_t i = 0; i < scene.speeds.size(); ++i) {
    const Scene one = of(fmt::format("{}", scene.speeds[i]).c_str());
    const Validity heat = limit_of(one, "film_heating");
    if (!heat.word.empty()) greatest = std::max(greatest, heat.value);
    const double film = MixedContact<double>(one).solve(scene.speeds[i]).film;
    if (film > 0) least_film = std::min(least_film, film);
  }
  EXPECT_TRUE(
      verification::is_within(limit_of(scene, "film_heating").value, greatest, 0.05 * greatest));
  EXPECT_EQ(limit_of(scene, "film_below_molecule").value, least_film);
  // Just before the collapse the film is thin and heated less: the greatest value is at 6.5 m/s.
  double with_film = 6.5, without = 20;
  for (int i = 0; i < 60; ++i) {
    const double middle = (with_film + without) / 2;
    (MixedContact<double>(scene).solve(middle).film > 0 ? with_film : without) = middle;
  }
  const std::string last = fmt::format("{}", with_film);
  EXPECT_LT(limit_of(of(last.c_str()), "film_heating").value, alone.value / 2);
  EXPECT_EQ(limit_of(of(fmt::format("[0.1, 6.5, {}]", last).c_str()), "film_heating").value,
            alone.value);
  EXPECT_EQ(limit_of(of("[0.1, 1, 2]"), "film_heating").value,
            limit_of(of("2"), "film_heating").value);
}

TEST(Validity, TheInletIsHeatedAtTheLastSpeedWithAFilm) {
  SceneText text =
      ordinary().set("supply.inlet_film", "1e-6").set("surface.summit_height_sd", "1e-8");
  const auto of = [&text](const char* speeds) {
    return limit_of(scene_of(text.set("speed", speeds)), "inlet_heating");
  };
  for (const char* speeds : {"[0.1, 20, 30]", "[30, 6.5, 0.2]"}) {
    const double last = speeds[1] == '0' ? 0.1 : 6.5;
    const Validity heat = of(speeds), alone = of(fmt::format("{}", last).c_str());
    EXPECT_EQ(heat.value, alone.value) << speeds;
    EXPECT_EQ(heat.advice, alone.advice) << speeds;
    EXPECT_EQ(heat.advice.find("at 6.5 m/s") == std::string::npos, heat.holds()) << heat.advice;
  }
  EXPECT_EQ(of("20").word, "");
  // A film that stays is heated at the fastest speed.
  text.set("closures.starvation", "\"damiens\"");
  EXPECT_NE(of("[0.1, 20]").advice.find("at 20 m/s"), std::string::npos);
}

// Where a number was given in a wrong unit, there is no advice on values that follow from it.
TEST(Validity, WhereANumberIsASlipNothingElseIsAdvised) {
  const auto advice = [](const char* modulus) {
    SceneText text = ordinary().set("bodies.effective_modulus", modulus);
    return limit_of(scene_of(text), "film_law_regime").advice;
  };
  EXPECT_EQ(advice("115000"), "");
  EXPECT_NE(advice("1.15e6").find("hamrock_dowson_soft_central"), std::string::npos);
}

// Where the faces touch and only Rq is known, the friction of the oil does not give the heat.
TEST(Validity, OfFacesThatTouchTheHeatIsNotKnown) {
  SceneText text = ordinary().remove_section("surface").set("speed", "1");
  for (const char* word : {"film_heating", "flash_temperature"}) {
    EXPECT_EQ(limit_of(scene_of(text.set("surface.rms_roughness", "1e-6")), word).word, "");
    EXPECT_EQ(limit_of(scene_of(text.set("surface.rms_roughness", "1e-9")), word).word, word);
  }
}

// The number is S R/(μ_b a). It is judged where summits carry a part of the load.
TEST(Validity, SummitsThatHardlySlideHaveNoBoundaryFriction) {
  using enum verification::True;
  const SceneText text = ordinary().set("speed", "0.01");
  const double a = std::cbrt(3 * 50 * 9.5e-3 / (4 * 107.9e9));
  const auto is_passed = [&text](double slip) {
    return passes(with(text, "friction.slide_roll_ratio", slip), "boundary_sliding");
  };
  EXPECT_GE(MixedContact<double>(scene_of(text)).solve(0.01).asperity_load_share, 0.01);
  EXPECT_TRUE(verification::changes_at_its_limit(
      {"boundary_sliding", 0.13 * a / 9.5e-3, below, is_passed, 1e-12}));
  EXPECT_EQ(is_passed(0), true);
  for (const SceneText& other :
       {SceneText(text).set("speed", "10"), SceneText(text).set("outputs", R"(["film"])"),
        SceneText(text).set("friction.boundary_coefficient", "0")})
    EXPECT_EQ(limit_of(scene_of(SceneText(other).set("friction.slide_roll_ratio", "0")),
                       "boundary_sliding")
                  .word,
              "");
}

// A(0) = √(K F_{5/2}(−m D_d/σ_s)) for m = 2 over that for m = 1; both faces are about as rough.
TEST(Validity, TheOffsetOfOneFaceIsToldWhereBothAreAlike) {
  SceneText profile = ordinary().remove_section("surface").set("surface.m0", "1.6e-13");
  profile.set("surface.m2", "4e-3").set("surface.m4", "6e8");
  const auto share = [&profile](const char* planes) {
    return MixedContact<double>(scene_of(SceneText(profile).set("surface.offset_planes", planes)))
        .sharing()
        .asperity_share(0);
  };
  const Validity found = limit_of(scene_of(profile), "default_planes");
  const double factor = share("2") / share("1");
  EXPECT_TRUE(verification::is_within(found.value, factor, 1e-9 * factor));
  EXPECT_TRUE(found.is_passed());
  EXPECT_NE(found.advice.find(fmt::format("{:.3g} in place of {:.3g}", share("2"), share("1"))),
            std::string::npos)
      << found.advice;
  SceneText faces = ordinary().set("surface.summit_plane_offset", "0.9");
  for (const char* alike : {"[5e-9, 5e-9]", "[5e-9, 10e-9]", "[10e-9, 5e-9]"})
    EXPECT_TRUE(passes(SceneText(faces).set("surface.rms_roughness", alike), "default_planes"));
  for (const SceneText& other :
       {SceneText(profile).set("surface.offset_planes", "1"),
        SceneText(profile).set("closures.asperity", "\"greenwood_williamson\""), faces,
        SceneText(faces).set("surface.rms_roughness", "7e-9"),
        SceneText(faces).set("surface.rms_roughness", "[5e-9, 10.01e-9]"),
        SceneText(faces).set("surface.rms_roughness", "[10.01e-9, 5e-9]"), ordinary()})
    EXPECT_EQ(limit_of(scene_of(other), "default_planes").word, "");
}

// The speed follows from 13.2 (p₀/E′) L^0.42 = 0.5, half of what makes Gupta's factor 0.
TEST(Validity, GuptasFactorIsToldBeforeItIsZero) {
  using enum verification::True;
  SceneText text = ordinary().set("lubricant.thermal", "\"gupta\"");
  text.set("lubricant.conductivity", "0.14").set("lubricant.temperature_coefficient", "0.04");
  text.set("friction.slide_roll_ratio", "0.1");
  const double peak = MixedContact<double>(scene_of(text)).hertz().peak_pressure;
  const double heating = std::pow(0.5 / 13.2 * 2 * 107.9e9 / peak, 1 / 0.42);
  const auto is_passed = [&](double speed) {
    return passes(with(text, "speed", speed), "thermal_reduction");
  };
  EXPECT_TRUE(verification::changes_at_its_limit(
      {"thermal_reduction", std::sqrt(heating * 0.14 / (0.04 * 0.0202)), above, is_passed, 1e-9}));
  EXPECT_EQ(limit_of(scene_of(ordinary()), "thermal_reduction").word, "");
}

TEST(Validity, FacesThatMoveAgainstEachOtherAreToldWhereSlidingCounts) {
  using enum verification::True;
  const auto is_passed = [](double slip) {
    return passes(with(ordinary(), "friction.slide_roll_ratio", slip), "opposite_motion");
  };
  EXPECT_TRUE(verification::changes_at_its_limit({"opposite_motion", 2, above, is_passed, 0}));
  const SceneText film = ordinary().set("outputs", R"(["film"])");
  EXPECT_EQ(
      limit_of(scene_of(SceneText(film).set("friction.slide_roll_ratio", "40")), "opposite_motion")
          .word,
      "");
}

// r = h_ff/h_oil is judged only for flooded_inlet, the closure whose film collapses at r = 1.
TEST(Validity, AFilmThatCollapsesIsToldWithTheClosuresThatLeaveOne) {
  using enum verification::True;
  const SceneText flooded = ordinary().set("speed", "[0.1, 1]");
  const double film = MixedContact<double>(scene_of(flooded)).solve(1).film_flooded;
  const auto of = [&](double inlet_film) { return with(flooded, "supply.inlet_film", inlet_film); };
  const auto is_passed = [&](double inlet_film) { return passes(of(inlet_film), "inlet_supply"); };
  EXPECT_TRUE(verification::changes_at_its_limit({"inlet_supply", film, below, is_passed, 1e-9}));
  const Validity found = limit_of(scene_of(of(film / 2)), "inlet_supply");
  EXPECT_NE(found.advice.find("starved_inlet"), std::string::npos);
  SceneText other = of(film / 2);
  for (const char* closure : {"\"starved_inlet\"", "\"damiens\"", "\"printed_exponents\""})
    EXPECT_EQ(limit_of(scene_of(other.set("closures.starvation", closure)), "inlet_supply").word,
              "");
  EXPECT_EQ(limit_of(scene_of(flooded), "inlet_supply").word, "");
}

// The number is the film by damiens with γ = 3, (1 + r³)^(−1/3), over that by flooded_inlet. It is
// judged where the scene names no closure.
TEST(Validity, ALawOfTheInletThatWasNotChosenIsToldWhereItMatters) {
  const SceneText flooded = ordinary().set("speed", "0.1");
  const double film = MixedContact<double>(scene_of(flooded)).solve(0.1).film_flooded;
  const auto of = [&](double r) { return with(flooded, "supply.inlet_film", film / r); };
  for (const double r : {0.01, 0.3, 0.9}) {
    const double psi = std::pow(3 / (4 * std::sqrt(2)) * (1 / r - 1), 2.0 / 3);
    const double factor = 1 / std::cbrt(1 + r * r * r) / (2 / pi * std::atan(2.7 * psi));
    const Validity found = limit_of(scene_of(of(r)), "default_inlet");
    EXPECT_TRUE(verification::is_within(found.value, factor, 1e-7 * factor)) << r;
    EXPECT_EQ(found.holds(), factor <= 1.2) << r;
    EXPECT_EQ(found.holds(), r == 0.01);
    EXPECT_EQ(found.advice.empty(), found.holds());
  }
  // Beyond the collapse inlet_supply is passed, and its advice says if the closure was chosen.
  const auto of_collapse = [&](const char* closure) {
    SceneText text = of(2);
    if (*closure != 0) text.set("closures.starvation", closure);
    EXPECT_EQ(limit_of(scene_of(text), "default_inlet").word, "");
    return limit_of(scene_of(text), "inlet_supply").advice;
  };
  EXPECT_NE(of_collapse("").find("flooded_inlet, the default, which"), std::string::npos);
  EXPECT_NE(of_collapse("\"flooded_inlet\"").find("flooded_inlet, which"), std::string::npos);
  for (const char* closure : {"\"flooded_inlet\"", "\"damiens\""})
    EXPECT_EQ(limit_of(scene_of(of(0.3).set("closures.starvation", closure)), "default_inlet").word,
              "");
  EXPECT_EQ(limit_of(scene_of(flooded), "default_inlet").word, "");
}

// A scene without S gets S = 1. The limit is judged where friction uses it.
TEST(Validity, SlidingThatTheSceneLeavesToTheDefaultIsTold) {
  const SceneText silent = ordinary().remove("friction.slide_roll_ratio");
  const Validity found = limit_of(scene_of(silent), "default_sliding");
  EXPECT_EQ(found.value, 1);
  EXPECT_TRUE(found.is_passed());
  EXPECT_NE(found.advice.find("no friction.slide_roll_ratio"), std::string::npos);
  SceneText heated = SceneText(silent).set("lubricant.thermal", "\"gupta\"");
  heated.set("lubricant.conductivity", "0.14").set("lubricant.temperature_coefficient", "0.04");
  for (const SceneText& other : {SceneText(silent).set("friction.slide_roll_ratio", "1"),
                                 SceneText(silent).set("friction.slide_roll_ratio", "0.02"),
                                 SceneText(silent).set("outputs", R"(["film"])"), heated})
    EXPECT_EQ(limit_of(scene_of(other), "default_sliding").word, "");
}

// α p₀ is judged where friction follows Barus' law.
TEST(Validity, AlphaTimesPressureIsJudgedWhereBarusLawIsUsed) {
  const SceneText thick = ordinary().set("lubricant.pressure_viscosity", "4e-8");
  EXPECT_EQ(passes(thick, "alpha_p0"), true);
  for (const char* law : {"\"roelands\"", "\"ambient\""})
    EXPECT_EQ(limit_of(scene_of(SceneText(thick).set("friction.viscosity", law)), "alpha_p0").word,
              "");
  EXPECT_EQ(limit_of(scene_of(SceneText(thick).set("outputs", R"(["film"])")), "alpha_p0").word,
            "");
}

// ν has to be 2 mm²/s (0.00174/870 m²/s) or more at the running temperature and at both given ones.
TEST(Validity, AnOilThinnerThanTheFormulaOfItsViscosityIsTold) {
  const auto of = [](const char* pairs, const char* temperature) {
    SceneText text = ordinary().remove("lubricant.viscosity").set("lubricant.density", "870");
    text.set("lubricant.kinematic_viscosity", pairs).set("lubricant.temperature", temperature);
    return limit_of(scene_of(text), "oil_viscosity");
  };
  EXPECT_FALSE(of("[[313.15, 1e-5], [373.15, 2.1e-6]]", "380").holds());
  EXPECT_FALSE(of("[[313.15, 1e-5], [373.15, 1.9e-6]]", "320").holds());
  EXPECT_TRUE(of("[[313.15, 1e-5], [373.15, 2.1e-6]]", "370").holds());
  EXPECT_EQ(limit_of(scene_of(ordinary()), "oil_viscosity").word, "");
}

// The bodies of a ball in a cup are far more curved than the gap between them.
TEST(Validity, AContactIsComparedWithTheBodiesNotWithTheGap) {
  SceneText text = ordinary().remove("bodies.reduced_radius");
  text.set("bodies.first_radius_x", "0.014").set("bodies.second_radius_x", "-0.01408");
  text.set("bodies.first_radius_y", "0.014").set("bodies.second_radius_y", "-0.01408");
  const double gap = 1 / (1 / 0.014 - 1 / 0.01408);
  const double axis = std::cbrt(3 * 50 * gap / (4 * 107.9e9));
  EXPECT_NEAR(limit_of(scene_of(text), "half_space").value / (axis / 0.014), 1, 1e-6);
  EXPECT_EQ(passes(with(text, "load", 50 * std::pow(0.0071 / axis, 3)), "half_space"), true);
  EXPECT_EQ(passes(with(text, "load", 50 * std::pow(0.0069 / axis, 3)), "half_space"), false);
  // Without the bodies the gap is all that is known.
  SceneText other = ordinary().remove("bodies.reduced_radius");
  other.set("bodies.radius_x", "0.02").set("bodies.radius_y", "0.02");
  const double of_gap = std::cbrt(3 * 50 * 0.02 / (4 * 107.9e9)) / 0.02;
  EXPECT_NEAR(limit_of(scene_of(other), "half_space").value / of_gap, 1, 1e-6);
}

// The border of Hamrock's map between the piezoviscous-elastic and the isoviscous-elastic regime:
// 3.42 g_V^0.49 g_E^0.17 (1 − e^{−0.68}) = 8.70 g_E^0.67 (1 − 0.85 e^{−0.31}).
TEST(Validity, AFilmLawBelongsToItsRegime) {
  using enum verification::True;
  const double modulus = 2 * 1e8, radius = 9.5e-3, speed = 0.1;
  const double u = 0.0202 * speed / (modulus * radius), w = 50 / (modulus * radius * radius);
  const double elasticity = std::pow(w, 8.0 / 3) / (u * u);
  const double viscosity = std::pow(
      8.70 * std::sqrt(elasticity) * (1 - 0.85 * std::exp(-0.31)) / (3.42 * (1 - std::exp(-0.68))),
      1 / 0.49);
  const double border = viscosity * u * u / (w * w * w) / modulus;
  const SceneText hard = ordinary().set("bodies.effective_modulus", "1e8").set("speed", "0.1");
  const SceneText soft = SceneText(hard).set("closures.film", "\"hamrock_dowson_soft_central\"");
  for (const bool is_soft : {false, true}) {
    const auto is_passed = [&](double alpha) {
      return passes(with(is_soft ? soft : hard, "lubricant.pressure_viscosity", alpha),
                    "film_law_regime");
    };
    // Films that differ by a fifth count as alike: the limit lies beyond the border.
    const double limit = border * std::pow(is_soft ? 1.2 : 1 / 1.2, 1 / 0.49);
    EXPECT_TRUE(verification::changes_at_its_limit(
        {"film_law_regime", limit, is_soft ? above : below, is_passed, 1e-10}));
  }
  // The number is the ratio of the films of both regimes.
  const Validity found = limit_of(
      scene_of(with(hard, "lubricant.pressure_viscosity", border / 100)), "film_law_regime");
  EXPECT_NEAR(found.value / std::pow(100, 0.49), 1, 1e-9);
  EXPECT_NE(found.advice.find("take hamrock_dowson_soft_central"), std::string_view::npos);
  const Validity other = limit_of(
      scene_of(with(soft, "lubricant.pressure_viscosity", border * 100)), "film_law_regime");
  EXPECT_NEAR(other.value / std::pow(100, 0.49), 1, 1e-9);
  EXPECT_NE(other.advice.find("take hamrock_dowson_central"), std::string_view::npos);
  // Moes' law of lines covers all regimes.
  SceneText line = ordinary().remove("bodies.reduced_radius");
  line.set("bodies.radius_x", "0.01").set("bodies.length", "0.01").set("load", "100");
  line.set("closures.film", "\"dowson_toyoda_central\"").set("bodies.effective_modulus", "1e7");
  const Validity rubber = limit_of(scene_of(line), "film_law_regime");
  EXPECT_FALSE(rubber.holds());
  EXPECT_NE(rubber.advice.find("take moes_line"), std::string_view::npos);
}

// A(0)² = K F_{5/2}(0) where δ is 0 (model/README.md, section 10).
TEST(Validity, SummitsThatCannotCarryTheLoadAreTold) {
  bool seen[2] = {false, false};
  for (double density = 1e11; density < 1e14; density *= 1.1) {
    SceneText text = with(ordinary(), "surface.summit_density", density);
    text.set("speed", "1e-6");
    const double a = std::cbrt(3 * 50 * 9.5e-3 / (4 * 107.9e9));
    const double roughness = density * 5e-5 * 5e-9;
    const double stiffness = 16 * std::sqrt(2) * pi / 15 * roughness * roughness *
                             std::sqrt(5e-9 / 5e-5) * 107.9e9 * pi * a * a / 50;
    const double share = std::sqrt(stiffness * 0.61663421900);
    const Validity found = limit_of(scene_of(text), "summit_capacity");
    if (found.word.empty()) {  // the summits keep the film thick
      EXPECT_GE(share, 1);
      continue;
    }
    EXPECT_NEAR(found.value / share, 1, 1e-9);
    EXPECT_EQ(found.holds(), share >= 1);
    seen[found.holds() ? 1 : 0] = true;
    // The limit is not judged where the film is thick.
    EXPECT_EQ(limit_of(scene_of(text.set("speed", "1")), "summit_capacity").word, "");
  }
  EXPECT_TRUE(seen[0]);
}

// Faces of which only Rq is known do not touch where Λ ≥ 3. Λ is taken at the slowest speed.
TEST(Validity, FacesWithoutSummitsAreSmoothFromAFullFilmOn) {
  using enum verification::True;
  const SceneText text = ordinary().remove_section("surface").set("speed", "[2, 0.1, 1]");
  const double least =
      film_thickness(hamrock_dowson_minimum_law, 0.1, 0.0202, 2e-8, 50.0, 107.9e9, 9.5e-3, 1.0);
  const auto is_passed = [&](double roughness) {
    return passes(with(text, "surface.rms_roughness", roughness), "rough_as_smooth");
  };
  EXPECT_TRUE(
      verification::changes_at_its_limit({"rough_as_smooth", least / 3, above, is_passed, 1e-12}));
  EXPECT_EQ(limit_of(scene_of(ordinary()), "rough_as_smooth").word, "");
  EXPECT_EQ(limit_of(scene_of(text), "rough_as_smooth").word, "");
}

// σ_s = Rq √(1 − 0.8968/α) of an isotropic Gaussian face, whose α is 1.5 or more.
TEST(Validity, HeightsOfSummitsAreThoseOfTheirFace) {
  using enum verification::True;
  const double sd = 5e-9, least = 0.9 * std::sqrt(1 - 0.8968 / 1.5);
  const auto is_passed = [](double roughness) {
    return passes(with(ordinary(), "surface.rms_roughness", roughness), "summit_heights");
  };
  EXPECT_TRUE(
      verification::changes_at_its_limit({"summit_heights", sd / 1.1, below, is_passed, 1e-12}));
  EXPECT_TRUE(
      verification::changes_at_its_limit({"summit_heights", sd / least, above, is_passed, 1e-5}));
  SceneText profile = ordinary().remove_section("surface").set("surface.m0", "1e-16");
  profile.set("surface.m2", "1e-4").set("surface.m4", "1e9");
  EXPECT_EQ(limit_of(scene_of(profile), "summit_heights").word, "");
  EXPECT_EQ(limit_of(scene_of(ordinary()), "summit_heights").word, "");
}

// A ball and a groove whose radius lacks its minus sign, and pairs that are no ball and groove.
TEST(Validity, AGrooveThatIsConvexIsTold) {
  const auto is_passed = [](const char* first, const char* second) {
    SceneText text = ordinary().remove("bodies.reduced_radius");
    text.set("bodies.first_radius_x", "0.004").set("bodies.second_radius_x", "0.015");
    text.set("bodies.first_radius_y", first).set("bodies.second_radius_y", second);
    return passes(text, "groove");
  };
  EXPECT_EQ(is_passed("0.004", "0.00416"), true);
  EXPECT_EQ(is_passed("0.00416", "0.004"), true);
  EXPECT_EQ(is_passed("0.004", "0.00479"), true);
  EXPECT_EQ(is_passed("0.004", "0.00481"), false);
  EXPECT_EQ(is_passed("0.004", "-0.00416"), false);
  EXPECT_EQ(is_passed("0.004", "0.004"), false);
  EXPECT_EQ(is_passed("0.004", "inf"), false);
  // A ratio of 2.08 means that the groove's diameter was given. A ratio of 2 is no such slip.
  EXPECT_EQ(is_passed("0.004", "0.00832"), true);
  EXPECT_EQ(is_passed("0.00879", "0.004"), true);
  EXPECT_EQ(is_passed("0.004", "0.008"), false);
  EXPECT_EQ(is_passed("0.004", "0.00881"), false);
}

// A groove whose diameter was given as its radius, or that is too wide for its ball.
TEST(Validity, AGrooveThatIsWiderThanItsBallIsTold) {
  const auto found = [](const char* first, const char* second) {
    SceneText text = ordinary().remove("bodies.reduced_radius");
    text.set("bodies.first_radius_x", "0.004").set("bodies.second_radius_x", "0.015");
    text.set("bodies.first_radius_y", first).set("bodies.second_radius_y", second);
    return limit_of(scene_of(text), "groove_radius");
  };
  EXPECT_TRUE(verification::is_within(found("0.004", "-0.00832").value, 2.08, 1e-14));
  EXPECT_TRUE(found("0.004", "-0.00832").is_passed());
  EXPECT_NE(found("-0.00832", "0.004").advice.find("diameter"), std::string::npos);
  EXPECT_TRUE(found("0.004", "-0.00481").is_passed());
  EXPECT_EQ(found("0.004", "-0.00481").advice.find("diameter"), std::string::npos);
  EXPECT_FALSE(found("0.004", "-0.00479").is_passed());
  EXPECT_EQ(found("0.004", "-0.00479").word, "groove_radius");
  for (const char* const other : {"0.00832", "-0.00881", "-0.1", "inf"})
    EXPECT_EQ(found("0.004", other).word, "") << other;
}

// The message names the law to take where the law was not fitted to the contact's ellipticity.
TEST(Validity, ALawThatWasNotFittedToTheEllipseSaysWhatToTake) {
  const auto advice = [](const char* across, const char* film) {
    SceneText text = ordinary().remove("bodies.reduced_radius").set("closures.film", film);
    text.set("bodies.radius_x", "0.004").set("bodies.radius_y", across);
    return limit_of(scene_of(text), "film_law_ellipticity").advice;
  };
  const char* const hard = "\"hamrock_dowson_central\"";
  const char* const soft = "\"hamrock_dowson_soft_central\"";
  EXPECT_NE(advice("1", hard).find("bodies.length"), std::string::npos);
  EXPECT_NE(advice("1", hard).find("dowson_toyoda_central"), std::string::npos);
  EXPECT_NE(
      advice("1", hard).find("from k = 8 to this k the film of this law grows by 0.178 % only"),
      std::string::npos)
      << advice("1", hard);
  EXPECT_NE(advice("1", soft).find("tribocheck film"), std::string::npos);
  EXPECT_EQ(advice("0.004", soft), "");  // a circle
  EXPECT_NE(advice("0.001", hard).find("longer along the motion"), std::string::npos);
  EXPECT_NE(advice("0.001", hard).find("`tribocheck film` solves it"), std::string::npos);
  EXPECT_NE(advice("0.01", soft).find("no text tells"), std::string::npos);
  EXPECT_EQ(advice("0.01", hard), "");
}

// A radius along the motion in mm is told. A radius that stands for a flat face is no slip.
TEST(Validity, ABallOfMetresIsTold) {
  const auto found = [](const char* first) {
    SceneText text = ordinary().remove("bodies.reduced_radius");
    text.set("bodies.first_radius_x", first).set("bodies.second_radius_x", "0.02");
    text.set("bodies.first_radius_y", "0.01").set("bodies.second_radius_y", "inf");
    return limit_of(scene_of(text), "first_radius_x_range");
  };
  EXPECT_EQ(found("9.5").likely_unit, "mm");
  EXPECT_FALSE(found("9.5").holds());
  for (const char* const other : {"0.0095", "5", "1000", "1e30"})
    EXPECT_EQ(found(other).word, "") << other;
}

// The film loses 1 minus Gupta's factor without sliding, for β = 0.04/K and k_f = 0.14 W/(m K).
TEST(Validity, TheWarningOfHeatNamesTheCureAndThePartOfTheFilm) {
  const Scene fast = scene_of(ordinary().set("speed", "20"));
  const Validity heat = limit_of(fast, "inlet_heating");
  const double peak = MixedContact<double>(fast).hertz().peak_pressure;
  const double l = 0.04 * heat.value;
  const double factor =
      (1 - 13.2 * peak / (2 * 107.9e9) * std::pow(l, 0.42)) / (1 + 0.213 * std::pow(l, 0.64));
  const std::string part = fmt::format("by some {:.0f} %", 100 * (1 - factor));
  EXPECT_NE(heat.advice.find(part), std::string::npos) << heat.advice;
  EXPECT_NE(heat.advice.find("lubricant.thermal"), std::string::npos);
  EXPECT_EQ(limit_of(scene_of(ordinary()), "inlet_heating").advice, "");
}

// A solved film leaves heat out, even if the scene has lubricant.thermal.
TEST(Validity, OfASolvedFilmTheHeatIsTold) {
  SceneText line = ordinary().remove_section("surface").remove("bodies.reduced_radius");
  line.set("bodies.radius_x", "0.01").set("bodies.length", "0.01").set("speed", "20");
  line.set("closures.film", "\"dowson_toyoda_central\"").set("friction.slide_roll_ratio", "0");
  line.set("lubricant.thermal", "\"gupta\"").set("lubricant.conductivity", "0.14");
  line.set("lubricant.temperature_coefficient", "0.04");
  EXPECT_EQ(limit_of(scene_of(line), "inlet_heating").word, "");
  const Scene solved = scene_of(line, SceneUse::line_film);
  const Validity heat = limit_of(solved, "inlet_heating", SceneUse::line_film);
  EXPECT_FALSE(heat.holds());
  EXPECT_NE(heat.advice.find("the solved film leaves heat out"), std::string::npos);
  const SceneReading told = read(Format::toml, line, SceneUse::line_film);
  EXPECT_TRUE(has_problem(told.warnings, "lubricant.thermal", "isothermal"));
  line.set("lubricant.thermal", "\"none\"");
  EXPECT_TRUE(read(Format::toml, line, SceneUse::line_film).warnings.empty());
}

// A solved film has no law that could be outside of its range.
TEST(Validity, OfASolvedFilmNoLawIsAskedForTheEllipse) {
  SceneText text = ordinary().remove("bodies.reduced_radius");
  text.set("bodies.radius_x", "0.004").set("bodies.radius_y", "1");
  EXPECT_TRUE(limit_of(scene_of(text), "film_law_ellipticity").is_passed());
  const Scene solved = scene_of(text, SceneUse::film);
  EXPECT_EQ(limit_of(solved, "film_law_ellipticity", SceneUse::film).word, "");
  EXPECT_EQ(limit_of(solved, "film_law_regime", SceneUse::film).word, "");
}

TEST(Validity, SaysWhichResultsALimitTouches) {
  const Scene loud = scene_of(SceneText::good()
                                  .set("lubricant.viscosity", "20.2")
                                  .set("load", "1e6")
                                  .set("bodies.ellipticity", "3"));
  for (const Validity& limit : validity_of(loud)) {
    EXPECT_FALSE(limit.touches.empty()) << limit.word;
    EXPECT_EQ(limit.advice.empty() || !limit.holds() || !limit.is_known(), true) << limit.word;
    if (!limit.field.empty()) {
      EXPECT_EQ(limit.touches, "everything") << limit.field;
    }
  }
  EXPECT_EQ(limit_of(loud, "alpha_p0").touches, "friction");
  EXPECT_EQ(limit_of(loud, "hertz_pressure").touches, "everything");
  EXPECT_EQ(limit_of(scene_of(ordinary()), "inlet_heating").touches, "film");
}

TEST(Validity, OfANumberThatFollowsNoUnitIsGuessed) {
  SceneText text = ordinary().remove("bodies.reduced_radius");
  text.set("bodies.first_radius_x", "25").set("bodies.second_radius_x", "inf");
  text.set("bodies.first_radius_y", "25").set("bodies.second_radius_y", "inf");
  std::size_t following = 0;
  for (const Validity& limit : validity_of(scene_of(text))) {
    if (limit.field == "bodies.radius_x" || limit.field == "bodies.radius_y") {
      EXPECT_TRUE(limit.value_follows);
      EXPECT_EQ(limit.likely_unit, "");
      ++following;
    } else if (!limit.field.empty()) {
      EXPECT_FALSE(limit.value_follows) << limit.field;
    }
  }
  EXPECT_GE(following, 1u);
}

// An assumption that a scene does not make is not in its table.
TEST(Validity, LeavesOutWhatTheSceneDoesNotAssume) {
  const SceneText ball = ordinary();
  EXPECT_EQ(limit_of(scene_of(ball), "roelands_index").word, "");
  EXPECT_EQ(limit_of(scene_of(ball), "line_length").word, "");
  SceneText other = ball;
  EXPECT_EQ(limit_of(scene_of(other.set("friction.viscosity", "\"ambient\"")), "barus").word, "");
  EXPECT_EQ(limit_of(scene_of(SceneText(ball).set("outputs", R"(["film"])")), "barus").word, "");
  const Scene without = scene_of(SceneText(ball).remove("speed"), SceneUse::onset);
  for (const char* word : {"film_below_molecule", "smooth_film_law", "inlet_heating"})
    EXPECT_EQ(limit_of(without, word, SceneUse::onset).word, "") << word;
  // Where the film is thick, summits carry next to nothing.
  EXPECT_EQ(limit_of(scene_of(SceneText(ball).set("speed", "1")), "elastic_summits").word, "");
}

// The solved film of a line follows a law of viscosity up to its peak pressure, whatever outputs
// are asked for.
TEST(Validity, OfASolvedFilmIsThatOfItsLine) {
  const auto use = SceneUse::line_film;
  SceneText line = ordinary().remove_section("surface").remove("bodies.reduced_radius");
  line.set("bodies.radius_x", "0.01").set("bodies.length", "0.01").set("load", "1e4");
  const Scene scene = scene_of(line, use);
  // p₀² = FE*/(πRL)
  const double peak = std::sqrt(1e4 * 107.9e9 / (pi * 0.01 * 0.01));
  EXPECT_NEAR(limit_of(scene, "barus", use).value / peak, 1, 1e-14);
  EXPECT_EQ(limit_of(scene, "barus", use).touches, "pressure");
  EXPECT_EQ(limit_of(scene, "smooth_film_law", use).word, "");
  EXPECT_EQ(passes(line, "barus", use), true);
}

TEST(Validity, SlipsOfUnitsAreNamed) {
  struct Slip {
    const char *path, *value, *unit;
  };
  for (const auto& [path, value, unit] :
       {Slip{"lubricant.viscosity", "20.2", "mPa·s"}, Slip{"bodies.reduced_radius", "9.5", "mm"},
        Slip{"bodies.effective_modulus", "107.9", "GPa"},
        Slip{"bodies.effective_modulus", "113000", "MPa"},
        Slip{"bodies.effective_modulus", "1e20", ""},
        Slip{"surface.summit_density", "50000", "1/mm²"}, Slip{"surface.summit_radius", "10", "µm"},
        Slip{"surface.summit_height_sd", "25", "nm"},
        Slip{"lubricant.pressure_viscosity", "20", "1/GPa"},
        Slip{"lubricant.eyring_stress", "2.5", "MPa"}, Slip{"speed", "600", "mm/s"},
        Slip{"lubricant.viscosity", "1e9", ""}}) {
    const std::string word = std::string(path).substr(std::string(path).rfind('.') + 1) + "_range";
    const Validity limit = limit_of(scene_of(ordinary().set(path, value)), word);
    EXPECT_EQ(limit.field, path);
    EXPECT_EQ(limit.likely_unit, unit) << path;
    EXPECT_FALSE(limit.holds());
  }
}

// The range of a modulus begins between the stiffest body in N/mm² and the softest rubber in Pa.
TEST(Validity, ModuliInNewtonsPerSquareMillimetreAreTold) {
  const auto found = [](const char* modulus) {
    SceneText text = ordinary().remove("bodies.effective_modulus");
    for (const char* const body : {"bodies.first_", "bodies.second_"}) {
      text.set(std::string(body) + "poisson_ratio", "0.3");
      text.set(std::string(body) + "modulus", "210e9");
    }
    return limit_of(scene_of(text.set("bodies.first_modulus", modulus)), "first_modulus_range");
  };
  for (const char* const slip : {"210000", "70e3", "480000"})
    EXPECT_EQ(found(slip).likely_unit, "MPa") << slip;
  for (const char* const slip : {"210", "3.2"}) EXPECT_EQ(found(slip).likely_unit, "GPa") << slip;
  for (const char* const good : {"5e5", "2.5e6", "210e9", "1.2e12"})
    EXPECT_EQ(found(good).word, "") << good;
}

TEST(Validity, LiquidsInUsualUnitsAreTold) {
  SceneText text = ordinary().remove("lubricant.viscosity");
  text.set("lubricant.iso_vg", "46").set("lubricant.viscosity_index", "95");
  text.set("lubricant.temperature", "333").set("lubricant.density", "0.87");
  text.set("lubricant.thermal", "\"gupta\"").set("lubricant.temperature_coefficient", "0.04");
  const Scene scene = scene_of(text.set("lubricant.conductivity", "140"));
  EXPECT_EQ(limit_of(scene, "density_range").likely_unit, "g/cm³");
  EXPECT_EQ(limit_of(scene, "conductivity_range").likely_unit, "mW/(m·K)");
}

// Real contacts, from a watch's jewel to a bearing of three metres, stay within all ranges.
TEST(Validity, RealContactsKeepTheRangesOfFields) {
  struct Contact {
    const char* what;
    std::vector<std::pair<const char*, const char*>> fields;
  };
  for (const Contact& one : std::initializer_list<Contact>{
           {"pivot in a watch's jewel, 1 mm²",
            {{"load", "2e-3"}, {"bodies.reduced_radius", "4e-5"}, {"speed", "1e-3"}}},
           {"ball of a slewing bearing of 3 m",
            {{"load", "5e4"}, {"bodies.reduced_radius", "3e-2"}, {"lubricant.viscosity", "1.5"}}},
           {"hip joint, metal on metal",
            {{"load", "2500"}, {"bodies.reduced_radius", "4"}, {"lubricant.viscosity", "9e-4"}}},
           {"rubber in water",
            {{"bodies.effective_modulus", "2e6"},
             {"lubricant.viscosity", "1e-3"},
             {"lubricant.pressure_viscosity", "5e-10"}}},
           {"aircraft gear", {{"speed", "200"}, {"lubricant.viscosity", "3e-3"}}},
           {"open gear's oil in the cold", {{"lubricant.viscosity", "9"}, {"speed", "0.05"}}}}) {
    SceneText text = ordinary();
    for (const auto& [path, value] : one.fields) text.set(path, value);
    for (const std::string_view word : limit_words()) {
      if (!word.ends_with("_range")) continue;
      EXPECT_EQ(passes(text, word), false) << one.what << ": " << word;
    }
  }
}

// --- accept

TEST(Accept, EachWordIsTakenAndSilencesItsLimitAlone) {
  const Scene loud = scene_of(SceneText::good()
                                  .set("lubricant.viscosity", "20.2")
                                  .set("load", "1e6")
                                  .set("bodies.ellipticity", "3"));
  const std::vector<std::string_view> before = words_passed(loud);
  EXPECT_GT(before.size(), 5u);
  std::set<std::string_view> seen;
  for (const std::string_view word : limit_words()) {
    EXPECT_TRUE(seen.insert(word).second) << word;
    Scene scene = scene_of(SceneText::good().set("accept", fmt::format("[\"{}\"]", word)));
    EXPECT_EQ(scene.accepted, std::vector<std::string_view>{word});
    Scene quiet = loud;
    quiet.accepted = scene.accepted;
    std::vector<std::string_view> left = before;
    std::erase(left, word);
    EXPECT_EQ(words_passed(quiet), left) << word;
  }
  EXPECT_EQ(assumption_words().size(), 31u);
  for (const std::string_view word : assumption_words()) EXPECT_FALSE(word.ends_with("_range"));
}

TEST(Accept, OtherWordsAreRefusedWithTheListAndTheNearest) {
  EXPECT_TRUE(refused(SceneText::good().set("accept", R"(["baruss"])"), "accept[0]",
                      "did you mean barus?"));
  EXPECT_TRUE(refused(SceneText::good().set("accept", R"(["barus", 3])"), "accept[1]",
                      "3 is a number; allowed: a list of hertz_pressure, half_space"));
  EXPECT_TRUE(refused(SceneText::good().set("accept", "\"barus\""), "accept", "a list of"));
  EXPECT_TRUE(accepted(SceneText::good().set("accept", "[]")));
  EXPECT_TRUE(accepted(SceneText::good().set("accept", R"(["barus", "barus"])")));
}

// --- Shipped scenes

void expect_silent(const std::filesystem::path& folder, std::size_t least) {
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".toml") continue;
    ++files;
    const bool is_sweep = folder.filename() == "sweeps";
    const std::string path = file.path().string();
    const SceneReading reading = is_sweep ? SceneReading() : read_scene(path, SceneUse::speeds);
    const sweep::SweepReading of_sweep = is_sweep ? sweep::read_sweep(path) : sweep::SweepReading();
    EXPECT_EQ(of_sweep.sweep.has_value(), is_sweep) << path;
    const std::vector<Validity> passed =
        is_sweep ? of_sweep.passed : passed_limits(reading.scene.value());
    for (const Validity& limit : passed) ADD_FAILURE() << path << ": " << limit.word;
    if (is_sweep) continue;
    // A scene accepts only words that it passes, so that a later mistake in the scene is told.
    for (const std::string_view word : reading.scene->accepted) {
      Scene scene = *reading.scene;
      std::erase(scene.accepted, word);
      EXPECT_EQ(words_passed(scene), std::vector<std::string_view>{word}) << path;
    }
  }
  EXPECT_GE(files, least);
}

TEST(ShippedScenes, PassNothingThatTheyDoNotAccept) {
  const std::filesystem::path reference = TRIBOCHECK_SOURCE_DIR "/reference";
  expect_silent(reference / "published", 6);
  expect_silent(reference / "published" / "sweeps", 4);
  expect_silent(reference / "scenes", 4);
}

}  // namespace
}  // namespace tribo::scene_test
