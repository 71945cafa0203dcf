// SPDX-License-Identifier: Apache-2.0
#include "sweep/plan.hpp"

#include <algorithm>
#include <stdexcept>

namespace tribo::sweep {

std::size_t SceneSweep::drawn() const {
  return static_cast<std::size_t>(
      std::count_if(variables.begin(), variables.end(),
                    [](const Variable& variable) { return variable.is_drawn(); }));
}

std::size_t SceneSweep::width() const {
  std::size_t width = 0;
  for (const Column& column : columns) width += column.width;
  return width;
}

std::uint64_t SceneSweep::points() const {
  // A column of an onset is one wide, one of an output as wide as there are speeds.
  std::size_t points = 1;
  for (const Column& column : columns) points = std::max(points, column.width);
  return groups * cases_per_group() * points;
}

std::uint64_t SweepPlan::chunks() const {
  std::uint64_t chunks = 0;
  for (const SceneSweep& scene : scenes) chunks += scene.chunks;
  return chunks;
}

std::uint64_t SweepPlan::points() const {
  std::uint64_t points = 0;
  for (const SceneSweep& scene : scenes) points += scene.points();
  return points;
}

ChunkPlace place_of(const SweepPlan& plan, std::uint64_t chunk) {
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    const SceneSweep& scene = plan.scenes[i];
    if (chunk < scene.chunks) {
      const std::uint64_t first = chunk * scene.chunk_groups;
      return {i, chunk, first, std::min(scene.chunk_groups, scene.groups - first)};
    }
    chunk -= scene.chunks;
  }
  throw std::out_of_range("the plan has no such chunk");
}

}  // namespace tribo::sweep
