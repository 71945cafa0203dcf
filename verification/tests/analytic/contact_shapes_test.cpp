// SPDX-License-Identifier: Apache-2.0
// Scenes of ellipses and lines: their limits, their film laws, and what follows from two bodies and
// from spectral moments.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/condition.hpp"
#include "support/film_laws.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/onset.hpp"

namespace tribo::verification {
namespace {

Scene with_bodies(const Bodies& bodies, FilmFormula film) {
  Scene scene = paper_scene(PaperSurface::medium);
  scene.bodies = bodies;
  scene.bodies.effective_modulus = 107.9e9;
  scene.closures.film = film;
  return scene;
}
Scene ellipse_scene(double ratio, FilmFormula film = FilmFormula::hamrock_dowson_central) {
  Bodies bodies;
  bodies.radius_x = 9.5e-3;
  bodies.radius_y = ratio * 9.5e-3;
  return with_bodies(bodies, film);
}
Scene line_scene(double length = 5e-4, FilmFormula film = FilmFormula::dowson_toyoda_central) {
  Bodies bodies;
  bodies.radius_x = 9.5e-3;
  bodies.length = length;
  return with_bodies(bodies, film);
}

// A scene for every film law, with a contact of the shape that the law is for.
std::vector<Scene> scenes_of_all_laws() {
  std::vector<Scene> all;
  for (std::size_t i = 0; i < film_formula_words.size(); ++i) {
    const auto film = static_cast<FilmFormula>(i);
    if (film_law(film).is_solved()) continue;  // there is no solved film of an ellipse
    all.push_back(film_law(film).is_of_lines ? line_scene(5e-4, film) : ellipse_scene(3, film));
  }
  return all;
}

TEST(ContactShapes, HertzIsThatOfTheHandChecks) {
  const HertzContact<double> ellipse = MixedContact<double>(ellipse_scene(2)).hertz();
  EXPECT_TRUE(is_within(ellipse.semi_axis_x, 131.855e-6, 5e-10));
  EXPECT_TRUE(is_within(ellipse.semi_axis_y, 209.097e-6, 5e-10));
  EXPECT_TRUE(is_within(ellipse.peak_pressure, 0.865897e9, 500));
  EXPECT_TRUE(is_within(ellipse.approach, 2.06561e-6, 5e-12));
  const HertzContact<double> line = MixedContact<double>(line_scene()).hertz();
  EXPECT_TRUE(is_within(line.semi_axis_x, 105.878e-6, 5e-10));
  EXPECT_TRUE(is_within(line.peak_pressure, 0.601276e9, 500));
  EXPECT_EQ(line.semi_axis_y, 2.5e-4);
}

TEST(ContactShapes, FilmsAreThoseOfTheTable) {
  for (const auto& [film, nanometres] : films_of_table_one) {
    const Scene scene =
        film_law(film).is_of_lines ? line_scene(5e-4, film) : ellipse_scene(1, film);
    const double h0 =
        MixedContact<double>(scene).flooded_film_parameter(1) * scene.surface.summit_height_sd;
    EXPECT_TRUE(is_within(h0 * 1e9, nanometres, 5e-4))
        << film_formula_words[static_cast<std::size_t>(film)];
  }
}

TEST(ContactShapes, EllipseOfEqualRadiiIsTheCircle) {
  for (const double speed : {1e-3, 0.05, 1.0}) {
    const Scene round = paper_scene(PaperSurface::medium);
    const auto circle = numbers_of(MixedContact<double>(round).solve(speed));
    const auto ellipse = numbers_of(MixedContact<double>(ellipse_scene(1)).solve(speed));
    const Conditions conditions = conditions_at(round, speed);
    for (std::size_t k = 0; k < number_count; ++k) {
      EXPECT_TRUE(keeps(operating_point_contract, ellipse[k], circle[k], conditions[k], 1,
                        {{"speed", speed}}))
          << output_infos[k].name;
    }
  }
}

TEST(ContactShapes, EllipseNearTheCircleIsContinuous) {
  const double there = MixedContact<double>(ellipse_scene(1)).solve(0.1).friction;
  for (const double step : {1e-12, 1e-9, 1e-6})
    for (const double ratio : {1 + step, 1 - step})
      EXPECT_TRUE(is_within(MixedContact<double>(ellipse_scene(ratio)).solve(0.1).friction / there,
                            1, 2 * step + 1e-14));
}

TEST(ContactShapes, LinesOfTwiceTheLengthAndLoadAreTheSameLine) {
  Scene scene = line_scene(), twice = line_scene(1e-3);
  twice.load = 2 * scene.load;
  for (const double speed : {1e-3, 0.05, 0.2}) {
    const OperatingPoint<double> here = MixedContact<double>(scene).solve(speed);
    const OperatingPoint<double> there = MixedContact<double>(twice).solve(speed);
    EXPECT_TRUE(is_within(there.film / here.film, 1, 1e-14));
    EXPECT_TRUE(is_within(there.asperity_load_share / here.asperity_load_share, 1, 1e-13));
    EXPECT_TRUE(is_within(there.friction / here.friction, 1, 1e-13));
    EXPECT_TRUE(is_within(there.summit_count / here.summit_count, 2, 1e-12));
  }
}

TEST(ContactShapes, FilmsOfEachLawHaveItsExponents) {
  for (Scene scene : scenes_of_all_laws()) {
    const FilmLaw& law = film_law(scene.closures.film);
    if (!law.has_fixed_exponents()) continue;  // analytic.MoesFilm checks those exponents
    const MixedContact<double> contact(scene);
    const double slope =
        std::log2(contact.flooded_film_parameter(2) / contact.flooded_film_parameter(1));
    EXPECT_TRUE(is_within(slope, law.speed_power.value, 1e-14));
    scene.supply = {};
    const MixedContact<double> flooded(scene);
    int shared = 0;
    for (const double u : {0.003, 0.01, 0.03}) {
      const OperatingPoint<double> point = flooded.solve(u);
      if (point.fluid_load_share > 0.99) continue;
      ++shared;
      EXPECT_TRUE(is_within(std::log(flooded.flooded_film_parameter(u) / point.film_parameter) /
                                std::log(point.fluid_load_share),
                            law.sharing_power.value, 1e-11));
    }
    EXPECT_GT(shared, 0);
  }
}

// The exponents come from differences of the contact's own films: h₀ by u and by α, h by 1 − A.
TEST(FilmLaw, SceneThatNamesTheMinimumFilmHasItsExponents) {
  Scene scene = paper_scene(PaperSurface::rough);
  scene.supply = {};
  scene.closures.film = FilmFormula::hamrock_dowson_minimum;
  const MixedContact<double> contact(scene);
  EXPECT_EQ(&contact.film(), &hamrock_dowson_minimum_law);
  const double slope =
      std::log(contact.flooded_film_parameter(2) / contact.flooded_film_parameter(1)) / std::log(2);
  EXPECT_TRUE(is_within(slope, 0.68, 1e-14));
  scene.lubricant.pressure_viscosity *= 2;
  const double with_twice = MixedContact<double>(scene).flooded_film_parameter(1);
  scene.lubricant.pressure_viscosity /= 2;
  EXPECT_TRUE(is_within(std::log(with_twice / contact.flooded_film_parameter(1)) / std::log(2),
                        0.49, 1e-14));
  for (const double u : {0.003, 0.03, 0.3}) {
    const OperatingPoint<double> point = contact.solve(u);
    ASSERT_LT(point.fluid_load_share, 0.99);
    EXPECT_TRUE(is_within(std::log(contact.flooded_film_parameter(u) / point.film_parameter) /
                              std::log(point.fluid_load_share),
                          0.19, 1e-12));
    EXPECT_LT(point.film,
              MixedContact<double>(paper_scene(PaperSurface::rough)).solve(u).film_flooded);
  }
}

// A walk gives its points without a root, the engine by one. Their films and onsets have to agree.
TEST(FilmLaw, WalkAndOnsetAgreeWithTheRootUnderTheMinimumFilm) {
  Sampler sampler(76);
  int onsets = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene = random_scene(sampler);
    scene.closures.film = scene.bodies.shape() == ContactShape::line
                              ? FilmFormula::dowson_higginson_minimum
                              : FilmFormula::hamrock_dowson_minimum;
    const MixedContact<Reference> exact(scene);
    const MixedContact<double> contact(scene);
    const StribeckWalk<Reference> walk(exact);
    const Reference log_speed = log(Reference(scene.speeds.list[0]));
    const WalkPoint<Reference> point = walk.at(
        walk.walk_to(walk.near(Reference(scene.speeds.list[0])), log_speed, Reference("0.01")));
    const Reference root = exact.flooded(point.flooded.speed).shares.film_parameter;
    EXPECT_TRUE(abs(root / point.flooded.shares.film_parameter - 1) < Reference("1e-40"));
    const Onset<Reference> here =
        onset(exact, scene, OnsetCriterion::film_departure, ratio<Reference>(5, 100));
    const Onset<double> there = onset(contact, scene, OnsetCriterion::film_departure, 0.05);
    ASSERT_EQ(here.exists, there.exists);
    if (!here.exists || here.film_parameter < 1) continue;
    ++onsets;
    EXPECT_TRUE(is_within(there.speed / static_cast<double>(here.speed), 1, 1e-10));
  }
  EXPECT_GT(onsets, 10);
}

// In a dense sweep h* is nowhere greater than at the closed form's speed, apart from the error of a
// finite step.
TEST(ContactShapes, OnsetsOfEachLawAreThoseOfADenseSweep) {
  int found = 0;
  for (Scene scene : scenes_of_all_laws())
    for (const StarvationClosure closure :
         {StarvationClosure::flooded_inlet, StarvationClosure::printed_exponents}) {
      scene.closures.starvation = closure;
      const MixedContact<double> contact(scene);
      const Onset<double> onset_there = onset(contact, scene, OnsetCriterion::film_maximum, 0.05);
      ASSERT_EQ(onset_there.exists, true) << onset_there.reason;
      double greatest = 0, at = 0;
      for (double u = onset_there.speed / 50; u < onset_there.speed * 50; u *= 1.001)
        if (const double film = contact.solve(u).film; film > greatest) {
          greatest = film;
          at = u;
        }
      EXPECT_TRUE(is_within(onset_there.speed / at, 1, 0.0011));
      EXPECT_TRUE(is_within(onset_there.film / greatest, 1, 1e-5));
      EXPECT_GE(onset_there.film, greatest * (1 - 1e-12));
      const Onset<double> departure = onset(contact, scene, OnsetCriterion::film_departure, 0.05);
      ASSERT_EQ(departure.exists, true);
      const OperatingPoint<double> point = contact.solve(departure.speed);
      EXPECT_TRUE(is_within(point.film / point.film_flooded, 0.95, 1e-12));
      ++found;
    }
  EXPECT_EQ(found, 22);
}

TEST(ContactShapes, TwoBodiesAreTheirModulusAndRadii) {
  Scene given = paper_scene(PaperSurface::medium);
  given.bodies = {};
  given.bodies.bodies = {Body{206e9, 0.3, 5e-3, 5e-3}, Body{310e9, 0.26, 22.5e-3, -5.2e-3}};
  const auto numbers = detail::numbers_of<double>(given);
  EXPECT_TRUE(
      is_within(numbers.effective_modulus / effective_modulus(206e9, 0.3, 310e9, 0.26), 1, 1e-15));
  const ReducedRadius<double> radii = reduced_radius(5e-3, 22.5e-3, 5e-3, -5.2e-3);
  EXPECT_TRUE(is_within(numbers.radius_x / radii.radius_x, 1, 4e-16));
  EXPECT_TRUE(is_within(numbers.across / radii.radius_y, 1, 4e-16));
  Scene simple = given;
  simple.bodies = {};
  simple.bodies.effective_modulus = numbers.effective_modulus;
  simple.bodies.radius_x = numbers.radius_x;
  simple.bodies.radius_y = numbers.across;
  EXPECT_EQ(MixedContact<double>(given).solve(0.1).friction,
            MixedContact<double>(simple).solve(0.1).friction);
}

TEST(ContactShapes, SummitsFollowFromTheProfile) {
  for (const AsperityModel model : asperity_models) {
    Scene given = paper_scene(PaperSurface::medium, model);
    given.surface = {};
    given.surface.moments = {2.5e-15, 2e-4, 3e8};
    const auto numbers = detail::numbers_of<double>(given);
    const Summits<double> one = summits_from_spectral_moments(2.5e-15, 2e-4, 3e8);
    const double rise = model == AsperityModel::greenwood_tripp ? std::numbers::sqrt2 : 1;
    EXPECT_TRUE(is_within(numbers.summit_height_sd / one.summit_height_sd, rise, 1e-15));
    EXPECT_TRUE(is_within(numbers.summit_plane_offset / one.summit_plane_offset, 1 / rise, 1e-15));
    // (D_d/σ_s) nβσ_s is 1/(4π√3) for every isotropic Gaussian face.
    EXPECT_TRUE(is_within(numbers.summit_plane_offset * numbers.summit_density *
                              numbers.summit_radius * numbers.summit_height_sd,
                          1 / (4 * std::numbers::pi * std::numbers::sqrt3), 1e-16));
  }
}

}  // namespace
}  // namespace tribo::verification
