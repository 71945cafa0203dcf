// SPDX-License-Identifier: Apache-2.0
// The layout of a sweep in chunks at the limits of each rule, and the progress that a run tells.
#include "sweep/run.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/temporary_folder.hpp"
#include "sweep/plan.hpp"
#include "sweep/plan_reader.hpp"

namespace tribo::sweep {
namespace {

// One column at this many speeds, with one drawn input.
SceneSweep laid_out(std::uint64_t draws, std::size_t speeds, bool keeps_points, bool is_solved) {
  SceneSweep scene;
  scene.scene.speeds.list.assign(speeds, 1.0);
  scene.outputs.insert(Output::film);
  scene.variables.resize(1);
  scene.draws = draws;
  scene.keep_points = keeps_points;
  scene.solves_film = is_solved;
  lay_out(scene);
  return scene;
}

TEST(Layout, OfASceneHasTheChunksThatItsPointsAskFor) {
  const auto groups = [](std::uint64_t draws, bool is_solved = false) {
    const SceneSweep scene = laid_out(draws, 1, false, is_solved);
    EXPECT_EQ(scene.groups, draws);
    EXPECT_EQ(scene.chunks, (draws + scene.chunk_groups - 1) / scene.chunk_groups);
    return scene.chunk_groups;
  };
  constexpr std::uint64_t k = 1024;
  for (const auto& [draws, expected] :
       std::vector<std::pair<std::uint64_t, std::uint64_t>>{{1, 1},
                                                            {k - 1, k},
                                                            {k + 1, k},
                                                            {512 * k - 1, k},
                                                            {512 * k, 2 * k},
                                                            {16384 * k - 1, 32 * k},
                                                            {16384 * k, 64 * k},
                                                            {512 * k * k - 1, 64 * k},
                                                            {512 * k * k, 128 * k},
                                                            {4096 * k * k - 1, 512 * k},
                                                            {4096 * k * k, k * k},
                                                            {16384 * k * k, k * k}})
    EXPECT_EQ(groups(draws), expected) << draws;
  for (const auto& [draws, expected] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{
           {1, 1}, {127, 1}, {128, 2}, {255, 2}, {256, 4}, {100000, 4}})
    EXPECT_EQ(groups(draws, true), expected) << draws;
}

// A chunk may have eight long cases, if that is at most a sixteenth of all. Large sweeps have more.
TEST(Layout, OfLongCasesHasUpToEightOfThemAChunk) {
  for (const auto& [draws, expected] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{
           {1, 1}, {31, 1}, {32, 2}, {127, 4}, {128, 8}, {10000, 8}, {100000, 16}}) {
    EXPECT_EQ(laid_out(draws, 10000, false, false).chunk_groups, expected) << draws;
    EXPECT_EQ(laid_out(draws, 10000, false, true).chunk_groups, 1U) << draws;
  }
}

// A kept case has one number for each speed, and one for its drawn input.
TEST(Layout, OfKeptPointsHasAtMostSoManyNumbersAChunk) {
  constexpr std::uint64_t most = 1 << 17, points = std::uint64_t{1} << 32;
  for (std::size_t speeds = 1; speeds <= 300; ++speeds) {
    const SceneSweep scene = laid_out(points / speeds, speeds, true, false);
    const std::uint64_t numbers = speeds + 1;
    EXPECT_EQ(std::has_single_bit(scene.chunk_groups), true) << speeds;
    EXPECT_LE(scene.chunk_groups * numbers, most) << speeds;
    EXPECT_GT(2 * scene.chunk_groups * numbers, most) << speeds;
  }
}

TEST(Run, TellsEachChunkThatItWritesAndIsStoppedBetweenTwo) {
  const std::string map = TRIBOCHECK_SOURCE_DIR "/reference/published/sweeps/film_map.toml";
  const SweepPlan plan = make_plan({read_sweep(map).sweep.value()});
  std::vector<std::uint64_t> all(plan.chunks());
  std::iota(all.begin(), all.end(), 1);
  ASSERT_GT(all.size(), 3U);
  for (const bool is_stopped : {false, true}) {
    const TemporaryFolder folder;
    std::vector<std::uint64_t> written;
    RunSettings settings;
    settings.result = folder.file("out.h5");
    settings.threads = 1;
    settings.tell = [](std::string_view) {};
    settings.progress = [&](const RunProgress& now) {
      if (now.phase != RunProgress::Phase::writing) return;
      EXPECT_EQ(now.chunks, plan.chunks());
      written.push_back(now.done);
    };
    settings.stopped = [&] { return is_stopped && written.size() == 2; };
    const RunEnd end = run(plan, settings, Ranks());
    EXPECT_EQ(end, is_stopped ? RunEnd::stopped : RunEnd::done);
    EXPECT_EQ(std::filesystem::exists(settings.result), !is_stopped);
    EXPECT_EQ(written, is_stopped ? std::vector<std::uint64_t>({1, 2}) : all);
  }
}

}  // namespace
}  // namespace tribo::sweep
