// SPDX-License-Identifier: Apache-2.0
// reference/ehl/line_films.csv: it has every contact, keeps its errors, and comes out again; and
// the formulas that are held to it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "ehl/films.hpp"
#include "ehl/line_conditions.hpp"
#include "ehl/line_formulas.hpp"
#include "support/judge.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/moes_line.hpp"

namespace tribo::verification {
namespace {

// By the names of its columns.
using Row = std::map<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

std::vector<Row> table() {
  std::ifstream in(TRIBOCHECK_SOURCE_DIR "/reference/ehl/line_films.csv");
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    const std::vector<std::string> fields = fields_of(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < names.size() && i < fields.size(); ++i) row[names[i]] = fields[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

double number(const Row& row, const std::string& name) { return std::stod(row.at(name)); }

TEST(LineFilmTable, HasEveryContactToOneInTenThousandOrSaysWhyNot) {
  std::size_t i = 0;
  const std::vector<Row> rows = table();
  for (const double m : {1., 2., 5., 10., 20., 50., 100., 200.})
    for (const double l : {0., 1., 2.5, 5., 10., 15., 20.}) {
      ASSERT_LT(i, rows.size());
      const Row& row = rows[i++];
      ASSERT_EQ(number(row, "load_number"), m);
      ASSERT_EQ(number(row, "material_number"), l);
      for (const std::string film : {"central", "minimum", "at_greatest_pressure"})
        EXPECT_LE(number(row, film + "_error"), 1e-4 * number(row, film))
            << film << " at M = " << m << ", L = " << l;
      const bool has_spike = !row.at("spike_pressure").empty();
      EXPECT_NE(has_spike, !row.at("note").empty()) << "M = " << m << ", L = " << l;
    }
  EXPECT_EQ(i, rows.size());
}

TEST(LineFilmTable, SeededRowsComeOutAgainWithinBothErrors) {
  std::mt19937_64 random(20261123);
  const std::vector<Row> rows = table();
  ASSERT_FALSE(rows.empty());
  for (int i = 0; i < 10; ++i) {
    const Row& row = rows[random() % rows.size()];
    const ehl::LineContact contact =
        ehl::barus_contact(number(row, "load_number"), number(row, "material_number"));
    const ehl::SolvedFilm film = solved(contact);
    const auto is_same = [&](const ehl::Estimate& e, const std::string& name) {
      return is_estimated({contact.film_number(e.value), contact.film_number(e.error)},
                          number(row, name), number(row, name + "_error"));
    };
    EXPECT_TRUE(is_same(film.central, "central")) << row.at("load_number");
    EXPECT_TRUE(is_same(film.minimum, "minimum")) << row.at("load_number");
    EXPECT_TRUE(is_same(film.at_greatest_pressure, "at_greatest_pressure"))
        << row.at("load_number");
  }
}

TEST(LineFormulas, AreThoseOfTheModelInSi) {
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
  };
  for (int i = 0; i < 200; ++i) {
    const ehl::LineConditions c{.speed = between(1e-3, 50),
                                .viscosity = between(1e-3, 1),
                                .pressure_viscosity = between(1e-9, 4e-8),
                                .load_per_length = between(1e3, 1e6),
                                .effective_modulus = between(1e9, 3e11),
                                .radius = between(1e-3, 0.5)};
    const ehl::LineContact contact = ehl::contact_of(c);
    const double speed_number = ehl::scale_of(c).speed_number;
    for (const ehl::LineFormula& formula : ehl::line_formulas) {
      const double film =
          formula.law == nullptr
              ? moes_line(c.speed, c.viscosity, c.pressure_viscosity, c.load_per_length,
                          c.effective_modulus, c.radius)
              : line_film_thickness(*formula.law, c.speed, c.viscosity, c.pressure_viscosity,
                                    c.load_per_length, c.effective_modulus, c.radius);
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

// The contact by its numbers and the contact by its SI values are one.
TEST(LineConditions, GiveThePressureExponentOfBothNumbers) {
  const ehl::LineContact contact = ehl::contact_of({.speed = 1.3,
                                                    .viscosity = 0.04,
                                                    .pressure_viscosity = 2.1e-8,
                                                    .load_per_length = 2e5,
                                                    .effective_modulus = 1.13e11,
                                                    .radius = 0.012});
  const double exponent = ehl::pressure_exponent(contact.load_number, contact.material_number);
  EXPECT_TRUE(is_within(contact.fluid.exponent, exponent, 1e-13 * exponent));
}

}  // namespace
}  // namespace tribo::verification
