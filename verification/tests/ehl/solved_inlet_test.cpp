// SPDX-License-Identifier: Apache-2.0
// closures.starvation = "solved" (tribo/solved_inlet.hpp). The table goes through the rows of
// starved films, and agrees with films solved between the rows. The film lies between its limits,
// and rises with the layer. In double it is that of long double. Onsets are those of a dense sweep.
// Outside of the table there is no film.
#include "tribo/solved_inlet.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::verification {
namespace {

double film_ratio_between(double load_number, double material_number, double r) {
  const double exponent =
      solved_inlet_exponent(inlet_table(), std::log(load_number), material_number, std::log(r));
  return InletLaw<double>{StarvationClosure::damiens, exponent}.film_ratio(r);
}

struct Film {
  double value, error;
};

// Compares the film ratio ℛ of each starved row of the table `name` with the interpolated ℛ, to the
// rows' errors and `part` of ℛ. Leaves out rows without such an ℛ. Returns the number compared.
int hold_starved_rows(const std::string& name, double part) {
  std::map<std::pair<double, double>, Film> flooded;
  int held = 0;
  for (const char* const table : {"point_films", "point_films_between"})
    for (const ReferenceRow& row : read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/ehl/" +
                                                        std::string(table) + ".csv")) {
      if (row.number("radius_ratio") != 1 || row.text("central").empty()) continue;
      const double m = row.number("load_number"), l = row.number("material_number");
      const Film film{row.number("central"), row.number("central_error")};
      if (row.text("supply").empty()) {
        flooded[{m, l}] = film;
        continue;
      }
      const double r = 1 / row.number("supply"), got = film_ratio_between(m, l, r);
      if (table != name || std::isnan(got)) continue;
      const auto [whole, whole_error] = flooded.at({m, l});
      const double ratio = film.value / whole;
      const double error = ratio * (film.error / film.value + whole_error / whole);
      EXPECT_TRUE(is_within(got, ratio, error + part * ratio))
          << "M = " << m << ", L = " << l << ", r = " << r;
      ++held;
    }
  return held;
}

TEST(SolvedInlet, GoesThroughTheRows) { EXPECT_EQ(hold_starved_rows("point_films", 5e-4), 96); }

TEST(SolvedInlet, IsWithinItsErrorOfFilmsSolvedBetweenTheRows) {
  EXPECT_EQ(hold_starved_rows("point_films_between", solved_inlet_interpolation), 15);
}

// Checks each M, L and r on a grid three times as fine as the table's, which goes beyond its r.
template <class Check>
void for_each_place(const Check& check) {
  const InletTable& table = inlet_table();
  for (std::size_t i = 0; i <= 3 * table.load_steps; ++i)
    for (std::size_t j = 0; j <= 3 * table.material_steps; ++j)
      for (int k = -30; k <= static_cast<int>(3 * table.ratio_steps) + 30; ++k) {
        const double load =
            std::exp(table.first_load + table.load_step * static_cast<double>(i) / 3);
        const double material =
            table.first_material + table.material_step * static_cast<double>(j) / 3;
        const double r = std::exp(table.first_ratio + table.ratio_step * k / 3);
        if (load <= std::exp(table.last_load()) && material <= table.last_material())
          check(load, material, r);
      }
}

