// SPDX-License-Identifier: Apache-2.0
// The tables of reference/ehl: line_films.csv has every contact; films of both tables are solved
// again and agree within the errors; and the formulas that are compared with the tables.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "ehl/film_conditions.hpp"
#include "ehl/films.hpp"
#include "ehl/line_formulas.hpp"
#include "support/judge.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/friction.hpp"
#include "tribo/moes_line.hpp"

namespace tribo::verification {
namespace {

std::vector<ReferenceRow> table() {
  return read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/ehl/line_films.csv");
}

// The films of a row come out again within both errors, and within `slack` of its value, as M and L
// of some rows are rounded.
void expect_again(const ReferenceRow& row, const ehl::LineContact& contact, double slack) {
  const ehl::SolvedFilm film = solved(contact);
  for (const auto& [number, name] :
       {std::pair{&ehl::SolvedFilm::central, "central"},
        {&ehl::SolvedFilm::minimum, "minimum"},
        {&ehl::SolvedFilm::at_greatest_pressure, "at_greatest_pressure"}}) {
    const ehl::Estimate& e = film.*number;
    const double value = row.number(name);
    EXPECT_TRUE(is_estimated({contact.film_number(e.value), contact.film_number(e.error)}, value,
                             row.number(std::string(name) + "_error") + slack * value))
        << name << " at M = " << row.text("load_number");
  }
}

TEST(LineFilmTable, HasEveryContactToOneInTenThousandOrSaysWhyNot) {
  std::size_t i = 0;
  const std::vector<ReferenceRow> rows = table();
  for (const double m : {1., 2., 5., 10., 20., 50., 100., 200.})
    for (const double l : {0., 1., 2.5, 5., 10., 15., 20.}) {
      ASSERT_LT(i, rows.size());
      const ReferenceRow& row = rows[i++];
      ASSERT_EQ(row.number("load_number"), m);
      ASSERT_EQ(row.number("material_number"), l);
      for (const std::string film : {"central", "minimum", "at_greatest_pressure"})
        EXPECT_LE(row.number(film + "_error"), 1e-4 * row.number(film))
            << film << " at M = " << m << ", L = " << l;
      const bool has_spike = !row.text("spike_pressure").empty();
      EXPECT_NE(has_spike, !row.text("note").empty()) << "M = " << m << ", L = " << l;
      // The second method solves each of them too.
      EXPECT_LE(row.number("second_method"), 1) << "M = " << m << ", L = " << l;
    }
  EXPECT_EQ(i, rows.size());
}

TEST(LineFilmTable, SeededRowsComeOutAgainWithinBothErrors) {
  std::mt19937_64 random(20261123);
  const std::vector<ReferenceRow> rows = table();
  ASSERT_FALSE(rows.empty());
  for (int i = 0; i < 10; ++i) {
    const ReferenceRow& row = rows[random() % rows.size()];
    const ehl::LineContact contact =
        ehl::barus_contact(row.number("load_number"), row.number("material_number"));
    expect_again(row, contact, 0);
  }
}

// The table's liquid stands in its header and, for the generator, in line_films.cpp. Here it is
// made of the speed number and the peak pressure of each row.
TEST(CompressibleFilmTable, SeededRowsComeOutAgainWithinBothErrors) {
  std::mt19937_64 random(20261124);
  const std::vector<ReferenceRow> rows =
      read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/ehl/line_films_compressible.csv");
  ASSERT_FALSE(rows.empty());
  constexpr double modulus = 115.4e9, radius = 0.02, coefficient = 2e-8, index = 0.6;
  const double viscosity = std::exp(coefficient * roelands_pressure<double>() / index -
                                    roelands_log_viscosity<double>());
  for (int i = 0; i < 6; ++i) {
    const ReferenceRow& row = rows[random() % rows.size()];
    const double speed_number = row.number("speed_number"), peak = row.number("peak_pressure");
    const ehl::LineContact contact =
        ehl::contact_of({.speed = speed_number * 2 * modulus * radius / viscosity,
                         .viscosity = viscosity,
                         .pressure_viscosity = coefficient,
                         .load = pi<double>() * peak * peak * radius / modulus,
                         .effective_modulus = modulus,
                         .radius = radius,
                         .viscosity_law = ViscosityLaw::roelands,
                         .density_law = ehl::FilmDensity::dowson_higginson});
    for (const auto& [got, name] : {std::pair{contact.load_number, "load_number"},
                                    {contact.material_number, "material_number"}})
      EXPECT_TRUE(is_within(got, row.number(name), 1e-5 * row.number(name))) << name;
    expect_again(row, contact, 1e-5);  // M and L have six digits
  }
}

TEST(LineFormulas, AreThoseOfTheModelInSi) {
  Sampler sampler(7);
  for (int i = 0; i < 200; ++i) {
    const ehl::FilmConditions c = random_conditions(sampler);
    const ehl::LineContact contact = ehl::contact_of(c);
    const double speed_number = ehl::scale_of(c).speed_number;
    for (const ehl::LineFormula& formula : ehl::line_formulas) {
      const double film =
          formula.law == nullptr
              ? moes_line(c.speed, c.viscosity, c.pressure_viscosity, c.load, c.effective_modulus,
                          c.radius)
              : line_film_thickness(*formula.law, c.speed, c.viscosity, c.pressure_viscosity,
                                    c.load, c.effective_modulus, c.radius);
      const double number =
          ehl::film_number(formula, contact.load_number, contact.material_number, speed_number);
      EXPECT_TRUE(is_within(number * c.radius * std::sqrt(2 * speed_number), film, 1e-12 * film))
          << formula.name;
    }
  }
}

TEST(LineFormulas, AreHeldToTheFilmThatTheirNameSays) {
  ehl::SolvedFilm film;
  film.central.value = 1;
  film.minimum.value = 2;
  film.at_greatest_pressure.value = 3;
  for (const ehl::LineFormula& formula : ehl::line_formulas) {
    const std::string name(formula.name);
    const double expected = name.ends_with("_central") ? 1 : name.ends_with("_minimum") ? 2 : 3;
    EXPECT_EQ(ehl::compared_film(formula, film).value, expected) << name;
  }
}

// The contact made of M and L and the contact made of SI values are the same.
TEST(LineConditions, GiveThePressureExponentOfBothNumbers) {
  const ehl::LineContact contact = ehl::contact_of({.speed = 1.3,
                                                    .viscosity = 0.04,
                                                    .pressure_viscosity = 2.1e-8,
                                                    .load = 2e5,
                                                    .effective_modulus = 1.13e11,
                                                    .radius = 0.012});
  const double exponent = ehl::pressure_exponent(contact.load_number, contact.material_number);
  EXPECT_TRUE(is_within(contact.fluid.exponent, exponent, 1e-13 * exponent));
}

}  // namespace
}  // namespace tribo::verification
