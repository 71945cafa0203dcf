// SPDX-License-Identifier: Apache-2.0
// Solved films of circles and ellipses behind a layer of oil: conservation, limits, errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ehl/films.hpp"
#include "ehl/point_reynolds.hpp"
#include "ehl/solved_point.hpp"

namespace tribo::verification {
namespace {

constexpr double flooded_film = 4.8587;  // central, as film number, of M = 20, L = 10; ± 0.002

// L = 10 and M = `load`, behind a layer of `thickness` times `film`, which is a film number.
ehl::PointContact behind_a_layer(double thickness, double load = 20, double film = flooded_film) {
  ehl::PointContact contact = ehl::barus_point(load, 10);
  contact.inlet_film = thickness * film / ehl::numbers_of(contact).film_number;
  return contact;
}

// The film from as many grids as `nodes` allow, whatever its errors are.
ehl::SolvedPoint solved_point(const ehl::PointContact& contact, Eigen::Index nodes = 25'000) {
  ehl::SolvedPoint film =
      ehl::solve_point_film(contact, {.tolerance = 1e-2, .greatest_nodes = nodes});
  EXPECT_EQ(film.outcome, ehl::Outcome::solved) << film.reason;
  return film;
}

// Central film over the flooded one.
double film_ratio(const ehl::PointContact& contact) {
  return solved_point(contact).central.value * ehl::numbers_of(contact).film_number / flooded_film;
}

// As much liquid as the layer brings leaves behind the contact, where only drag moves it. Where
// there is pressure the gap is full, and no node has more liquid than it can hold.
TEST(StarvedPoint, LosesNoLiquid) {
  for (const double thickness : {0.5, 1.5}) {
    const ehl::PointContact contact = behind_a_layer(thickness);
    const ehl::PointFilm film = solved_point(contact).film;
    const ehl::PlaneGrid& grid = film.grid;
    const int last = grid.count_x() - 2;
    double in = 0, out = 0, dry = 0;
    const ehl::PlaneBalance balance =
        ehl::balance_of(contact, grid, film.pressure, film.film, film.missing, false);
    for (int j = 0; j + 1 < grid.count_y(); ++j) {
      const double breadth = grid.area(j) / grid.dx;
      in += breadth * contact.inlet_film;
      EXPECT_EQ(film.pressure[grid.node(last, j)], 0);
      out += breadth * (1.5 * film.film[grid.node(last, j)] -
                        0.5 * film.film[grid.node(last - 1, j)] - film.missing[grid.node(last, j)]);
      for (int i = 0; i <= last; ++i) {
        const Eigen::Index n = grid.node(i, j);
        EXPECT_TRUE(is_within(balance.surplus[n], 0, 1e-7)) << i << ", " << j;
        EXPECT_GE(film.missing[n], 0);
        EXPECT_TRUE(film.pressure[n] == 0 || film.missing[n] < 1e-6) << i << ", " << j;
        if (film.missing[n] > 0) dry += breadth;
      }
    }
    EXPECT_TRUE(is_within(out, in, 1e-7 * in)) << "a layer of " << thickness;
    EXPECT_GT(dry, in);  // the gap is not full everywhere
  }
}

// A thin layer becomes the film, a thick one nearly floods; a thicker layer makes a thicker film.
TEST(StarvedPoint, FilmLiesBelowTheLayerAndTheFloodedFilm) {
  double before = 0;
  for (const double thickness : {0.15, 0.5, 1.5}) {
    const double ratio = film_ratio(behind_a_layer(thickness));
    EXPECT_LT(ratio, std::min(thickness * 1.003, 1.)) << thickness;
    EXPECT_GT(ratio, before) << thickness;
    before = ratio;
    if (thickness < 0.2) {
      EXPECT_TRUE(is_within(ratio, thickness, 0.02 * thickness));
    }
  }
  EXPECT_GT(before, 0.85);
}

// Where a contact is far longer than wide, nothing flows to the sides: a layer that is thinner than
// the flooded film passes the middle whole. In a circle a part of it is pressed aside.
TEST(StarvedPoint, OfALongEllipseLetsTheWholeLayerPass) {
  std::array<double, 2> passed{};
  for (const double ratio : {1., 16.}) {
    ehl::PointContact contact = ehl::barus_point(50, 5, ratio);
    constexpr Eigen::Index nodes = 400'000;
    const ehl::SolvedPoint flooded = solved_point(contact, nodes);
    contact.inlet_film = 0.75 * flooded.central.value;
    passed[ratio > 1 ? 1 : 0] = solved_point(contact, nodes).central.value / contact.inlet_film;
  }
  EXPECT_LT(passed[0], 0.92);
  EXPECT_TRUE(is_within(passed[1], 1, 0.02));
}

// The films from four grids lie within the stated errors of the films from three grids.
TEST(StarvedPoint, ErrorsHoldAgainstAFinerGrid) {
  const auto on = [](Eigen::Index nodes, int grids) {
    ehl::SolvedPoint film =
        ehl::solve_point_film(behind_a_layer(1), {.tolerance = 1e-9, .greatest_nodes = nodes});
    EXPECT_EQ(film.outcome, ehl::Outcome::solved) << film.reason;
    EXPECT_EQ(film.grids, grids);
    EXPECT_EQ(film.domain_error, 0);
    return film;
  };
  const ehl::SolvedPoint coarse = on(10'000, 3), fine = on(40'000, 4);
  for (const auto member : {&ehl::SolvedPoint::central, &ehl::SolvedPoint::minimum,
                            &ehl::SolvedPoint::at_greatest_pressure})
    EXPECT_TRUE(is_estimated(coarse.*member, (fine.*member).value, 0));
}

// On three grids Richardson's values of the least film agree to 6e-5. The fourth grid lowers the
// value by three times as much.
TEST(StarvedPoint, ErrorHoldsWhereRichardsonsValuesAgreeByChance) {
  ehl::PointContact contact = ehl::barus_point(71.1702, 7.8085);
  contact.inlet_film = 1.03073 * ehl::expected_film(contact);
  const ehl::SolvedPoint film = solved_point(contact, 20'000);
  EXPECT_EQ(film.grids, 3);
  EXPECT_TRUE(is_estimated(film.minimum, 0.077373, 2e-6));
}

// Beside the contact the edge of the liquid lies along whole rows of nodes. If a step dried only a
// few nodes of such a row, each grid would take twenty steps.
TEST(StarvedPoint, DriesARowInFewSteps) {
  ehl::PointContact contact = ehl::barus_point(500, 5);
  contact.inlet_film = 2.802 / ehl::numbers_of(contact).film_number;  // the flooded film
  const ehl::SolvedPoint film = solved_point(contact, 40'000);
  EXPECT_EQ(film.grids, 3);
  EXPECT_LE(film.steps, 40);
}

TEST(SolvePointFilm, RefusesALayerThatFloodsTheContactOrIsAllOfTheFilm) {
  for (const double thickness : {1e-300, 0.03, 8., 1e6, 1e300}) {
    const ehl::SolvedPoint film = ehl::solve_point_film(behind_a_layer(thickness));
    EXPECT_EQ(film.outcome, ehl::Outcome::not_converged);
    EXPECT_EQ(film.steps, 0);
    EXPECT_NE(film.reason.find("layers of 0.05 to 6 times its thickness are solved"),
              std::string::npos)
        << film.reason;
  }
  EXPECT_TRUE(solved_point(behind_a_layer(1.4)).reason.empty());
}

}  // namespace
}  // namespace tribo::verification
