// SPDX-License-Identifier: Apache-2.0
// λ(λ₀) of a surface compiled to polynomials in pieces: within 1e-14 of the root, also in the strip
// beside the floor, where one polynomial across loses digits; and the root itself where no piece
// holds.
#include "tribo/compiled_film.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "support/long_double.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array models{AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson};
constexpr double from = 1e-4, to = 100;

struct Surface {
  AsperityModel model;
  double stiffness, offset;

  LoadSharing<double> sharing() const { return {model, stiffness, offset}; }
};

// Those of the paper's scenes and of random ones in steel, with and without a floor.
std::vector<Surface> ordinary_surfaces() {
  std::vector<Surface> all;
  const auto add = [&](const Scene& scene) {
    const AsperityContact<double> contact = MixedContact<double>(scene).asperities();
    all.push_back({contact.model, contact.stiffness, contact.offset});
  };
  for (const AsperityModel model : models)
    for (const PaperSurface surface : paper_surfaces) add(paper_scene(surface, model));
  Sampler sampler(171);
  for (int i = 0; i < 14; ++i) add(random_scene(sampler));
  for (const AsperityModel model : models)
    for (const double k : {1e-3, 0.3, 10.0}) all.push_back({model, k, 1.146});
  return all;
}

std::vector<Surface> near_critical_surfaces() {
  std::vector<Surface> all;
  for (const AsperityModel model : models)
    for (const double offset : {0.0, 1.146, 4.0})
      for (const double away : {-1e-3, 1e-3, -1e-1, 1e-1})
        all.push_back({model, (1 + away) / gaussian_moment(load_order(model), -offset), offset});
  return all;
}

std::vector<Surface> stiff_surfaces() {
  std::vector<Surface> all;
  for (const AsperityModel model : models)
    for (const double k : {1e3, 1e6, 1e12, 1e40, 1e300})
      for (const double offset : {0.0, 2.0}) all.push_back({model, k, offset});
  return all;
}

// Both forms of the compiled film at some λ₀, held to the root in long double.
void hold(const Surface& surface, const CompiledFilm& compiled,
          const std::vector<double>& flooded) {
  const LoadSharing<double> sharing = surface.sharing();
  const LoadSharing<long double> exact(surface.model, static_cast<long double>(surface.stiffness),
                                       static_cast<long double>(surface.offset));
  std::vector<double> lambda(flooded.size());
  compiled.film_parameter(flooded, lambda);
  for (std::size_t i = 0; i < flooded.size(); ++i) {
    // One in some is solved anew, beside the others' steps from the root in double.
    const auto truth = i % 16 == 0
                           ? exact.solve(static_cast<long double>(flooded[i]))
                           : refined_root(exact, flooded[i], sharing.film_parameter(flooded[i]));
    EXPECT_TRUE(is_root(lambda[i], surface.model, surface.stiffness, surface.offset, flooded[i],
                        truth, CompiledFilm::error_bound));
    EXPECT_LE(ulps_off(compiled.film_parameter(flooded[i]), lambda[i]), 2)
        << describe({{"lambda0", flooded[i]}});
  }
}

void hold_everywhere(const std::vector<Surface>& surfaces, int samples, Sampler& sampler) {
  for (const Surface& surface : surfaces) {
    const CompiledFilm compiled(surface.sharing(), from, to);
    std::vector<double> flooded{from, to};
    for (int i = 0; i < samples; ++i) flooded.push_back(sampler.log_uniform(from, to));
    const double floor = surface.sharing().floor();
    if (floor > 0 && floor * 2 > from)
      for (int i = 0; i < samples / 3; ++i) {
        const double away = sampler.pick({-1, 1}) * sampler.log_uniform(1e-6, 1e-2);
        flooded.push_back(floor * (1 + away));
        flooded.push_back(floor * (1 + away * 1e-8));
        flooded.push_back(floor * sampler.uniform(0.8, 1.25));
      }
    hold(surface, compiled, flooded);
  }
}

TEST(CompiledFilm, IsTheRootOfOrdinarySurfaces) {
  Sampler sampler(172);
  hold_everywhere(ordinary_surfaces(), 2500, sampler);
}

TEST(CompiledFilm, IsTheRootNextToACriticalStiffness) {
  Sampler sampler(173);
  hold_everywhere(near_critical_surfaces(), 1200, sampler);
}

TEST(CompiledFilm, IsTheRootOfStiffSurfaces) {
  Sampler sampler(174);
  hold_everywhere(stiff_surfaces(), 1200, sampler);
}

