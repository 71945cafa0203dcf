// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "sweep/plan.hpp"
#include "sweep/small_sweep.hpp"

namespace tribo::verification {
namespace {

using sweep::ChunkPlace;
using sweep::SceneSweep;
using sweep::SweepPlan;

SceneSweep scene_of(std::uint64_t groups, std::uint64_t chunk_groups) {
  SceneSweep scene;
  scene.groups = groups;
  scene.chunk_groups = chunk_groups;
  scene.chunks = (groups + chunk_groups - 1) / chunk_groups;
  return scene;
}

TEST(SweepPlan, ChunksFollowEachOtherAndHaveEachGroupOnce) {
  SweepPlan plan;
  plan.scenes = {scene_of(10, 4), scene_of(1, 100), scene_of(300, 100)};
  ASSERT_EQ(plan.chunks(), 7U);
  std::size_t scene = 0;
  std::uint64_t next_group = 0;
  for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk) {
    const ChunkPlace place = place_of(plan, chunk);
    if (place.scene != scene) {
      EXPECT_EQ(next_group, plan.scenes[scene].groups);
      EXPECT_EQ(place.scene, scene + 1);
      ++scene;
      next_group = 0;
    }
    EXPECT_EQ(place.first_group, next_group);
    EXPECT_GT(place.groups, 0U);
    EXPECT_LE(place.groups, plan.scenes[scene].chunk_groups);
    next_group += place.groups;
  }
  EXPECT_EQ(next_group, 300U);
  EXPECT_EQ(sweep::error_of([&] { place_of(plan, 7); }), "the plan has no such chunk");
}

TEST(SweepPlan, CountsCasesAndPoints) {
  SceneSweep scene = scene_of(100, 10);
  sweep::Variable grid;
  grid.grid = {1, 2};
  scene.variables = {grid, sweep::Variable{}, sweep::Variable{}};
  EXPECT_EQ(scene.drawn(), 2U);
  scene.columns.resize(2);  // of onsets
  EXPECT_EQ(scene.width(), 2U);
  EXPECT_EQ(scene.cases(), 100U);
  EXPECT_EQ(scene.points(), 100U);
  scene.outputs.insert(Output::film);
  scene.columns.resize(4);
  scene.columns[2].width = scene.columns[3].width = 25;  // speeds
  EXPECT_EQ(scene.width(), 52U);
  EXPECT_EQ(scene.points(), 2500U);
  scene.sensitivity = true;
  EXPECT_EQ(scene.cases(), 200U);
  EXPECT_EQ(scene.chunk_cases(), 20U);
  EXPECT_EQ(scene.points(), 10000U);  // A, B, AB₁, AB₂
  SweepPlan plan;
  plan.scenes = {scene, scene};
  EXPECT_EQ(plan.points(), 20000U);
}

}  // namespace
}  // namespace tribo::verification
