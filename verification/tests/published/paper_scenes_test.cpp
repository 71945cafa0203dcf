// SPDX-License-Identifier: Apache-2.0
// The paper's case: hand checks, the shares and films at the lowest speed, λ at the onset. The
// shipped scene files hold the same inputs.
#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::verification {
namespace {

TEST(PaperScenes, SummitsOfAllThreeSurfacesHaveTheUsualProduct) {
  for (const PaperSurface surface : paper_surfaces) {
    const Surface s = paper_scene(surface).surface;
    EXPECT_TRUE(is_within(s.summit_density * s.summit_radius * s.summit_height_sd, 0.05, 1e-16));
  }
  EXPECT_TRUE(is_within(gaussian_moment(Order::five_halves, 0.0), 0.61663421900, 0.5e-11));
}

TEST(PaperScenes, SharesAndFilmsAtTheLowestSpeedAreThoseOfTheSpecification) {
  constexpr std::array shares{0.765412364174454, 0.642288015366864, 0.537872259415982};
  constexpr std::array films{3.88840686142501e-10, 3.65851178220415e-10, 3.51904815844975e-10};
  for (const PaperSurface surface : paper_surfaces) {
    const auto i = static_cast<std::size_t>(surface);
    const OperatingPoint<double> p = MixedContact<double>(paper_scene(surface)).solve(1e-4);
    // 15 printed digits
    EXPECT_TRUE(is_close(p.asperity_load_share, shares[i], 1e-14, {}));
    EXPECT_TRUE(is_close(p.film, films[i], 1e-14, {}));
  }
}

TEST(PaperScenes, FilmParameterAtTheFilmMaximumIsTheClosuresOwn) {
  for (const auto model : asperity_models)
    for (const PaperSurface surface : paper_surfaces) {
      const Scene scene = paper_scene(surface, model);
      const Onset<double> found =
          onset(MixedContact<double>(scene), scene, OnsetCriterion::film_maximum, 0.05);
      ASSERT_TRUE(found.exists);
      EXPECT_TRUE(is_within(found.film_parameter, 1.43166235170080, 1e-14));
    }
}

TEST(PaperScenes, ShippedFilesHoldTableOne) {
  constexpr std::array names{"rough", "medium", "smooth"};
  for (const auto model : asperity_models)
    for (const PaperSurface surface : paper_surfaces) {
      const std::string id = std::string(names[static_cast<std::size_t>(surface)]) +
                             (model == AsperityModel::greenwood_tripp ? "" : "_gw");
      const SceneReading reading =
          read_scene(fmt::format("{}/reference/published/{}.toml", TRIBOCHECK_SOURCE_DIR, id),
                     SceneUse::speeds);
      for (const InputProblem& problem : reading.errors) ADD_FAILURE() << problem.line();
      ASSERT_TRUE(reading.scene.has_value());
      const Scene& file = *reading.scene;
      const Scene table = paper_scene(surface, model);
      EXPECT_EQ(file.id, id);
      EXPECT_EQ(file.outputs, OutputSet::all());
      for (std::size_t i = 0; i < table.speeds.size(); ++i) {
        const double u = table.speeds[i];
        EXPECT_EQ(file.speeds[i], u);
        EXPECT_EQ(bits_of(MixedContact<double>(file).solve(u)),
                  bits_of(MixedContact<double>(table).solve(u)));
      }
    }
}

}  // namespace
}  // namespace tribo::verification
