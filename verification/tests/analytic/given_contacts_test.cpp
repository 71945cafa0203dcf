// SPDX-License-Identifier: Apache-2.0
// Contacts of smooth bodies, of oils given by their data sheets, and with heated inlets, by the
// engine and in long double. A contact has the same bits alone and in a batch with others.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/judge.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contacts.hpp"
#include "tribo/oil.hpp"
#include "tribo/onset.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::verification {
namespace {

OutputSet without_film_parameter() {
  OutputSet outputs = OutputSet::all();
  outputs.erase(Output::film_parameter);
  return outputs;
}

Scene random_smooth_scene(Sampler& sampler) {
  Scene scene = random_scene(sampler);
  scene.surface = {};
  if (scene.supply.kind == SupplyKind::inlet_film_ratio)
    scene.supply = {SupplyKind::inlet_film, 1e-7 * scene.supply.value};
  scene.outputs = without_film_parameter();
  return scene;
}

void expect_close(double value, long double wanted, double tolerance) {
  if (std::isnan(wanted))
    EXPECT_EQ(std::isnan(value), true);
  else
    EXPECT_TRUE(is_close(value, Reference(wanted), tolerance, {}));
}

TEST(SmoothBodies, AreThoseOfTheTemplateAndCarryNoLoadOnAsperities) {
  Sampler sampler(74);
  for (int i = 0; i < 500; ++i) {
    const Scene scene = random_smooth_scene(sampler);
    const double u = scene.speeds.list[0];
    const auto point = MixedContact<double>(scene).solve(u, scene.outputs);
    const auto wide = MixedContact<long double>(scene).solve(u, scene.outputs);
    // Near its maximum and its collapse a starved film is steep in h_oil.
    const double tolerance = scene.supply.kind == SupplyKind::flooded ? 1e-13 : 1e-9;
    expect_close(point.film_flooded, wide.film_flooded, 1e-13);
    expect_close(point.film, wide.film, tolerance);
    expect_close(point.separation, wide.separation, tolerance);
    EXPECT_EQ(point.regime, wide.regime);
    EXPECT_EQ(point.inlet, wide.inlet);
    EXPECT_EQ(point.real_area_ratio, 0);
    EXPECT_EQ(point.summit_count, 0);
    if (point.regime == Regime::collapsed) continue;
    expect_close(point.friction, wide.friction, 1e-9);
    EXPECT_EQ(point.asperity_load_share, 0);
    EXPECT_EQ(point.fluid_load_share, 1);
    EXPECT_EQ(point.regime, Regime::elastohydrodynamic);
    EXPECT_LE(point.film, point.film_flooded);
  }
}

// Contacts of many kinds, each at its own speed, are solved alone and all in one batch.
TEST(SmoothBodies, HaveTheSameBitsAmongOtherContacts) {
  Sampler sampler(75);
  MixedContacts contacts;
  std::vector<Scene> scenes;
  std::vector<std::uint64_t> contact_of;
  std::vector<double> speeds;
  for (std::uint64_t i = 0; i < 300; ++i) {
    Scene scene = i % 3 == 0 ? random_scene(sampler) : random_smooth_scene(sampler);
    if (i % 5 == 1) {
      scene.lubricant.thermal = ThermalInlet::gupta;
      scene.lubricant.conductivity = 0.14;
      scene.lubricant.temperature_coefficient = 0.04;
    }
    contacts.add(scene);
    contact_of.push_back(i);
    speeds.push_back(scene.speeds.list[0]);
    scenes.push_back(scene);
  }
  contacts.prepare();
  const OutputSet outputs = without_film_parameter();
  OperatingPoints points;
  points.resize(speeds.size(), outputs);
  contacts.solve(contact_of, speeds, outputs, points);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto alone = MixedContact<double>(scenes[i]).solve(speeds[i], outputs);
    EXPECT_EQ(bits_of(alone), bits_of(points[i])) << i;
  }
}

TEST(SmoothBodies, AreTheLimitOfFewSummits) {
  Sampler sampler(76);
  for (int i = 0; i < 200; ++i) {
    Scene scene = random_smooth_scene(sampler);
    const double u = scene.speeds.list[0];
    const auto smooth = MixedContact<double>(scene).solve(u, scene.outputs);
    scene.surface = {1e-9, 1e-5, 1e-7, 0, 0};
    const auto few = MixedContact<double>(scene).solve(u, scene.outputs);
    expect_close(smooth.film_flooded, few.film_flooded, 1e-12);
    expect_close(smooth.film, few.film, 1e-9);
  }
}

