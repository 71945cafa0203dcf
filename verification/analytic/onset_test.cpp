// SPDX-License-Identifier: Apache-2.0
// Onset of starvation: closed forms against dense sweeps of the solved model, and reasons where
// there is none.
#include "tribo/onset.hpp"

#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "support/scenes.hpp"

namespace tribo::verification {
namespace {

using enum OnsetCriterion;
using enum StarvationClosure;

Onset<double> onset_of(const Scene& scene, OnsetCriterion criterion, double departure = 0.05) {
  return onset(MixedContact<double>(scene), scene, criterion, departure);
}

// The greatest film among solved points with a smaller film, beyond rounding, on both sides.
OperatingPoint<double> swept_film_maximum(const Scene& scene, double from, double to) {
  const MixedContact<double> contact(scene);
  OperatingPoint<double> best;
  double before = std::numeric_limits<double>::infinity();
  OperatingPoint<double> here = contact.solve(from);
  for (double u = from; u < to; u *= 1.0005) {
    const OperatingPoint<double> next = contact.solve(u);
    const double margin = 1 - 1e-12;
    if (before < here.film * margin && next.film < here.film * margin && here.film > best.film)
      best = here;
    before = here.film;
    here = next;
  }
  return best;
}

TEST(Onset, FilmMaximumIsThatOfADenseSweep) {
  for (const auto closure : {flooded_inlet, starved_inlet, printed_exponents, damiens})
    for (const auto supply : {SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow})
      for (const int planes : {1, 2})
        for (const PaperSurface surface : paper_surfaces) {
          Scene scene = paper_scene(surface);
          scene.closures.starvation = closure;
          scene.surface.offset_planes = planes;
          scene.supply = {supply, supply == SupplyKind::inlet_flow ? 1e-8 : 4};
          const Onset<double> found = onset_of(scene, film_maximum);
          const OperatingPoint<double> swept = swept_film_maximum(scene, 1e-4, 20);
          const std::string what =
              fmt::format("closure {} supply {} planes {} surface {}", static_cast<int>(closure),
                          static_cast<int>(supply), planes, static_cast<int>(surface));
          EXPECT_EQ(found.exists, swept.film > 0) << what << " " << found.reason;
          if (!found.exists) continue;
          EXPECT_TRUE(is_within(found.speed / swept.speed, 1, 0.0011)) << what;
          EXPECT_GE(found.film * (1 + 1e-14), swept.film) << what;
          EXPECT_TRUE(is_within(found.film / swept.film, 1, 1e-6)) << what;
          // the closed form and the solved point are one point
          const OperatingPoint<double> solved = MixedContact<double>(scene).solve(found.speed);
          EXPECT_TRUE(is_close(solved.film, Reference(found.film), 1e-13, {{"u", found.speed}}))
              << what;
        }
}

TEST(Onset, DepartureIsWhereTheSolvedFilmHasLostItsShare) {
  for (const auto closure : {flooded_inlet, starved_inlet, printed_exponents, damiens})
    for (const auto supply : {SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow})
      for (const double departure : {0.01, 0.05, 0.3}) {
        Scene scene = paper_scene(PaperSurface::medium);
        scene.closures.starvation = closure;
        scene.supply = {supply, supply == SupplyKind::inlet_flow ? 1e-8 : 4};
        const Onset<double> found = onset_of(scene, film_departure, departure);
        ASSERT_TRUE(found.exists) << found.reason;
        const OperatingPoint<double> solved = MixedContact<double>(scene).solve(found.speed);
        EXPECT_TRUE(is_within(solved.film / solved.film_flooded, 1 - departure, 1e-12));
        EXPECT_TRUE(is_close(solved.film, Reference(found.film), 1e-12, {{"u", found.speed}}));
      }
}

TEST(Onset, FrictionMinimumIsThatOfADenseSweep) {
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const PaperSurface surface : paper_surfaces) {
      const Scene scene = paper_scene(surface, model);
      const MixedContact<double> contact(scene);
      const Onset<double> found = onset_of(scene, friction_minimum);
      double lowest = 1e9, at = 0;
      for (double u = 1e-4; u < 3; u *= 1.001) {
        const OperatingPoint<double> p = contact.solve(u);
        if (!p.friction_undefined && p.friction < lowest) lowest = p.friction, at = u;
      }
      ASSERT_TRUE(found.exists);
      EXPECT_TRUE(is_within(found.speed / at, 1, 0.002));
      EXPECT_LE(contact.solve(found.speed).friction, lowest * (1 + 1e-14));
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
  const auto reason = [](const Scene& scene, OnsetCriterion criterion) {
    const Onset<double> found = onset_of(scene, criterion);
    EXPECT_FALSE(found.exists);
    return std::string(found.reason);
  };
  Scene flooded = paper_scene(PaperSurface::smooth);
  flooded.supply = {};
  for (const auto criterion : {film_maximum, film_departure, asperity_minimum})
    EXPECT_NE(reason(flooded, criterion).find("fully flooded"), std::string::npos);

  Scene no_maximum = paper_scene(PaperSurface::smooth);
  no_maximum.closures.starvation = damiens;
  EXPECT_NE(reason(no_maximum, film_maximum).find("without a maximum"), std::string::npos);

  Scene on_floor = paper_scene(PaperSurface::rough);
  on_floor.surface.offset_planes = 2;
  EXPECT_NE(reason(on_floor, film_departure).find("floor"), std::string::npos);

  // GW with two planes: λ = 1.43 at the film maximum is below the floor of 1.62
  Scene all_asperities = paper_scene(PaperSurface::rough, AsperityModel::greenwood_williamson);
  all_asperities.surface.offset_planes = 2;
  EXPECT_TRUE(onset_of(all_asperities, film_maximum).exists);
  EXPECT_NE(reason(all_asperities, asperity_minimum).find("whole load"), std::string::npos);

  Scene no_friction = paper_scene(PaperSurface::smooth);
  no_friction.friction.boundary_coefficient.reset();
  EXPECT_NE(reason(no_friction, friction_minimum).find("boundary_coefficient"), std::string::npos);

  Scene one_speed = paper_scene(PaperSurface::smooth);
  one_speed.speeds.list = {0.1};
  EXPECT_NE(reason(one_speed, friction_minimum).find("range"), std::string::npos);
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
  scene.surface.summit_density = 1e5;  // asperities carry nothing
  scene.supply = {SupplyKind::inlet_flow, 1e-7};
  const Onset<double> found = onset_of(scene, film_maximum);
  ASSERT_TRUE(found.exists);
  const OperatingPoint<double> solved = MixedContact<double>(scene).solve(found.speed);
  EXPECT_TRUE(is_within(solved.film_flooded * found.speed / 1e-7, 0.4326, 0.5e-4));
}

}  // namespace
}  // namespace tribo::verification
