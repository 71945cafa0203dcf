// SPDX-License-Identifier: Apache-2.0
// Load sharing under the laws without fixed exponents and the law of Ertel and Grubin: the powers
// of γ, the root against a bisection, limits, and points alone and in batches.
#include "tribo/moes_film.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "support/judge.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contacts.hpp"
#include "tribo/onset.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::verification {
namespace {

using Long = long double;
constexpr std::array moes_forms{FilmForm::moes_line, FilmForm::nijenbanning_venner_moes};

const FilmLaw& law_of(FilmForm form) {
  return form == FilmForm::moes_line ? moes_line_law : nijenbanning_venner_moes_law;
}

// The film at 2U = 1e-12, E* = R = 1, and numbers M, L and D.
MoesFilm<Long> film_of(FilmForm form, Long m, Long l, Long d) {
  const Long twice_u = 1e-12L, root = std::sqrt(twice_u);
  const Long load = 2 * m * (form == FilmForm::moes_line ? root : root * std::sqrt(root));
  return {law_of(form), twice_u, l / (2 * std::sqrt(root)), load, 1, 1, d, 1};
}

Scene scene_of(FilmFormula film, double density = 1e11) {
  return scene_of_law(film, film_law(film).is_of_lines ? ContactShape::line : ContactShape::circle,
                      density);
}
constexpr std::array formulas_of_none{FilmFormula::nijenbanning_venner_moes, FilmFormula::moes_line,
                                      FilmFormula::ertel_grubin};

TEST(MoesFilm, IsTheFunctionOfTheCatalogueAtGammaUAndGOverGamma) {
  for (const Long gamma : {1.L, 1.7L, 40.L, 1e4L})
    for (const Long speed : {1e-3L, 0.2L, 5.L}) {
      const MoesFilm<Long> line(moes_line_law, 0.02L, 2e-8L, 1e5L * 0.0095L, 1.1e11L, 0.0095L, 1,
                                1e-7L);
      const Long of_line =
          moes_line<Long>(speed * gamma, 0.02L, 2e-8L / gamma, 1e5L, 1.1e11L, 0.0095L) / 1e-7L;
      EXPECT_TRUE(is_within(double(line.at(speed, gamma).film_parameter / of_line), 1, 1e-16));
      const MoesFilm<Long> point(nijenbanning_venner_moes_law, 0.02L, 2e-8L, 50, 1.1e11L, 0.0095L,
                                 0.5L, 1e-7L);
      const Long of_point = nijenbanning_venner_moes<Long>(speed * gamma, 0.02L, 2e-8L / gamma, 50,
                                                           1.1e11L, 0.0095L, 0.019L) /
                            1e-7L;
      EXPECT_TRUE(is_within(double(point.at(speed, gamma).film_parameter / of_point), 1, 1e-16));
    }
}

// The same change of U and G turns a film of fixed exponents into h₀γ^{a−b}: the λ of load_sharing.
TEST(MoesFilm, OfFixedExponentsWouldBeThatOfLoadSharing) {
  for (const NamedFilmLaw& named : named_film_laws) {
    if (!named.law->has_fixed_exponents()) continue;
    const auto film = [&](Long gamma) {
      return film_thickness<Long>(*named.law, 0.3L * gamma, 0.02L, 2e-8L / gamma, 50, 1.1e11L,
                                  0.01L, 1);
    };
    const Long power = std::pow(7.L, ratio<Long>(named.law->sharing_exponent));
    EXPECT_TRUE(is_within(double(film(7) / film(1) / power), 1, 1e-16)) << named.word;
  }
}

// Because of this, load sharing has one root, and a film has one speed.
TEST(MoesFilm, RisesWithGammaAndWithTheRootOfTheSpeed) {
  const auto visit = [](FilmForm form, Long d, Long m, Long l) {
    const auto film = film_of(form, m, l, d);
    const auto at = film.at(1, 1);
    EXPECT_GT(at.sharing_exponent, 0) << double(m) << ' ' << double(l);
    EXPECT_GE(at.speed_exponent, 0.5L) << double(m) << ' ' << double(l);
    EXPECT_GT(film.at(1, 1.01L).film_parameter, at.film_parameter);
    EXPECT_GE(film.at(1.01L, 1).film_parameter, at.film_parameter * std::sqrt(1.01L));
  };
  for (Long m = 1e-3L; m < 1e6L; m *= 1.5L)
    for (Long l = 1e-3L; l <= 100; l *= 2) {
      visit(FilmForm::moes_line, 1, m, l);
      for (const Long d : {0.01L, 0.125L, 1.L, 4.L, 8.L})
        visit(FilmForm::nijenbanning_venner_moes, d, m, l);
    }
  const auto beyond = film_of(FilmForm::nijenbanning_venner_moes, 26, 500, 0.125L).at(1, 1);
  EXPECT_LT(beyond.sharing_exponent, 0);  // as moes_film.hpp says of greater L
}

TEST(MoesFilm, HasTheSlopesOfItsDifferences) {
  for (const FilmForm form : moes_forms)
    for (const Long m : {0.01L, 1.L, 3.L, 40.L, 2000.L})
      for (const Long l : {0.1L, 2.L, 12.L}) {
        const auto log_film = [&](Long by_m, Long by_l) {
          return std::log(
              film_number<Long>(form, m * std::exp(by_m), l * std::exp(by_l), 0.4L).value);
        };
        constexpr Long step = 1e-5L;
        const FilmNumber<Long> at = film_number<Long>(form, m, l, 0.4L);
        EXPECT_TRUE(is_within(double((log_film(step, 0) - log_film(-step, 0)) / (2 * step)),
                              double(at.load_slope), 1e-9));
        EXPECT_TRUE(is_within(double((log_film(0, step) - log_film(0, -step)) / (2 * step)),
                              double(at.material_slope), 1e-9));
      }
}

TEST(MoesFilm, HasTheExponentsOfItsLimits) {
  // a and a − b of rigid and of elastic bodies, in liquids of constant and of rising viscosity
  const std::tuple<FilmForm, Long, Long, double, double> corners[] = {
      {FilmForm::moes_line, 1e-6L, 1e-12L, 1, 1},
      {FilmForm::moes_line, 1e12L, 1e-12L, 0.6, 0.6},
      {FilmForm::moes_line, 1e8L, 1e30L, 2. / 3, 0},
      {FilmForm::moes_line, 1e60L, 1e8L, 0.75, 0},
      {FilmForm::nijenbanning_venner_moes, 1e-6L, 1e-12L, 2, 2},
      {FilmForm::nijenbanning_venner_moes, 1e12L, 1e-12L, 0.6, 0.6},
      {FilmForm::nijenbanning_venner_moes, 1e8L, 1e30L, 2. / 3, 0},
      {FilmForm::nijenbanning_venner_moes, 1e60L, 1e8L, 0.75, 0}};
  for (const auto& [form, m, l, by_speed, by_gamma] : corners) {
    // At so small a D, H₀₀ = 1.8/D is far above EI.
    const auto at = film_of(form, m, l, 1e-9L).at(1, 1);
    EXPECT_TRUE(is_within(double(at.speed_exponent), by_speed, 1e-4)) << double(m);
    EXPECT_TRUE(is_within(double(at.sharing_exponent), by_gamma, 1e-4)) << double(m);
  }
}

TEST(NijenbanningVennerMoes, HasTheHandChecks) {
  EXPECT_TRUE(is_within(nijenbanning_venner_moes(1.0, 0.0202, 2e-8, 50.0, 107.9e9, 9.5e-3, 9.5e-3),
                        171.982e-9, 0.0005e-9));
  // For M → 0, HM²D is 41.3 for a circle. For a long contact it is 144.93; the fit has 145.
  const auto rigid = [](Long d) {
    return double(nijenbanning_venner_moes_number<Long>(1e-6L, 1e-12L, d) * 1e-12L * d);
  };
  EXPECT_TRUE(is_within(rigid(1), 41.3, 0.05));
  EXPECT_TRUE(is_within(rigid(1e-9L), 145, 0.01));
  // The other readings of the fit give thinner films there.
  EXPECT_LT(
      nijenbanning_venner_moes_number(50.0, 5.0, 1.0, MoesExponent::elastic_over_piezoviscous),
      0.95 * nijenbanning_venner_moes_number(50.0, 5.0, 1.0));
  EXPECT_LT(nijenbanning_venner_moes_number(50.0, 5.0, 1.0, MoesExponent::elastic_over_rigid,
                                            MoesBracket::three_halves_of_s),
            0.98 * nijenbanning_venner_moes_number(50.0, 5.0, 1.0));
}

// λ from a bisection on λ itself, with the film of the catalogue's functions.
Long root_by_bisection(const Scene& scene, const MixedContact<Long>& contact, Long speed) {
  const Lubricant& oil = scene.lubricant;
  const Bodies& bodies = scene.bodies;
  const Long modulus = bodies.effective_modulus, viscosity = oil.viscosity,
             alpha = oil.pressure_viscosity, load = scene.load;
  const auto film = [&](Long gamma) -> Long {
    if (scene.closures.film == FilmFormula::ertel_grubin)
      return line_film_thickness<Long>(ertel_grubin_law, speed * gamma, viscosity, alpha / gamma,
                                       load / bodies.length, modulus, bodies.radius_x);
    if (scene.closures.film == FilmFormula::moes_line)
      return moes_line<Long>(speed * gamma, viscosity, alpha / gamma, load / bodies.length, modulus,
                             bodies.radius_x);
    const Long r = bodies.reduced_radius;
    return nijenbanning_venner_moes<Long>(speed * gamma, viscosity, alpha / gamma, load, modulus, r,
                                          r);
  };
  const Long sd = contact.summit_height_sd();
  Long low = 0, high = 1e6;
  for (int i = 0; i < 200; ++i) {
    const Long middle = (low + high) / 2, share = contact.sharing().asperity_share(middle);
    const bool is_below = share >= 1 || middle < film(1 / (1 - share)) / sd;
    (is_below ? low : high) = middle;
  }
  return high;
}

TEST(MoesFilm, LoadSharingHasTheRootOfABisection) {
  int below_floor = 0, shared = 0;
  for (const FilmFormula formula : formulas_of_none)
    for (const double density : {1e9, 1e11, 2.9e11, 3.2e11, 2e12})
      for (const double speed : {1e-6, 1e-4, 0.01, 0.3, 3.0, 20.0}) {
        const Scene scene = scene_of(formula, density);
        const MixedContact<Long> contact(scene);
        const FloodedFilm<Long> film = contact.flooded(speed);
        const Long root = root_by_bisection(scene, contact, speed);
        EXPECT_TRUE(is_within(double(film.shares.film_parameter / root), 1, 1e-15))
            << describe_scene(scene) << speed;
        EXPECT_TRUE(is_within(double(film.shares.asperity + film.shares.fluid), 1, 1e-16));
        const FloodedFilm<double> in_double = MixedContact<double>(scene).flooded(speed);
        EXPECT_TRUE(is_within(in_double.shares.film_parameter, double(root), 1e-14 * double(root)));
        EXPECT_TRUE(is_within(in_double.shares.fluid, double(film.shares.fluid),
                              3e-13 * double(film.shares.fluid)));
        const Long free = contact.flooded_film_parameter(speed);
        const double speed_of_free =
            MixedContact<double>(scene).speed_at(static_cast<double>(free));
        EXPECT_TRUE(is_within(speed_of_free / speed, 1, 1e-11));
        if (free < contact.sharing().floor()) ++below_floor;
        if (film.shares.asperity > 0.01L && film.shares.fluid > 0.01L) ++shared;
        if (!(film.shares.fluid > 0)) continue;
        EXPECT_TRUE(is_within(double(contact.speed_at(film.shares) / Long(speed)), 1, 1e-11));
      }
  EXPECT_GE(below_floor, 15);
  EXPECT_GE(shared, 20);
}

TEST(ErtelGrubin, IsNotMovedByLoadSharing) {
  Scene scene = scene_of(FilmFormula::ertel_grubin, 2e12);
  scene.supply = {};
  const MixedContact<double> contact(scene);
  const double floor = contact.sharing().floor();
  ASSERT_GT(floor, 1);
  const OperatingPoint<double> slow = contact.solve(1e-3), fast = contact.solve(20);
  EXPECT_LT(contact.flooded_film_parameter(1e-3), floor);
  EXPECT_EQ(slow.film_flooded, floor * contact.summit_height_sd());
  EXPECT_EQ(slow.asperity_load_share, 1);
  EXPECT_EQ(slow.fluid_load_share, 0);
  EXPECT_GT(slow.friction, 0.13);
  EXPECT_GT(contact.flooded_film_parameter(20), floor);
  EXPECT_EQ(fast.film_flooded, contact.flooded_film_parameter(20) * contact.summit_height_sd());
  EXPECT_LT(fast.asperity_load_share, 1);
  // On the floor the film has no slope.
  const StribeckWalk<double> walk(contact);
  EXPECT_EQ(walk.at(std::log(1e-3)).film_slope, 0);
  EXPECT_TRUE(is_within(walk.at(std::log(20.)).film_slope, 8. / 11, 1e-15));
}

TEST(MoesFilm, PointsAreTheSameAloneAndInBatchesOfSpeedsAndOfContacts) {
  constexpr std::array speeds{1e-5, 1e-3, 0.05, 0.4, 2.0};
  MixedContacts contacts;
  std::vector<Scene> scenes;
  for (const FilmFormula formula : formulas_of_none)
    for (const double density : {1e11, 2e12}) scenes.push_back(scene_of(formula, density));
  for (const Scene& scene : scenes) contacts.add(scene);
  contacts.prepare();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const MixedContact<double> contact(scenes[i]);
    OperatingPoints of_speeds, of_contacts;
    of_speeds.resize(speeds.size(), OutputSet::all());
    of_contacts.resize(speeds.size(), OutputSet::all());
    solve(contact, speeds, OutputSet::all(), of_speeds);
    contacts.solve(std::vector<std::uint64_t>(speeds.size(), i), speeds, OutputSet::all(),
                   of_contacts);
    for (std::size_t j = 0; j < speeds.size(); ++j) {
      const auto alone = bits_of(contact.solve(speeds[j]));
      EXPECT_EQ(alone, bits_of(of_speeds[j]));
      EXPECT_EQ(alone, bits_of(of_contacts[j]));
    }
  }
}