TEST(SmoothBodies, HaveOnsetsWithoutAFilmParameter) {
  Sampler sampler(77);
  for (int i = 0; i < 200; ++i) {
    Scene scene = random_smooth_scene(sampler);
    const MixedContact<double> contact(scene);
    for (const OnsetCriterion criterion :
         {OnsetCriterion::film_maximum, OnsetCriterion::film_departure}) {
      const Onset<double> found = onset(contact, scene, criterion, 0.05);
      if (!found.exists) continue;
      EXPECT_EQ(std::isnan(found.film_parameter), true);
      if (scene.supply.kind == SupplyKind::inlet_flow) continue;
      EXPECT_TRUE(is_within(contact.solve(found.speed, scene.outputs).film / found.film, 1, 1e-6));
    }
    EXPECT_EQ(onset(contact, scene, OnsetCriterion::asperity_minimum, 0.05).exists, false);
  }
}

TEST(HeatedInlets, MultiplyTheFilmLawByTheirFactor) {
  Sampler sampler(78);
  for (int i = 0; i < 200; ++i) {
    Scene scene = i % 2 == 0 ? random_scene(sampler) : random_smooth_scene(sampler);
    const double u = scene.speeds.list[0];
    const MixedContact<long double> isothermal(scene);
    scene.lubricant.thermal = ThermalInlet::gupta;
    scene.lubricant.conductivity = sampler.uniform(0.1, 0.2);
    scene.lubricant.temperature_coefficient = sampler.uniform(0.02, 0.06);
    const MixedContact<double> heated(scene);
    const double factor = gupta_thermal_reduction<double>(
        heated.hertz().peak_pressure, scene.bodies.effective_modulus,
        scene.friction.slide_roll_ratio, scene.lubricant.temperature_coefficient,
        scene.lubricant.viscosity, u, scene.lubricant.conductivity);
    if (std::isnan(factor)) {
      EXPECT_EQ(std::isnan(heated.flooded_film_parameter(u)), true);
      continue;
    }
    EXPECT_LE(factor, 1);
    expect_close(heated.flooded_film_parameter(u), isothermal.flooded_film_parameter(u) * factor,
                 1e-12);
    // The load is shared at the thinner film.
    const auto shares = isothermal.sharing().solve(isothermal.flooded_film_parameter(u) * factor);
    expect_close(heated.flooded(u).shares.film_parameter, shares.film_parameter, 1e-12);
  }
}

TEST(Oils, GiveTheViscosityThatAContactIsPreparedFrom) {
  Sampler sampler(79);
  for (int i = 0; i < 300; ++i) {
    Scene scene = random_scene(sampler);
    Oil& oil = scene.lubricant.oil;
    oil.density = sampler.uniform(800, 1000);
    oil.temperature = sampler.uniform(280, 400);
    if (i % 2 == 0) {
      oil.viscosities = {
          {{313.15, sampler.log_uniform(2e-5, 5e-4)}, {373.15, sampler.log_uniform(4e-6, 1e-5)}}};
    } else {
      oil.iso_vg = sampler.log_uniform(10, 1500);
      oil.viscosity_index = sampler.uniform(0, 250);
    }
    const auto [first, second] = viscosities_of(oil);
    if (oil.iso_vg > 0) {
      EXPECT_EQ(first.temperature, 313.15);
      EXPECT_EQ(second.temperature, 373.15);
      EXPECT_TRUE(is_within(first.viscosity * 1e6 / oil.iso_vg, 1, 1e-15));
    }
    // log log(ν + 0.7) is straight in log T.
    const auto place = [](double viscosity) {
      return std::log10(std::log10(1e6 * viscosity + 0.7));
    };
    const double part = std::log(oil.temperature / first.temperature) /
                        std::log(second.temperature / first.temperature);
    const double straight =
        place(first.viscosity) + part * (place(second.viscosity) - place(first.viscosity));
    const double wanted = oil.density * 1e-6 * (std::pow(10, std::pow(10, straight)) - 0.7);
    const double viscosity = detail::numbers_of<double>(scene).viscosity;
    EXPECT_TRUE(is_within(viscosity / wanted, 1, 1e-11));
    const double film = MixedContact<double>(scene).flooded_film_parameter(1);
    scene.lubricant.viscosity = viscosity;
    scene.lubricant.oil = {};
    EXPECT_EQ(MixedContact<double>(scene).flooded_film_parameter(1), film);
  }
}

}  // namespace
}  // namespace tribo::verification