TEST(CompiledFilm, LeavesNoPieceOutOnOrdinarySurfaces) {
  for (const Surface& surface : ordinary_surfaces()) {
    const CompiledFilm compiled(surface.sharing(), from, to);
    EXPECT_EQ(compiled.pieces().left_out(), 0)
        << describe({{"K", surface.stiffness}, {"delta", surface.offset}});
    EXPECT_GE(compiled.pieces().piece_count(), 20u);
    EXPECT_LE(compiled.pieces().piece_count(), 200u);
    EXPECT_LE(compiled.pieces().evaluations(), 6000u);
  }
}

// Whole binades about [from, to] have pieces; beyond, λ comes from the root.
TEST(CompiledFilm, IsTheRootItselfOutsideItsRange) {
  Sampler sampler(175);
  for (const Surface& surface : ordinary_surfaces()) {
    const LoadSharing<double> sharing = surface.sharing();
    const CompiledFilm compiled(sharing, 0.01, 10);
    std::vector<double> flooded{5e-324, 1e-310, 1e-290, 1e-9, 17, 1e300, infinity, 0.0};
    for (int i = 0; i < 100; ++i) {
      flooded.push_back(sampler.log_uniform(1e-8, 0.007));
      flooded.push_back(sampler.log_uniform(16.1, 1e4));
    }
    std::vector<double> lambda(flooded.size());
    compiled.film_parameter(flooded, lambda);
    for (std::size_t i = 0; i < flooded.size(); ++i) {
      const double root = sharing.film_parameter(flooded[i]);
      EXPECT_EQ(lambda[i], root) << describe({{"lambda0", flooded[i]}});
      EXPECT_EQ(compiled.film_parameter(flooded[i]), root) << describe({{"lambda0", flooded[i]}});
    }
  }
}

// Also one that the limits of the root's kernels reverse.
TEST(CompiledFilm, IsTheRootItselfWhereItsRangeIsReversedOrNoRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LoadSharing<double> sharing(AsperityModel::greenwood_tripp, 0.3, 1.146);
  const std::vector<double> flooded{1e-9, 1e-4, 0.3, 1.0, 100.0, 1e290};
  for (const auto& [low, high] :
       {std::pair{to, from}, {nan, to}, {from, nan}, {-to, -from}, {1e290, 1e300}}) {
    const CompiledFilm compiled(sharing, low, high);
    EXPECT_EQ(compiled.pieces().piece_count(), 0u) << describe({{"from", low}, {"to", high}});
    EXPECT_EQ(compiled.pieces().evaluations(), 0u);
    EXPECT_EQ(compiled.pieces().left_out(), 1);
    std::vector<double> lambda(flooded.size());
    compiled.film_parameter(flooded, lambda);
    for (std::size_t i = 0; i < flooded.size(); ++i) {
      const double root = sharing.film_parameter(flooded[i]);
      EXPECT_EQ(lambda[i], root) << describe({{"lambda0", flooded[i]}});
      EXPECT_EQ(compiled.film_parameter(flooded[i]), root) << describe({{"lambda0", flooded[i]}});
    }
  }
}

TEST(CompiledFilm, KeepsNaNAndLeavesItsNeighboursAlone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const CompiledFilm compiled({AsperityModel::greenwood_tripp, 0.3, 1.146}, from, to);
  const std::vector<double> flooded{0.5, nan, 0.7, -nan, 1e-9, 3};
  std::vector<double> lambda(flooded.size());
  compiled.film_parameter(flooded, lambda);
  for (std::size_t i = 0; i < flooded.size(); ++i) {
    const double alone = compiled.film_parameter(flooded[i]);
    if (std::isnan(flooded[i])) {
      EXPECT_NE(lambda[i], lambda[i]);
      EXPECT_NE(alone, alone);
    } else {
      EXPECT_LE(ulps_off(alone, lambda[i]), 2);
    }
  }
}

// Where every piece fails (K = ∞), or the surface is no number, the root's answers remain.
TEST(CompiledFilm, OfASurfaceWithoutFiniteRootsIsTheRoot) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const CompiledFilm endless({AsperityModel::greenwood_tripp, infinity, 1.0}, from, to);
  EXPECT_EQ(endless.film_parameter(1), infinity);
  EXPECT_EQ(endless.pieces().left_out(), 1);
  const CompiledFilm unknown({AsperityModel::greenwood_tripp, nan, 1.0}, from, to);
  const double lambda = unknown.film_parameter(1);
  EXPECT_NE(lambda, lambda);
  const CompiledFilm none({AsperityModel::greenwood_williamson, 0.0, 1.0}, from, to);
  EXPECT_LE(ulps_off(none.film_parameter(0.3), 0.3), 45);  // 1e-14
}

}  // namespace
}  // namespace tribo::verification