// The film has no jump: a change of an input by 1e-6 of it changes the film by less than 1e-5.
TEST(MoesFilm, OfAPointIsContinuousInEachInput) {
  for (const FilmFormula formula : formulas_of_none)
    for (const double density : {1e11, 2.95e11, 2e12})
      for (const double speed : {1e-4, 0.05, 1.0}) {
        Scene scene = scene_of(formula, density);
        scene.supply = {};
        scene.speeds.list = {speed};
        const double film = MixedContact<double>(scene).solve(speed).film;
        for (const auto& [name, number] : numbers_of(scene)) {
          if (name == "across" && !film_law(formula).is_of_lines) continue;
          const double kept = *number;
          *number = kept * (1 + 1e-6);
          const double moved = MixedContact<double>(scene).solve(scene.speeds.list[0]).film;
          *number = kept;
          EXPECT_TRUE(is_within(moved / film, 1, 1e-5)) << name << describe_scene(scene);
        }
      }
}

TEST(MoesFilm, HasTheLeastFilmOfItsShapeAtEachSpeed) {
  for (const FilmFormula formula :
       {FilmFormula::nijenbanning_venner_moes, FilmFormula::moes_line}) {
    const Scene scene = scene_of(formula);
    const MixedContact<double> contact(scene);
    const auto numbers = detail::numbers_of<double>(scene);
    for (const double speed : {1e-3, 0.1, 3.0}) {
      const auto smooth = [&](const FilmLaw& law) {
        return smooth_film(law, scene.bodies.shape(), numbers, speed);
      };
      const FilmLaw& least = formula == FilmFormula::moes_line ? dowson_higginson_minimum_law
                                                               : hamrock_dowson_minimum_law;
      EXPECT_TRUE(is_within(SmoothContact(contact).minimum_film(speed, 1e-7),
                            1e-7 * smooth(least) / smooth(film_law(formula)), 1e-21));
    }
  }
}

}  // namespace
}  // namespace tribo::verification
