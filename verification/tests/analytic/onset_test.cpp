// SPDX-License-Identifier: Apache-2.0
// Onset of starvation: closed forms against dense sweeps of the solved model, and the reasons where
// there is no onset.
#include "tribo/onset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/judge.hpp"
#include "support/scenes.hpp"

namespace tribo::verification {
namespace {

using enum OnsetCriterion;
using enum StarvationClosure;

Onset<double> onset_of(const Scene& scene, OnsetCriterion criterion, double departure = 0.05) {
  return onset(MixedContact<double>(scene), scene, criterion, departure);
}

// The solved points at which a number is less, beyond rounding, than at the speeds before and
// after. Each speed is `step` times the one before. The first and the last speed never count.
template <class Number>
std::vector<OperatingPoint<double>> swept_minima(const Scene& scene, double from, double to,
                                                 double step, double rounding, Number&& number) {
  const MixedContact<double> contact(scene);
  std::vector<OperatingPoint<double>> minima;
  double before = -std::numeric_limits<double>::infinity();
  OperatingPoint<double> here = contact.solve(from);
  for (double u = from; u < to; u *= step) {
    const OperatingPoint<double> next = contact.solve(u);
    const double bound = number(here) + std::abs(number(here)) * rounding;
    if (bound < before && bound < number(next)) minima.push_back(here);
    before = number(here);
    here = next;
  }
  return minima;
}
double minus_film(const OperatingPoint<double>& point) { return -point.film; }
double friction(const OperatingPoint<double>& point) { return point.friction; }
std::vector<OperatingPoint<double>> swept_film_maxima(const Scene& scene, double from, double to) {
  return swept_minima(scene, from, to, 1.0005, 1e-12, minus_film);
}
OperatingPoint<double> greatest_film(const std::vector<OperatingPoint<double>>& points) {
  return *std::max_element(points.begin(), points.end(),
                           [](const auto& a, const auto& b) { return a.film < b.film; });
}

TEST(Onset, FilmMaximumIsThatOfADenseSweep) {
  for (const auto closure : starvation_closures)
    for (const auto supply : {SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow})
      for (const int planes : {1, 2})
        for (const PaperSurface surface : paper_surfaces) {
          Scene scene = starved_scene(surface, closure, supply);
          scene.surface.offset_planes = planes;
          SCOPED_TRACE(describe_scene(scene));
          const Onset<double> found = onset_of(scene, film_maximum);
          const std::vector<OperatingPoint<double>> maxima = swept_film_maxima(scene, 1e-4, 20);
          EXPECT_EQ(found.exists, !maxima.empty()) << found.reason;
          if (!found.exists || maxima.empty()) continue;
          const OperatingPoint<double> swept = greatest_film(maxima);
          EXPECT_TRUE(is_within(found.speed / swept.speed, 1, 0.0011));
          EXPECT_GE(found.film * (1 + 1e-14), swept.film);
          EXPECT_TRUE(is_within(found.film / swept.film, 1, 1e-6));
          // the closed form and the solved point are one point
          const OperatingPoint<double> solved = MixedContact<double>(scene).solve(found.speed);
          EXPECT_TRUE(is_close(solved.film, found.film, 1e-13, {{"u", found.speed}}));
        }
}

// If starvation sets in over many decades of r (a small γ) and asperities carry nearly all of the
// load up to λ = δ, the film has two maxima: one below that λ and one above.
TEST(Onset, FilmMaximumAtConstantFlowIsTheGreatestOfSeveral) {
  constexpr std::array<std::pair<double, bool>, 2> flows{{{0.0111, true}, {0.0249, false}}};
  for (const auto& [flow, first_is_greatest] : flows) {
    Scene scene = paper_scene(PaperSurface::smooth, AsperityModel::greenwood_williamson);
    scene.surface.summit_plane_offset = 8;
    scene.surface.summit_density *=
        0.99 / MixedContact<double>(scene).sharing().asperity_share(0);  // A(0) = 0.99
    scene.closures = {.asperity = AsperityModel::greenwood_williamson,
                      .starvation = damiens,
                      .damiens_exponent = 0.04};
    scene.supply = {SupplyKind::inlet_flow, flow};
    const std::vector<OperatingPoint<double>> maxima = swept_film_maxima(scene, 0.01, 100);
    ASSERT_EQ(maxima.size(), 2U) << flow;
    EXPECT_EQ(maxima[0].film > maxima[1].film, first_is_greatest) << flow;
    const Onset<double> found = onset_of(scene, film_maximum);
    const OperatingPoint<double> greatest = greatest_film(maxima);
    EXPECT_TRUE(is_within(found.speed / greatest.speed, 1, 0.005)) << flow;
    EXPECT_GE(found.film * (1 + 1e-14), greatest.film) << flow;
  }
}

TEST(Onset, DepartureIsWhereTheSolvedFilmHasLostItsShare) {
  for (const auto closure : starvation_closures)
    for (const auto supply : {SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow})
      for (const double departure : {0.01, 0.05, 0.3}) {
        const Scene scene = starved_scene(PaperSurface::medium, closure, supply);
        const Onset<double> found = onset_of(scene, film_departure, departure);
        ASSERT_TRUE(found.exists) << found.reason;
        const OperatingPoint<double> solved = MixedContact<double>(scene).solve(found.speed);
        EXPECT_TRUE(is_within(solved.film / solved.film_flooded, 1 - departure, 1e-12));
        EXPECT_TRUE(is_close(solved.film, found.film, 1e-12, {{"u", found.speed}}));
      }
}

TEST(Onset, FrictionMinimumIsThatOfADenseSweep) {
  for (const auto model : asperity_models)
    for (const PaperSurface surface : paper_surfaces) {
      const Scene scene = paper_scene(surface, model);
      const MixedContact<double> contact(scene);
      const Onset<double> found = onset_of(scene, friction_minimum);
      double lowest = 1e9, at = 0;
      for (double u = 1e-4; u < 3; u *= 1.001) {
        const OperatingPoint<double> p = contact.solve(u);
        if (p.friction < lowest) lowest = p.friction, at = u;
      }
      ASSERT_TRUE(found.exists);
      EXPECT_TRUE(is_within(found.speed / at, 1, 0.002));
      EXPECT_LE(contact.solve(found.speed).friction, lowest * (1 + 1e-14));
    }
}

// With little boundary friction, load that passes from asperities to the fluid raises friction: a
// maximum separates the minimum of mixed lubrication from others near the greatest film.
TEST(Onset, FrictionMinimumIsTheLowestOfSeveral) {
  constexpr std::array<std::pair<double, bool>, 2> slide_roll_ratios{
      {{0.001, true}, {0.01, false}}};
  for (const auto& [slide_roll_ratio, first_is_lowest] : slide_roll_ratios) {
    Scene scene = paper_scene(PaperSurface::medium);
    scene.friction = {.boundary_coefficient = 0.01,
                      .slide_roll_ratio = slide_roll_ratio,
                      .fluid = FluidShear::limiting};
    // A collapsed film has no friction, and no minimum beside it.
    const std::vector<OperatingPoint<double>> minima =
        swept_minima(scene, scene.speeds.from, scene.speeds.to, 1.001, 1e-11, friction);
    ASSERT_GE(minima.size(), 2U) << slide_roll_ratio;
    const auto place =
        std::min_element(minima.begin(), minima.end(),
                         [](const auto& a, const auto& b) { return a.friction < b.friction; });
    EXPECT_EQ(place == minima.begin(), first_is_lowest) << slide_roll_ratio;
    const OperatingPoint<double>& lowest = *place;
    const Onset<double> found = onset_of(scene, friction_minimum);
    EXPECT_TRUE(is_within(found.speed / lowest.speed, 1, 0.002)) << slide_roll_ratio;
    EXPECT_LE(MixedContact<double>(scene).solve(found.speed).friction,
              lowest.friction * (1 + 1e-14));
  }
}

TEST(Onset, FrictionMinimumOfAListIsThatOfItsRangeInAnyOrder) {
  Scene scene = paper_scene(PaperSurface::smooth);
  const Onset<double> of_range = onset_of(scene, friction_minimum);
  for (const std::vector<double>& list :
       {std::vector{1e-4, 0.5, 3.0}, std::vector{0.5, 3.0, 1e-4}, std::vector{3.0, 1e-4, 0.5}}) {
    scene.speeds = {list, 0, 0, 0, Spacing::log};
    const Onset<double> found = onset_of(scene, friction_minimum);
    EXPECT_EQ(found.exists, true) << found.reason;
    EXPECT_EQ(found.speed, of_range.speed);
  }
}

TEST(Onset, AsperityMinimumIsTheFilmMaximum) {
  const Scene scene = paper_scene(PaperSurface::smooth);
  const Onset<double> film = onset_of(scene, film_maximum);
  const Onset<double> asperities = onset_of(scene, asperity_minimum);
  EXPECT_EQ(film.speed, asperities.speed);
  const MixedContact<double> contact(scene);
  const double least = contact.solve(film.speed).asperity_load_share;
  for (double u = 1e-3; u < 0.4; u *= 1.01)
    EXPECT_GE(contact.solve(u).asperity_load_share, least * (1 - 1e-14)) << describe({{"u", u}});
}

TEST(Onset, SaysWhyThereIsNone) {
  Scene flooded = paper_scene(PaperSurface::smooth), no_friction = flooded, one_speed = flooded;
  flooded.supply = {};
  no_friction.friction.boundary_coefficient.reset();
  one_speed.speeds.list = {0.1};
  Scene on_floor = paper_scene(PaperSurface::rough);
  on_floor.surface.offset_planes = 2;
  // GW with two planes: λ = 1.43 at the film maximum is below the floor of 1.62
  Scene all_asperities = paper_scene(PaperSurface::rough, AsperityModel::greenwood_williamson);
  all_asperities.surface.offset_planes = 2;
  EXPECT_TRUE(onset_of(all_asperities, film_maximum).exists);
  struct Row {
    Scene scene;
    OnsetCriterion criterion;
    std::string_view part_of_reason;
  };
  for (const Row& row :
       {Row{flooded, film_maximum, "fully flooded"}, Row{flooded, film_departure, "fully flooded"},
        Row{flooded, asperity_minimum, "fully flooded"},
        Row{starved_scene(PaperSurface::smooth, damiens), film_maximum, "without a maximum"},
        Row{on_floor, film_departure, "floor"}, Row{all_asperities, asperity_minimum, "whole load"},
        Row{no_friction, friction_minimum, "boundary_coefficient"},
        Row{one_speed, friction_minimum, "range"}}) {
    const Onset<double> found = onset_of(row.scene, row.criterion);
    EXPECT_FALSE(found.exists);
    EXPECT_EQ(found.speed, 0);
    EXPECT_EQ(found.film, 0);
    EXPECT_EQ(found.film_parameter, 0);
    EXPECT_NE(found.reason.find(row.part_of_reason), std::string::npos) << row.part_of_reason;
  }
}

TEST(Onset, FrictionOnAPlateauHasNoMinimum) {
  // Asperities alone and no sliding: μ = μ_b at every speed.
  Scene scene = paper_scene(PaperSurface::rough, AsperityModel::greenwood_williamson);
  scene.surface.offset_planes = 2;
  scene.supply.value = 0.5;
  scene.friction.slide_roll_ratio = 0;
  EXPECT_EQ(onset_of(scene, friction_minimum).exists, false);
}

TEST(Onset, ConstantFlowWithoutAsperitiesHasItsMaximumAtAConstantRatio) {
  Scene scene = paper_scene(PaperSurface::smooth);
  scene.surface.summit_plane_offset = 0;
  scene.surface.summit_density = 1e5;  // so few summits carry nothing
  scene.supply = {SupplyKind::inlet_flow, 1e-7};
  const Onset<double> found = onset_of(scene, film_maximum);
  ASSERT_TRUE(found.exists);
  const OperatingPoint<double> solved = MixedContact<double>(scene).solve(found.speed);
  EXPECT_TRUE(is_within(solved.film_flooded * found.speed / 1e-7, 0.4326, 0.5e-4));
}

// The walk in long double, which solves no root, is compared with the engine's roots. A film
// maximum is flat: the error of its speed is the square root of the error of its film.
TEST(Onset, IsThatOfTheWalkInLongDouble) {
  for (const auto model : asperity_models)
    for (const PaperSurface surface : paper_surfaces)
      for (const auto closure : starvation_closures)
        for (const auto supply : {SupplyKind::inlet_flow, SupplyKind::inlet_film_ratio})
          for (const OnsetCriterion criterion : {film_maximum, film_departure}) {
            const Scene scene = starved_scene(surface, closure, supply, model);
            const Onset<double> got = onset_of(scene, criterion);
            const Onset<long double> exact =
                onset(MixedContact<long double>(scene), scene, criterion, 0.05L);
            ASSERT_EQ(got.exists, exact.exists);
            if (!got.exists) continue;
            const double wide = criterion == film_maximum ? 1e-6 : 1e-12;
            EXPECT_TRUE(is_close(got.speed, exact.speed, wide, {{"u", got.speed}}));
            EXPECT_TRUE(is_close(got.film, exact.film, 1e-12, {{"u", got.speed}}));
          }
}

}  // namespace
}  // namespace tribo::verification
