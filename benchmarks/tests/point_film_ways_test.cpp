// SPDX-License-Identifier: Apache-2.0
// Ways to the film of a circle: those of textbooks find our film on the same grid.
#include "contenders/point_film_ways.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

#include "contenders/textbook_point_film.hpp"
#include "ehl/film_features.hpp"
#include "support/judge.hpp"
#include "sweep/on_threads.hpp"
#include "work_precision/measures.hpp"

namespace tribo::benchmarks {
namespace {

struct Films {
  ehl::PointContact contact;
  ehl::PointFilm coarse, ours;
};

Films films(double load_number, double material_number, int cells) {
  Films all{ehl::barus_point(load_number, material_number), {}, {}};
  all.coarse = ehl::solve_from_nothing(all.contact, ehl::grid_for(all.contact, cells / 2), {});
  all.ours = ehl::solve_on(all.contact, ehl::grid_for(all.contact, cells), all.coarse, {});
  return all;
}

double greatest_part(const ehl::PointFilm& got, const ehl::PointFilm& expected) {
  return ((got.film - expected.film).cwiseQuotient(expected.film)).cwiseAbs().maxCoeff();
}

TEST(PointFilmWays, OfADenseMatrixFindOurFilm) {
  for (const double material_number : {0., 5.}) {
    const Films all = films(20, material_number, 8);
    TextbookPointFilm textbook(all.contact, all.ours.grid);
    textbook.start_from(all.coarse);
    const ehl::PointFilm found = textbook.newton();
    EXPECT_EQ(found.outcome, ehl::Outcome::solved) << "L = " << material_number;
    EXPECT_LT(greatest_part(found, all.ours), 1e-5) << "L = " << material_number;
    const auto nodes = static_cast<std::size_t>(all.ours.grid.size());
    EXPECT_EQ(textbook.newton_bytes(), 2 * sizeof(double) * nodes * nodes);
  }
}

TEST(PointFilmWays, OfRelaxationFindOurFilmAndSayWhenTheyDoNot) {
  const Films all = films(20, 5, 8);
  TextbookPointFilm textbook(all.contact, all.ours.grid);
  textbook.start_from(all.coarse);
  EXPECT_EQ(textbook.relaxed(5).outcome, ehl::Outcome::not_converged);
  textbook.start_from(all.coarse);
  const ehl::PointFilm found = textbook.relaxed(1000);
  EXPECT_EQ(found.outcome, ehl::Outcome::solved);
  EXPECT_GT(found.steps, 50);
  EXPECT_LT(greatest_part(found, all.ours), 1e-3) << found.steps << " sweeps";
}

// Only the two coarsest ways of each series run. Their errors come from the grid.
TEST(PointFilmWays, OfEachSeriesAnswerTheContactsFilm) {
  const ehl::PointContact contact = ehl::barus_point(20, 5);
  const FilmAnswer fine =
      film_numbers(contact, ehl::solve_point_film(contact, {.tolerance = 3e-3}));
  std::map<std::string, int> asked;
  for (const FilmWay<ehl::PointContact>& way : point_film_ways(contact)) {
    if (++asked[way.series] > 2) continue;
    SCOPED_TRACE(way.name);
    const FilmAnswer got = way.run(contact);
    EXPECT_GT(got.steps, 0);
    for (const auto number :
         {&FilmAnswer::central, &FilmAnswer::minimum, &FilmAnswer::at_greatest_pressure})
      EXPECT_TRUE(verification::is_within(got.*number, fine.*number, 0.15 * fine.*number));
  }
  EXPECT_EQ(asked.size(), 4U);
}

TEST(PointFilmWays, AreJudgedByTheTableOfPointFilms) {
  const auto contacts = judged_points(45'000);
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_NEAR(contacts[0].exact.central, 3.2815, 0.01);
  EXPECT_NEAR(contacts[0].exact.minimum, 2.061, 0.02);
}

TEST(PointFilmGrowth, IsMeasuredOnEverFinerGridsOfBothSolvers) {
  const Rows rows = point_film_growth(5000);
  ASSERT_GT(rows.size(), 4U);
  EXPECT_EQ(rows[1].at("cells").get<double>(), 4 * rows[0].at("cells").get<double>());
  EXPECT_EQ(rows[0].at("solver"), rows[1].at("solver"));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_GT(rows[i].at("step_ns").get<double>(), 0) << rows[i];
    EXPECT_GE(rows[i].at("bytes").get<double>(), 0) << rows[i];
  }
}

TEST(PointFilmGrowth, IsMeasuredOnEachNumberOfThreadsThatHaveACore) {
  const Rows rows = point_films_on_threads(1);
  ASSERT_EQ(rows.size(), std::bit_width(static_cast<unsigned>(thread_count(0))));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at("threads"), 1 << i);
    EXPECT_GT(rows[i].at("ns").get<double>(), 0);
  }
}

}  // namespace
}  // namespace tribo::benchmarks
