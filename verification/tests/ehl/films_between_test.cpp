// SPDX-License-Identifier: Apache-2.0
// closures.film = "solved" (tribo/solved_films.hpp): the table goes through the rows of solved
// films. Between the rows it agrees, within the interpolation's error, with films that are solved
// there. Load sharing has one root everywhere in the table. Outside of the table there is no film.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "ehl/films.hpp"
#include "ehl/solved_point.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::verification {
namespace {

constexpr std::array solved_laws{&solved_point_law, &solved_point_minimum_law, &solved_line_law,
                                 &solved_line_minimum_law};

double film_between(const FilmLaw& law, double load_number, double material_number) {
  return solved_film_number(film_table(law), std::log(load_number), material_number).value;
}

std::vector<ReferenceRow> rows_of(const std::string& name) {
  return read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/ehl/" + name + ".csv");
}

bool is_flooded_circle(const ReferenceRow& row) {
  return row.number("radius_ratio") == 1 && row.text("supply").empty();
}
// Flooded rows of L = 12.5 belong to starved films. The table of flooded films does not use them.
bool stands_apart(const ReferenceRow& row) { return row.number("material_number") == 12.5; }

// Compares both films of a row with those of the table, to the row's error and a part of the film.
// Returns whether the table has them.
bool hold(const FilmLaw& central, const FilmLaw& minimum, const ReferenceRow& row,
          double part_of_central, double part_of_minimum) {
  const double m = row.number("load_number"), l = row.number("material_number");
  for (const auto& [law, name, part] :
       {std::tuple{&central, "central", part_of_central}, {&minimum, "minimum", part_of_minimum}}) {
    const double between = film_between(*law, m, l);
    if (row.text(name).empty() || std::isnan(between)) return false;
    const double film = row.number(name);
    EXPECT_TRUE(is_within(between, film, row.number(std::string(name) + "_error") + part * film))
        << name << " at M = " << m << ", L = " << l;
  }
  return true;
}

TEST(FilmsBetween, GoThroughTheRows) {
  int points = 0, lines = 0;
  for (const ReferenceRow& row : rows_of("point_films"))
    if (is_flooded_circle(row) && !stands_apart(row) && row.number("load_number") >= 10)
      points += hold(solved_point_law, solved_point_minimum_law, row, 1e-4, 1e-4) ? 1 : 0;
  for (const char* const table : {"line_films", "line_films_between"})
    for (const ReferenceRow& row : rows_of(table))
      if (row.number("load_number") >= 2.25 && !(row.has("role") && row.text("role") == "check"))
        lines += hold(solved_line_law, solved_line_minimum_law, row, 1e-4, 1e-4) ? 1 : 0;
  EXPECT_EQ(points, 40);
  EXPECT_GE(lines, 75);
}

TEST(FilmsBetween, AreWithinTheirErrorOfFilmsSolvedBetweenTheRows) {
  int points = 0, lines = 0;
  std::vector<ReferenceRow> between = rows_of("point_films_between");
  for (const ReferenceRow& row : rows_of("point_films"))
    if (is_flooded_circle(row) && stands_apart(row)) between.push_back(row);
  for (const ReferenceRow& row : between) {
    if (!is_flooded_circle(row)) continue;
    // The rows have no L between 0 and 2.5.
    const double part = row.number("material_number") < 2.5 ? 25e-3 : solved_point_interpolation;
    points += hold(solved_point_law, solved_point_minimum_law, row, part,
                   solved_point_minimum_interpolation)
                  ? 1
                  : 0;
  }
  for (const ReferenceRow& row : rows_of("line_films_between"))
    if (row.text("role") == "check" && row.number("load_number") >= 2.25)
      lines += hold(solved_line_law, solved_line_minimum_law, row, solved_line_interpolation,
                    solved_line_minimum_interpolation)
                   ? 1
                   : 0;
  EXPECT_GE(points, 29);
  EXPECT_GE(lines, 7);
}

// Lines are solved fast: some are solved here, also at smaller L than in the test above.
TEST(FilmsBetween, AreWithinTheirErrorOfLinesThatAreSolvedHere) {
  constexpr std::pair<double, double> numbers[]{{7., 0.4},  {30., 0.5},  {120., 0.3}, {16., 6.},
                                                {60., 18.}, {150., 12.}, {3., 3.}};
  for (const auto& [m, l] : numbers) {
    const ehl::LineContact contact = ehl::barus_contact(m, l);
    const ehl::SolvedFilm film = solved(contact);
    const double unit = contact.film_number(1);
    for (const auto& [law, got, part] :
         {std::tuple{&solved_line_law, film.central, solved_line_interpolation},
          {&solved_line_minimum_law, film.minimum, solved_line_minimum_interpolation}})
      EXPECT_TRUE(is_within(film_between(*law, m, l), unit * got.value,
                            unit * (got.error + (l < 1 ? 2e-3 : part) * got.value)))
          << "M = " << m << ", L = " << l;
  }
}

// Two of the point films above that take little time come out again when they are solved here.
TEST(FilmsBetween, ThatWereSolvedComeOutAgain) {
  int solved_again = 0;
  std::vector<ReferenceRow> between = rows_of("point_films_between");
  for (const ReferenceRow& row : rows_of("point_films"))
    if (is_flooded_circle(row) && stands_apart(row)) between.push_back(row);
  for (const ReferenceRow& row : between) {
    if (!is_flooded_circle(row) || row.text("central").empty() || !(row.number("seconds") < 2) ||
        solved_again == 2)
      continue;
    const ehl::PointContact contact =
        ehl::barus_point(row.number("load_number"), row.number("material_number"));
    const ehl::SolvedPoint film = ehl::solve_point_film(contact);
    ASSERT_EQ(film.outcome, ehl::Outcome::solved) << film.reason;
    const double unit = ehl::numbers_of(contact).film_number;
    EXPECT_TRUE(is_estimated({unit * film.central.value, unit * film.central.error},
                             row.number("central"), row.number("central_error")));
    ++solved_again;
  }
  EXPECT_EQ(solved_again, 2);
}

// Because of these slopes load sharing has one root, and each film has one speed.
TEST(FilmsBetween, RiseWithGammaAndWithTheRootOfTheSpeed) {
  int known = 0;
  for (const FilmLaw* const law : solved_laws) {
    const FilmTable& table = film_table(*law);
    const double m = law->is_of_lines ? 0.5 : 0.75;
    for (int i = 0; i <= 300; ++i)
      for (int j = 0; j <= 300; ++j) {
        const double x = table.first_load + (table.last_load() - table.first_load) * i / 300;
        const double l = table.last_material() * j / 300;
        const FilmNumber<double> film = solved_film_number(table, x, l);
        if (std::isnan(film.value)) continue;
        ++known;
        const double by_speed = 0.5 - m * film.load_slope + film.material_slope / 4;
        EXPECT_GT(by_speed - film.material_slope, 0.01) << std::exp(x) << ' ' << l;
        EXPECT_GE(by_speed, 0.5) << std::exp(x) << ' ' << l;
        // The film rises with the viscosity under pressure. Only the least film may fall by 1e-3 of
        // itself next to L = 0. The least film falls with the load.
        EXPECT_GE(film.material_slope, law->form == FilmForm::solved || l > 0.5 ? 0 : -2e-2)
            << std::exp(x) << ' ' << l;
        if (law->form == FilmForm::solved_minimum) {
          EXPECT_LT(film.load_slope, 0) << std::exp(x) << ' ' << l;
        }
      }
  }
  EXPECT_GT(known, 300'000);
}

TEST(FilmsBetween, HaveTheSlopesOfTheirDifferences) {
  for (const FilmLaw* const law : solved_laws)
    for (const double m : {60., 111., 190.})
      for (const double l : {0.7, 3.3, 11.2}) {
        const auto log_film = [&](double by_m, double by_l) {
          return std::log(film_between(*law, m * std::exp(by_m), l * std::exp(by_l)));
        };
        constexpr double step = 1e-5;
        const FilmNumber<double> at = solved_film_number(film_table(*law), std::log(m), l);
        EXPECT_TRUE(
            is_within((log_film(step, 0) - log_film(-step, 0)) / (2 * step), at.load_slope, 1e-6));
        EXPECT_TRUE(is_within((log_film(0, step) - log_film(0, -step)) / (2 * step),
                              at.material_slope, 1e-6));
      }
}

constexpr std::array shapes{ContactShape::circle, ContactShape::line};

// Without summits the film of a scene is the table's, and its least film that of the other.
TEST(FilmsBetween, AreTheFilmsOfSmoothScenes) {
  for (const ContactShape shape : shapes) {
    Scene scene = scene_of_law(FilmFormula::solved, shape);
    scene.surface = {};
    scene.supply = {};
    const MixedContact<double> contact(scene);
    const bool is_line = shape == ContactShape::line;
    const double r = 9.5e-3, e = 107.9e9;
    for (const double speed : {0.15, 0.4, 1.1}) {
      const double twice_u = 0.0202 * speed / (e * r), root = std::sqrt(twice_u);
      const double w = 50 / (2 * e * r * (is_line ? 5e-4 : r));
      const double m = is_line ? w / root : w / (root * std::sqrt(root));
      const double l = 2 * 2e-8 * e * std::sqrt(root);
      const double film = r * root * film_between(film_law(scene), m, l);
      EXPECT_TRUE(is_within(contact.solve(speed).film, film, 1e-14 * film)) << speed;
      const double least = r * root * film_between(minimum_film_law(film_law(scene)), m, l);
      EXPECT_TRUE(
          is_within(SmoothContact(contact).minimum_film(speed, film), least, 1e-14 * least));
    }
  }
}

TEST(FilmsBetween, LoadSharingHasTheRootOfABisection) {
  int shared = 0, unknown = 0;
  for (const ContactShape shape : shapes)
    for (const double density : {1e9, 1e11, 2.9e11, 2e12})
      for (const double speed : {1e-6, 1e-4, 3e-3, 0.01, 0.05, 0.3, 3.0, 20.0}) {
        const Scene scene = scene_of_law(FilmFormula::solved, shape, density);
        const MixedContact<long double> contact(scene);
        const auto film =
            detail::moes_film(film_law(scene), shape, detail::numbers_of<long double>(scene),
                              contact.summit_height_sd());
        long double low = 0, high = 1e6;
        for (int i = 0; i < 200; ++i) {
          const long double middle = (low + high) / 2;
          const long double share = contact.sharing().asperity_share(middle);
          // NaN, where rows are missing, counts as below: there γ is greater than at the root.
          const bool is_below =
              share >= 1 || !(middle >= film.continued(speed, 1 / (1 - share)).film_parameter);
          (is_below ? low : high) = middle;
        }
        const LoadShares<double> found = MixedContact<double>(scene).flooded(speed).shares;
        const LoadShares<long double> wide = contact.flooded(speed).shares;
        EXPECT_EQ(std::isnan(found.film_parameter), std::isnan(wide.film_parameter))
            << describe_scene(scene) << speed;
        if (std::isnan(found.film_parameter)) {
          ++unknown;
          EXPECT_TRUE(std::isnan(MixedContact<double>(scene).solve(speed).film));
          continue;
        }
        const auto root = static_cast<double>(high);
        EXPECT_TRUE(is_within(found.film_parameter, root, 1e-14 * root)) << speed;
        EXPECT_TRUE(is_within(found.fluid, static_cast<double>(wide.fluid),
                              3e-13 * static_cast<double>(wide.fluid)));
        if (found.asperity > 0.01 && found.fluid > 0.01) ++shared;
      }
  EXPECT_GE(shared, 4);
  EXPECT_GE(unknown, 10);
}

// In a dense sweep h* is nowhere greater than at the onset, whether h_oil or the flow is constant.
TEST(FilmsBetween, OnsetsOfLawsWithoutFixedExponentsAreThoseOfADenseSweep) {
  int found = 0;
  for (const auto& [film, shape] :
       {std::pair{FilmFormula::nijenbanning_venner_moes, ContactShape::circle},
        {FilmFormula::moes_line, ContactShape::line},
        {FilmFormula::solved, ContactShape::circle},
        {FilmFormula::solved, ContactShape::line}})
    for (const SupplyKind supply : {SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow}) {
      Scene scene = scene_of_law(film, shape);
      scene.supply = {supply, supply == SupplyKind::inlet_flow ? 6e-8 : 8.};
      SCOPED_TRACE(describe_scene(scene));
      const MixedContact<double> contact(scene);
      const Onset<double> top = onset(contact, scene, OnsetCriterion::film_maximum, 0.05);
      ASSERT_TRUE(top.exists) << top.reason;
      double greatest = 0, at = 0;
      for (double u = top.speed / 3; u < top.speed * 3; u *= 1.001)
        if (const double h = contact.solve(u).film; h > greatest) {
          greatest = h;
          at = u;
        }
      EXPECT_TRUE(is_within(top.speed / at, 1, 0.0011));
      EXPECT_GE(top.film, greatest * (1 - 1e-12));
      const Onset<double> departure = onset(contact, scene, OnsetCriterion::film_departure, 0.05);
      ASSERT_TRUE(departure.exists) << departure.reason;
      const OperatingPoint<double> point = contact.solve(departure.speed);
      EXPECT_TRUE(is_within(point.film / point.film_flooded, 0.95, 1e-12));
      ++found;
    }
  EXPECT_EQ(found, 8);
}

TEST(FilmsBetween, HaveNoOnsetOutsideOfTheTable) {
  Scene scene = scene_of_law(FilmFormula::solved, ContactShape::circle);
  for (const double ratio : {1e-3, 1e3}) {
    scene.supply = {SupplyKind::inlet_film_ratio, ratio};
    const Onset<double> none =
        onset(MixedContact<double>(scene), scene, OnsetCriterion::film_departure, 0.05);
    EXPECT_FALSE(none.exists);
    EXPECT_NE(none.reason.find("tables of M and L"), std::string_view::npos) << none.reason;
  }
  scene.supply = {SupplyKind::inlet_flow, 1};
  const Onset<double> none =
      onset(MixedContact<double>(scene), scene, OnsetCriterion::film_departure, 0.05);
  EXPECT_FALSE(none.exists) << none.speed;
}

}  // namespace
}  // namespace tribo::verification
