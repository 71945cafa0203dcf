// SPDX-License-Identifier: Apache-2.0
// The tables of reference/ehl. line_films.csv and point_films.csv have every contact. Some films
// are solved again and agree within the errors. The formulas that are compared with the tables are
// checked, too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "ehl/film_conditions.hpp"
#include "ehl/films.hpp"
#include "ehl/line_formulas.hpp"
#include "ehl/solved_point.hpp"
#include "support/judge.hpp"
#include "support/temporary_folder.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/friction.hpp"
#include "tribo/moes_line.hpp"

namespace tribo::verification {
namespace {

std::vector<ReferenceRow> table() {
  return read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/ehl/line_films.csv");
}

// Expects the films of a row to be these, times `unit`, within both errors and `slack` times the
// value. `slack` is above 0 if M and L of the row are rounded.
template <class Solved>
void expect_again(const ReferenceRow& row, const Solved& film, double unit, double slack) {
  for (const auto& [number, name] : {std::pair{&Solved::central, "central"},
                                     {&Solved::minimum, "minimum"},
                                     {&Solved::at_greatest_pressure, "at_greatest_pressure"}}) {
    const ehl::Estimate& e = film.*number;
    const double value = row.number(name);
    EXPECT_TRUE(is_estimated({unit * e.value, unit * e.error}, value,
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
    expect_again(row, solved(contact), contact.film_number(1), 0);
  }
}

// A contact follows from the speed number and the peak pressure of its row. The constants of the
// liquid are also in the table's header and, for the generator, in line_films.cpp.
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
    expect_again(row, solved(contact), contact.film_number(1), 1e-5);  // M and L have six digits
  }
}

std::string point_file() { return TRIBOCHECK_SOURCE_DIR "/reference/ehl/point_films.csv"; }

constexpr double supplies[] = {0.25, 0.35, 0.5, 0.7, 1, 1.4, 2, 4};

struct PointKey {
  double radius_ratio, load_number, material_number;
  double supply = 0;  // ρ; 0: flooded

