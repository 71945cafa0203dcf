// SPDX-License-Identifier: Apache-2.0
// The code's formulas for point films are compared with the printed ones, computed in logarithms,
// and with each other.
#include "ehl/point_formulas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "support/judge.hpp"
#include "tribo/film_thickness.hpp"

namespace tribo::verification {
namespace {

// Steel with a mineral oil.
ehl::FilmConditions contact_of(double speed, double load, double radius_ratio) {
  return {.speed = speed,
          .viscosity = 0.04,
          .pressure_viscosity = 2.1e-8,
          .load = load,
          .effective_modulus = 113e9,
          .radius = 8e-3,
          .radius_ratio = radius_ratio};
}

std::vector<ehl::FilmConditions> contacts() {
  std::vector<ehl::FilmConditions> made;
  for (const double speed : {0.05, 1., 12.})
    for (const double load : {5., 400.})
      for (const double ratio : {0.4, 1., 2.5, 9.}) made.push_back(contact_of(speed, load, ratio));
  return made;
}

double film_by(std::string_view name, const ehl::FilmConditions& c) {
  for (const ehl::PointFormula& formula : ehl::point_formulas)
    if (formula.name == name) return ehl::film_thickness(formula, c);
  ADD_FAILURE() << "no formula is named " << name;
  return std::nan("");
}

std::string words(const ehl::FilmConditions& c) {
  return "u = " + std::to_string(c.speed) + " m/s, F = " + std::to_string(c.load) +
         " N, R_y/R_x = " + std::to_string(c.radius_ratio);
}

TEST(PointFormulas, AreChittendensInLogarithms) {
  // Here the ratio k of the axes of Hertz' ellipse is from Hamrock and Brewe's fit. The error of
  // the fit is below 3 %, and changes the film by at most 2 %.
  const auto printed = [](double constant, double decay, double side,
                          const ehl::FilmConditions& c) {
    const double modulus = 2 * c.effective_modulus;
    const double log_film = std::log(constant) +
                            0.68 * std::log(c.viscosity * c.speed / (modulus * c.radius)) +
                            0.49 * std::log(c.pressure_viscosity * modulus) -
                            0.073 * std::log(c.load / (modulus * c.radius * c.radius));
    return c.radius * std::exp(log_film) * (1 - std::exp(-decay * side));
  };
  for (const ehl::FilmConditions& c : contacts()) {
    SCOPED_TRACE(words(c));
    const double radii = std::pow(c.radius_ratio, 2. / 3), k = std::pow(c.radius_ratio, 2 / M_PI);
    const double central = printed(4.31, 1.23, radii, c), minimum = printed(3.68, 0.67, radii, c);
    const double of_axes = printed(4.30, 1.28, k, c);
    EXPECT_TRUE(is_within(film_by("chittenden_central_431", c), central, 1e-12 * central));
    EXPECT_TRUE(is_within(film_by("chittenden_minimum_368", c), minimum, 1e-12 * minimum));
    EXPECT_TRUE(is_within(film_by("chittenden_central_430", c), of_axes,
                          (c.radius_ratio == 1 ? 1e-12 : 0.02) * of_axes));
  }
}

// The powers of U, G and W are those of Hamrock and Dowson's least film, so that for circles the
// ratio to that film is constant. For long ellipses the ratio of the two central films is that of
// their constants.
TEST(PointFormulas, OfChittendenAreOneMultipleOfHamrockAndDowsonsLeastFilm) {
  for (const ehl::FilmConditions& c : contacts()) {
    SCOPED_TRACE(words(c));
    if (c.radius_ratio != 1) continue;
    const double least =
        tribo::film_thickness(hamrock_dowson_minimum_law, c.speed, c.viscosity,
                              c.pressure_viscosity, c.load, c.effective_modulus, c.radius, 1.);
    EXPECT_TRUE(is_within(film_by("chittenden_minimum_368", c) / least, 1.003312, 1e-6));
    EXPECT_TRUE(is_within(film_by("chittenden_central_431", c) / least, 1.703100, 1e-6));
    EXPECT_TRUE(is_within(film_by("chittenden_central_430", c) / least, 1.733374, 1e-6));
  }
  const ehl::FilmConditions line = contact_of(1, 50, 1e4);
  EXPECT_TRUE(
      is_within(film_by("chittenden_central_431", line) / film_by("chittenden_central_430", line),
                4.31 / 4.30, 1e-12));
}

TEST(PointFormulas, OfNijenbanningAreAllReadingsButTheDefault) {
  for (const ehl::FilmConditions& c : contacts()) {
    SCOPED_TRACE(words(c));
    const auto reading = [&](MoesExponent exponent, MoesBracket bracket) {
      return nijenbanning_venner_moes(c.speed, c.viscosity, c.pressure_viscosity, c.load,
                                      c.effective_modulus, c.radius, c.radius_ratio * c.radius,
                                      exponent, bracket);
    };
    using enum MoesExponent;
    using enum MoesBracket;
    EXPECT_EQ(film_by("nijenbanning_three_halves_of_s", c),
              reading(elastic_over_rigid, three_halves_of_s));
    EXPECT_EQ(film_by("nijenbanning_ei_over_ep", c),
              reading(elastic_over_piezoviscous, three_halves));
    EXPECT_EQ(film_by("nijenbanning_ei_over_ep_of_s", c),
              reading(elastic_over_piezoviscous, three_halves_of_s));
  }
}

TEST(PointFormulas, OfALiquidOfConstantViscosityAreNijenbanningsAlone) {
  ehl::FilmConditions c = contact_of(1, 50, 2), thickened = c;
  c.pressure_viscosity = 0;
  thickened.pressure_viscosity = 1e-20;
  for (const ehl::PointFormula& formula : ehl::point_formulas) {
    const double film = ehl::film_thickness(formula, c);
    EXPECT_EQ(std::isnan(film), formula.law != nullptr) << formula.name;
    if (formula.law == nullptr) {
      EXPECT_TRUE(is_within(film, ehl::film_thickness(formula, thickened), 1e-9 * film))
          << formula.name;
    }
  }
}

}  // namespace
}  // namespace tribo::verification
