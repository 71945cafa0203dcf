// SPDX-License-Identifier: Apache-2.0
// Each point has the same bits alone, in a batch of its contact and among points of other contacts,
// on every instruction set, also for prepared contacts. All instruction sets with fused
// multiply-add agree, and all sets without it agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "support/film_laws.hpp"
#include "support/instruction_sets.hpp"
#include "support/judge.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contacts.hpp"

namespace tribo::verification {
namespace {

using Bits = std::vector<std::uint64_t>;

struct Points {
  std::vector<Scene> scenes;
  std::vector<std::uint64_t> contact_of;
  std::vector<double> speeds;

  void add(const Scene& scene, const std::vector<double>& at) {
    scenes.push_back(scene);
    for (const double speed : at) {
      contact_of.push_back(scenes.size() - 1);
      speeds.push_back(speed);
    }
  }
};

// Scenes that differ in every field, one of them beyond the engine's range, and the paper's scenes
// at speeds from a floor to a collapse.
Points points() {
  Points all;
  Sampler sampler(231);
  for (int i = 0; i < 400; ++i) {
    const Scene scene = random_scene(sampler);
    all.add(scene, {scene.speeds[0], sampler.log_uniform(1e-7, 100)});
  }
  Scene dense = all.scenes.front();
  dense.surface.summit_density = 1e300;
  all.add(dense, {1e-3, 1});
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const PaperSurface surface : paper_surfaces) {
      const Scene scene = paper_scene(surface, model);
      std::vector<double> speeds{1e-300, 1e-20, 1e200};
      for (std::size_t i = 0; i < 40; ++i) speeds.push_back(scene.speeds[5 * i]);
      all.add(scene, speeds);
    }
  // Laws without fixed exponents, for each shape, with and without a floor. Some speeds lie beyond
  // the tables of solved films. Starved films stand between solved ones.
  for (const double density : {1e11, 2e12})
    for (const auto& [film, shape] :
         {std::pair{FilmFormula::nijenbanning_venner_moes, ContactShape::circle},
          {FilmFormula::nijenbanning_venner_moes, ContactShape::ellipse},
          {FilmFormula::moes_line, ContactShape::line},
          {FilmFormula::solved, ContactShape::circle},
          {FilmFormula::solved, ContactShape::line}}) {
      Scene scene = scene_of_law(film, shape, density);
      std::vector<double> speeds;
      for (double speed = 1e-7; speed < 30; speed *= 1.9) speeds.push_back(speed);
      all.add(scene, speeds);
      if (film != FilmFormula::solved || shape != ContactShape::circle) continue;
      scene.closures.starvation = StarvationClosure::solved;
      scene.supply = {SupplyKind::inlet_film, 5e-7};
      all.add(scene, speeds);
    }
  return all;
}

std::vector<Bits> alone(const Points& all) {
  std::vector<Bits> bits;
  for (std::size_t i = 0; i < all.speeds.size(); ++i)
    bits.push_back(
        bits_of(MixedContact<double>(all.scenes[all.contact_of[i]]).solve(all.speeds[i])));
  return bits;
}

std::vector<Bits> by_contact(const Points& all) {
  std::vector<Bits> bits;
  for (std::size_t first = 0; first < all.speeds.size();) {
    std::size_t end = first;
    while (end < all.speeds.size() && all.contact_of[end] == all.contact_of[first]) ++end;
    OperatingPoints points;
    points.resize(end - first, OutputSet::all());
    solve(MixedContact<double>(all.scenes[all.contact_of[first]]),
          std::span(all.speeds).subspan(first, end - first), OutputSet::all(), points);
    for (std::size_t i = 0; i < points.size(); ++i) bits.push_back(bits_of(points[i]));
    first = end;
  }
  return bits;
}

// Solves `size` points in one call. The contacts are prepared in several lots, after another
// contact was prepared and cleared.
std::vector<Bits> among_others(const Points& all, std::size_t size) {
  MixedContacts contacts;
  contacts.add(all.scenes.back());
  contacts.prepare();
  contacts.clear();
  for (std::size_t i = 0; i < all.scenes.size(); ++i) {
    contacts.add(all.scenes[i]);
    if (i % 3 == 0 || i + 1 == all.scenes.size()) contacts.prepare();
  }
  std::vector<Bits> bits;
  for (std::size_t first = 0; first < all.speeds.size(); first += size) {
    const std::size_t some = std::min(size, all.speeds.size() - first);
    OperatingPoints points;
    points.resize(some, OutputSet::all());
    contacts.solve(std::span(all.contact_of).subspan(first, some),
                   std::span(all.speeds).subspan(first, some), OutputSet::all(), points);
    for (std::size_t i = 0; i < some; ++i) bits.push_back(bits_of(points[i]));
  }
  return bits;
}

void hold(const char* way, const std::vector<Bits>& got, const std::vector<Bits>& expected,
          const Points& all) {
  ASSERT_EQ(got.size(), expected.size()) << way;
  for (std::size_t i = 0; i < got.size(); ++i)
    EXPECT_EQ(got[i], expected[i])
        << way << ", scene " << all.contact_of[i] << describe({{"speed", all.speeds[i]}});
}

TEST(SameBits, ComeFromEachWayToAPointOnEachInstructionSet) {
  const Points all = points();
  // The same points in random order: neighbours belong to different contacts.
  std::vector<std::size_t> order(all.speeds.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(233));
  Points shuffled{all.scenes, {}, {}};
  for (const std::size_t i : order) {
    shuffled.contact_of.push_back(all.contact_of[i]);
    shuffled.speeds.push_back(all.speeds[i]);
  }
  std::map<bool, std::vector<Bits>> first;  // by fused multiply-add
  on_each_instruction_set([&] {
    const std::vector<Bits> expected = alone(all);
    const std::vector<Bits>& others = first.try_emplace(is_fused(), expected).first->second;
    hold("alone on another instruction set", expected, others, all);
    hold("in a batch of the contact", by_contact(all), expected, all);
    for (const std::size_t size : {1, 3, 8, 511, 513, 5000})
      hold("among other contacts", among_others(all, size), expected, all);
    std::vector<Bits> expected_shuffled;
    for (const std::size_t i : order) expected_shuffled.push_back(expected[i]);
    for (const std::size_t size : {8, 512, 5000})
      hold("in another order", among_others(shuffled, size), expected_shuffled, shuffled);
  });
}

// λ is the same alone, in a batch of one surface, among other surfaces, and for a surface that is
// used once, whose floor is found only if λ₀ may be below it. Some λ₀ are next to a floor.
void expect_same_roots(const FilmLaw& law) {
  const std::vector<double> films{1e-300, 1e-30, 1e-4, 0.02, 0.3, 0.9, 1.1, 2.0, 3.5, 6, 40, 1e5};
  Sampler sampler(232);
  on_each_instruction_set([&] {
    for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson}) {
      std::vector<double> stiffness, offset, film0, alone;
      for (int i = 0; i < 300; ++i) {
        const LoadSharing<double> sharing(model, sampler.log_uniform(1e-12, 1e12),
                                          sampler.uniform(0, 5), law);
        std::vector<double> flooded = films;
        const double floor = sharing.floor();
        for (const double part : {0.9, 0.999, 1 - 0x1p-53, 1.0, 1 + 0x1p-52, 1.001, 1.1})
          if (floor > 0) flooded.push_back(floor * part);
        std::vector<double> together(flooded.size());
        film_parameter(sharing, flooded, together);
        for (std::size_t k = 0; k < flooded.size(); ++k) {
          stiffness.push_back(sharing.stiffness());
          offset.push_back(sharing.offset());
          film0.push_back(flooded[k]);
          alone.push_back(sharing.film_parameter(flooded[k]));
          EXPECT_EQ(together[k], alone.back())
              << describe({{"K", sharing.stiffness()}, {"lambda0", flooded[k]}});
          EXPECT_EQ(film_parameter(model, sharing.stiffness(), sharing.offset(), flooded[k], law),
                    alone.back())
              << describe({{"K", sharing.stiffness()}, {"lambda0", flooded[k]}});
        }
      }
      std::vector<double> among_others(alone.size());
      film_parameter(model, stiffness, offset, film0, among_others, law);
      for (std::size_t k = 0; k < alone.size(); ++k)
        EXPECT_EQ(among_others[k], alone[k])
            << describe({{"K", stiffness[k]}, {"delta", offset[k]}, {"lambda0", film0[k]}});
    }
  });
}
TEST(SameBits, ComeFromEachWayToARoot) {
  expect_same_roots(hamrock_dowson_central_law);
  for (const FilmLaw* const law : other_film_laws) expect_same_roots(*law);
}

}  // namespace
}  // namespace tribo::verification