TEST(SolvedInlet, FilmsLieBetweenTheirLimitsAndRiseWithTheLayer) {
  int places = 0;
  for_each_place([&](double load, double material, double r) {
    const double y = film_ratio_between(load, material, r);
    if (std::isnan(y)) return;  // rounding takes M beyond the table's end
    if (r < 0.25 || r > 4) {
      EXPECT_GT(y, 0.97 * std::fmin(1, 1 / r)) << load << ' ' << material << ' ' << r;
    }
    const double more = film_ratio_between(load, material, r * 1.001);
    EXPECT_LT(y, std::fmin(1, 1 / r));
    EXPECT_GT(y, std::exp2(-1.0 / 2) * std::fmin(1, 1 / r));
    // As h_oil falls, the film falls, too, but by a smaller factor.
    EXPECT_LT(more, y) << load << ' ' << material << ' ' << r;
    EXPECT_GT(more * 1.001, y) << load << ' ' << material << ' ' << r;
    ++places;
  });
  EXPECT_GT(places, 400'000);
}

TEST(SolvedInlet, OutsideOfMAndLNothingIsKnown) {
  const InletTable& table = inlet_table();
  const double within_load = (table.first_load + table.last_load()) / 2, within_material = 5;
  const auto exponent = [&](double log_load, double material) {
    return solved_inlet_exponent(table, log_load, material, 0.0);
  };
  constexpr double bit = 1e-14;
  for (const double load : {table.first_load, table.last_load()}) {
    const double outwards = load < within_load ? -bit : bit;
    EXPECT_TRUE(std::isnan(exponent(load + outwards, within_material)));
    EXPECT_FALSE(std::isnan(exponent(load - outwards, within_material)));
  }
  for (const double material : {table.first_material, table.last_material()}) {
    const double outwards = material < within_material ? -bit : bit;
    EXPECT_TRUE(std::isnan(exponent(within_load, material + outwards)));
    EXPECT_FALSE(std::isnan(exponent(within_load, material - outwards)));
  }
  // For r outside of 1/4 to 4, γ is that of the nearer end.
  EXPECT_EQ(solved_inlet_exponent(table, within_load, within_material, 9.0),
            solved_inlet_exponent(table, within_load, within_material, table.last_ratio()));
}

Scene solved_scene(Supply supply, double density = 2.9e11) {
  Scene scene = scene_of_law(FilmFormula::solved, ContactShape::circle, density);
  scene.closures.starvation = StarvationClosure::solved;
  scene.supply = supply;
  return scene;
}

TEST(SolvedInlet, PointsHaveTheFilmOfTheTable) {
  int known = 0, unknown = 0;
  for (const double density : {1e9, 1e11, 2.9e11, 2e12})
    for (const Supply& supply :
         {Supply{SupplyKind::inlet_film, 2e-7}, Supply{SupplyKind::inlet_film_ratio, 3},
          Supply{SupplyKind::inlet_flow, 1e-7}})
      for (const double speed : {1e-3, 0.3, 0.7, 1.0, 2.0, 8.0, 60.0}) {
        const Scene scene = solved_scene(supply, density);
        SCOPED_TRACE(describe_scene(scene) + fmt::format(" at {} m/s", speed));
        const MixedContact<double> contact(scene);
        const MixedContact<long double> wide(scene);
        const OperatingPoint<double> point = contact.solve(speed);
        const auto expected = static_cast<double>(wide.solve(speed).film);
        ASSERT_EQ(std::isnan(point.film), std::isnan(expected));
        if (std::isnan(expected)) {
          ++unknown;
          continue;
        }
        ++known;
        EXPECT_TRUE(is_within(point.film, expected, 4e-15 * expected));
        const double twice_u = 0.0202 * speed / (107.9e9 * 9.5e-3);
        const double m = 50 / (2 * 107.9e9 * 9.5e-3 * 9.5e-3) / std::pow(twice_u, 0.75);
        const double l = 2 * 2e-8 * 107.9e9 * std::pow(twice_u, 0.25);
        const double r =
            point.film_flooded / (contact.inlet_film_parameter(speed) * contact.summit_height_sd());
        const double film = point.film_flooded * film_ratio_between(m, l, r);
        EXPECT_TRUE(is_within(point.film, film, 1e-13 * film));
        // complete() gives the same shares from a film and an inlet that are already known.
        const FloodedFilm<double> flooded = contact.flooded(speed);
        const OperatingPoint<double> completed =
            contact.complete(flooded, contact.inlet(flooded), OutputSet::all());
        EXPECT_TRUE(is_within(completed.asperity_load_share, point.asperity_load_share,
                              1e-12 * point.asperity_load_share));
      }
  EXPECT_GE(known, 30);
  EXPECT_GE(unknown, 24);
}

TEST(SolvedInlet, OnsetsAreThoseOfADenseSweep) {
  int maxima = 0, departures = 0;
  for (const Supply& supply :
       {Supply{SupplyKind::inlet_film, 5e-7}, Supply{SupplyKind::inlet_film_ratio, 8},
        Supply{SupplyKind::inlet_flow, 5e-8}, Supply{SupplyKind::inlet_flow, 2e-7}}) {
    const Scene scene = solved_scene(supply);
    SCOPED_TRACE(describe_scene(scene));
    const MixedContact<double> contact(scene);
    const Onset<double> top = onset(contact, scene, OnsetCriterion::film_maximum, 0.05);
    double greatest = 0, at = 0, last = 0, departure = 0;
    for (double u = 1e-3; u < 100; u *= 1.001) {
      const OperatingPoint<double> point = contact.solve(u);
      if (std::isnan(point.film)) continue;
      last = u;
      if (point.film > greatest) {
        greatest = point.film;
        at = u;
      }
      if (departure == 0 && point.film < 0.95 * point.film_flooded) departure = u;
    }
    const bool has_maximum = at < last / 1.002;
    ASSERT_EQ(top.exists, has_maximum) << top.reason;
    if (has_maximum) {
      EXPECT_TRUE(is_within(top.speed / at, 1, 0.0011));
      EXPECT_GE(top.film, greatest * (1 - 1e-12));
      ++maxima;
    } else {
      EXPECT_NE(top.reason.find("no maximum within"), std::string_view::npos) << top.reason;
    }
    const Onset<double> found = onset(contact, scene, OnsetCriterion::film_departure, 0.05);
    ASSERT_TRUE(found.exists) << found.reason;
    EXPECT_TRUE(is_within(found.speed / departure, 1, 0.0011));
    const OperatingPoint<double> point = contact.solve(found.speed);
    EXPECT_TRUE(is_within(point.film / point.film_flooded, 0.95, 1e-12));
    ++departures;
  }
  EXPECT_GE(maxima, 2);
  EXPECT_EQ(departures, 4);
}

TEST(SolvedInlet, HasNoOnsetOutsideOfTheTable) {
  for (const double ratio : {1e-3, 1e3}) {
    const Scene scene = solved_scene({SupplyKind::inlet_film_ratio, ratio});
    const Onset<double> none =
        onset(MixedContact<double>(scene), scene, OnsetCriterion::film_departure, 0.05);
    EXPECT_FALSE(none.exists) << none.speed;
    EXPECT_NE(none.reason.find("tables of M and L"), std::string_view::npos) << none.reason;
  }
}

}  // namespace
}  // namespace tribo::verification