  auto operator<=>(const PointKey&) const = default;
  PointKey flooded() const { return {radius_ratio, load_number, material_number}; }
  ehl::PointContact contact() const {
    return ehl::barus_point(load_number, material_number, radius_ratio);
  }
};

// The rows by their contacts.
std::map<PointKey, ReferenceRow> point_table() {
  std::map<PointKey, ReferenceRow> rows;
  for (const ReferenceRow& row : read_reference_table(point_file())) {
    const bool is_flooded = row.text("supply").empty();
    const PointKey key{row.number("radius_ratio"), row.number("load_number"),
                       row.number("material_number"), is_flooded ? 0 : row.number("supply")};
    EXPECT_TRUE(rows.emplace(key, row).second);
    EXPECT_EQ(is_flooded, !(key.supply > 0)) << row.text("supply");
  }
  return rows;
}

std::map<PointKey, ReferenceRow> flooded_points() {
  std::map<PointKey, ReferenceRow> rows = point_table();
  std::erase_if(rows, [](const auto& one) { return one.first.supply > 0; });
  return rows;
}

TEST(PointFilmTable, HasEveryContactToItsErrorOrSaysWhyNot) {
  const std::map<PointKey, ReferenceRow> rows = point_table();
  const std::string text = content_of(point_file());
  const std::size_t place = text.find("# missing: ");
  ASSERT_NE(place, std::string::npos);
  const std::string missing = text.substr(place, text.find('\n', place) - place) + " ";
  std::vector<PointKey> plan;
  for (const double m : {5., 10., 20., 50., 100., 200., 500., 1000., 2000.})
    for (const double l : {0., 2.5, 5., 10., 15.}) plan.push_back({1, m, l});
  for (const double ratio : {0.25, 0.5, 2., 4., 8.})
    for (const double m : {20., 200.})
      for (const double l : {5., 10.}) plan.push_back({ratio, m, l});
  for (const double m : {20., 100., 500., 2000.}) {
    plan.push_back({1, m, 12.5});
    for (const double l : {2.5, 5., 12.5})
      for (const double supply : supplies) plan.push_back({1, m, l, supply});
  }
  std::size_t present = 0;
  for (const PointKey& key : plan) {
    const std::string name = fmt::format("{},{},{},{}", key.radius_ratio,
                                         key.supply > 0 ? fmt::format("{}", key.supply) : "",
                                         key.load_number, key.material_number);
    const auto found = rows.find(key);
    EXPECT_NE(found != rows.end(), missing.find(" " + name + " ") != std::string::npos) << name;
    if (found == rows.end()) continue;
    ++present;
    const ReferenceRow& row = found->second;
    const std::string& note = row.text("note");
    EXPECT_GT(row.number("seconds"), 0) << name;
    if (row.text("central").empty()) {
      EXPECT_TRUE(note.starts_with("no film was found")) << name << ": " << note;
      continue;
    }
    EXPECT_LT(row.number("minimum"), row.number("central")) << name;
    // The solver's bounds; the errors in the table have two digits.
    const bool is_heavy = key.load_number > 1000 && key.supply > 0;
    const double allowed = is_heavy ? 8e-3 : key.load_number > 200 ? 3e-3 : 1e-3;
    double worst = 0;
    for (const auto& [film, share] :
         {std::pair{std::string("central"), 1.}, {std::string("minimum"), 3.}})
      worst = std::fmax(worst, row.number(film + "_error") / (share * allowed * row.number(film)));
    EXPECT_EQ(note, "") << name << ": a contact misses its tolerance";
    EXPECT_LE(worst, 1.05) << name;
  }
  EXPECT_EQ(present, rows.size());
}

// The ratio ℛ of the starved central film to the flooded one lies between 2/3 min(ρ, 1) and
// min(ρ, 1), rises with the supply, and has at most the contract's error.
TEST(PointFilmTable, StarvedFilmsRiseWithTheLayerTowardsTheFloodedFilm) {
  const std::map<PointKey, ReferenceRow> rows = point_table();
  std::size_t starved = 0;
  std::map<PointKey, double> before;  // ℛ of the thinner layer
  for (const auto& [key, row] : rows) {
    if (!(key.supply > 0)) continue;
    ++starved;
    const std::string name =
        fmt::format("M = {}, L = {}, rho = {}", key.load_number, key.material_number, key.supply);
    const ReferenceRow& flooded = rows.at(key.flooded());
    const double ratio = row.number("central") / flooded.number("central");
    const double off = ratio * (row.number("central_error") / row.number("central") +
                                flooded.number("central_error") / flooded.number("central"));
    const bool is_close = key.load_number <= 200 && key.supply <= 2;
    if (row.text("note").empty()) {
      EXPECT_LE(off, is_close ? 3e-3 : 1e-2) << name;
    }
    const double most = std::fmin(key.supply, 1);
    EXPECT_GT(ratio, 2 * most / 3) << name;
    EXPECT_LT(ratio, most + off) << name;
    if (key.supply == supplies[0]) {
      EXPECT_GT(ratio, 0.98 * key.supply - off) << name;
    }
    double& last = before[key.flooded()];
    EXPECT_GT(ratio, last) << name;
    last = ratio;
  }
  EXPECT_EQ(starved, 96U);
}

// Moes' film numbers of circles fall with the load: that of the least film always, that of the
// central film where the load flattens the bodies (from M = 20 on). The film numbers of circles and
// ellipses rise with the viscosity under pressure.
TEST(PointFilmTable, FilmsFallWithTheLoadAndRiseWithTheViscosityUnderPressure) {
  const std::map<PointKey, ReferenceRow> rows = flooded_points();
  int compared = 0;
  for (const auto& [key, row] : rows)
    for (const auto& [other, beside] : rows) {
      const bool is_more_load = key.material_number == other.material_number &&
                                key.radius_ratio == 1 && other.radius_ratio == 1 &&
                                key.load_number < other.load_number;
      const bool is_more_viscous = key.load_number == other.load_number &&
                                   key.radius_ratio == other.radius_ratio &&
                                   key.material_number > other.material_number;
      if (!(is_more_load || is_more_viscous)) continue;
      for (const char* film : {"central", "minimum"}) {
        if (row.text(film).empty() || beside.text(film).empty()) continue;
        if (is_more_load && key.load_number < 20 && std::string(film) == "central") continue;
        ++compared;
        EXPECT_GT(row.number(film), beside.number(film))
            << film << " of M = " << key.load_number << ", L = " << key.material_number
            << " and of M = " << other.load_number << ", L = " << other.material_number;
      }
    }
  EXPECT_GT(compared, 200);
}

// The films of both methods agree within both errors. The README tells their greatest differences.
// Only rows that the second method solved have a number in the column second_method.
TEST(PointFilmTable, SecondMethodAgreesWithinBothErrorsAndAsTheReadmeSays) {
  const std::map<PointKey, ReferenceRow> rows = flooded_points();
  std::size_t circles = 0, ellipses = 0, compared = 0;
  double central = 0, minimum = 0;
  for (const ReferenceRow& second :
       read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/ehl/point_films_second_method.csv")) {
    const PointKey key{second.number("radius_ratio"), second.number("load_number"),
                       second.number("material_number")};
    const std::string name = fmt::format("R_y/R_x = {}, M = {}, L = {}", key.radius_ratio,
                                         key.load_number, key.material_number);
    ASSERT_TRUE(rows.contains(key)) << name;
    const ReferenceRow& first = rows.at(key);
    ++(key.radius_ratio == 1 ? circles : ellipses);
    for (const auto& [film, most] : {std::pair{"central", &central}, {"minimum", &minimum}}) {
      const std::string error = std::string(film) + "_error";
      EXPECT_TRUE(is_estimated({second.number(film), second.number(error)}, first.number(film),
                               first.number(error)))
          << film << " film of " << name;
      *most = std::fmax(*most, std::fabs(second.number(film) / first.number(film) - 1));
    }
    // Errors so great that every film agrees would show nothing.
    EXPECT_LE(second.number("central_error"), 0.01 * second.number("central")) << name;
    const double off = second.number("central") / first.number("central") - 1;
    EXPECT_TRUE(is_within(first.number("second_method"), off, 0.06 * std::fabs(off)))  // two digits
        << name;
  }
  for (const auto& [key, row] : rows) compared += !row.text("second_method").empty();
  EXPECT_EQ(compared, circles + ellipses);
  const std::string sentence = fmt::format(
      "{} circles, M from 10 to 100, L from 0 to 5, and {} ellipses, R_y/R_x from 2 to 8 at M = 20 "
      "and L = 5, their central film is within {:.2f} % and their least film within {:.1f} %",
      circles, ellipses, 100 * central, 100 * minimum);
  EXPECT_NE(content_of(TRIBOCHECK_SOURCE_DIR "/model/README.md").find(sentence), std::string::npos)
      << sentence;
}

TEST(PointFilmTable, SeededCheapRowsComeOutAgainWithinBothErrors) {
  std::mt19937_64 random(20261127);
  std::vector<std::pair<PointKey, ReferenceRow>> cheap;
  for (const auto& [key, row] : flooded_points())
    if (!row.text("central").empty() && row.number("seconds") < 2) cheap.emplace_back(key, row);
  ASSERT_GT(cheap.size(), 3U);
  for (int i = 0; i < 2; ++i) {
    const auto& [key, row] = cheap[random() % cheap.size()];
    const ehl::SolvedPoint film = ehl::solve_point_film(key.contact());
    ASSERT_EQ(film.outcome, ehl::Outcome::solved) << film.reason;
    expect_again(row, film, ehl::numbers_of(key.contact()).film_number, 0);
  }
}

// The range of a law's deviations from the table as text: "−3 to +5 %".
std::string range_of(const FilmLaw& law, const char* film, bool (*is_taken)(const PointKey&)) {
  constexpr double speed_number = 1e-11;  // U, on which the laws depend a little at given M and L
  const double root = std::sqrt(2 * speed_number);
  double least = INFINITY, most = -INFINITY;
  for (const auto& [key, row] : flooded_points()) {
    if (row.text(film).empty() || !(key.material_number > 0) || !is_taken(key)) continue;
    // In units of η₀ = E* = R_x = 1.
    const double length =
        film_thickness(law, 2 * speed_number, 1., key.material_number / (2 * std::sqrt(root)),
                       2 * key.load_number * root * std::sqrt(root), 1., 1.,
                       ehl::numbers_of(key.contact()).ellipticity);
    const double off = 100 * (length / (row.number(film) * root) - 1);
    least = std::fmin(least, off);
    most = std::fmax(most, off);
  }
  const auto signed_text = [](double off) {
    return (off < 0 ? "−" : "+") + fmt::format("{:.0f}", std::abs(off));
  };
  return signed_text(least) + " to " + signed_text(most) + " %";
}

TEST(PointFilmTable, HamrockAndDowsonsLawsAreOffByWhatTheReadmeSays) {
  const std::string readme = content_of(TRIBOCHECK_SOURCE_DIR "/model/README.md");
  for (const auto& [words, is_taken] :
       {std::pair{
            "circles, M up to 10",
            +[](const PointKey& key) { return key.radius_ratio == 1 && key.load_number <= 10; }},
        {"circles, M from 20 on",
         +[](const PointKey& key) { return key.radius_ratio == 1 && key.load_number >= 20; }},
        {"ellipses across the motion", +[](const PointKey& key) { return key.radius_ratio > 1; }},
        {"ellipses along it", +[](const PointKey& key) { return key.radius_ratio < 1; }}}) {
    const std::string row = fmt::format("| {} | {} | {} |", words,
                                        range_of(hamrock_dowson_central_law, "central", is_taken),
                                        range_of(hamrock_dowson_minimum_law, "minimum", is_taken));
    EXPECT_NE(readme.find(row), std::string::npos) << row;
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
