// SPDX-License-Identifier: Apache-2.0
#include "sweep/plan.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "tribo/onset.hpp"
#include "tribo/outputs.hpp"

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
  // A column of an onset has one value a case; a column of an output has one for each speed.
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
      return {i, first, std::min(scene.chunk_groups, scene.groups - first)};
    }
    chunk -= scene.chunks;
  }
  throw std::out_of_range("the plan has no such chunk");
}

bool may_lack_film(const SceneSweep& sweep) {
  return film_law(sweep.scene).is_solved() ||
         std::ranges::any_of(sweep.variables, [](const Variable& variable) {
           return variable.path == "closures.film" &&
                  std::ranges::count(variable.grid, static_cast<double>(FilmFormula::solved)) > 0;
         });
}

namespace {

std::vector<Column> columns_of(const SceneSweep& sweep) {
  std::vector<Column> columns;
  for (const OutputInfo& info : output_infos) {
    if (!sweep.outputs.contains(info.output)) continue;
    columns.push_back({std::string(info.name),
                       std::string(info.unit),
                       {info.words.begin(), info.words.end()},
                       sweep.scene.speeds.size(),
                       std::string(info.meaning)});
    // The summits are not known. The word for boundary lubrication, which needs them, is replaced.
    if (info.output == Output::regime && sweep.scene.surface.has_rq_alone())
      columns.back().words.front() = "undefined";
    else if (!info.words.empty() && may_lack_film(sweep))
      columns.back().words.push_back("undefined");
  }
  for (const OnsetCriterion criterion : sweep.criteria) {
    const std::string prefix = "onset." + std::string(name(criterion)) + '.';
    const std::string at = " at the onset by " + std::string(name(criterion)) +
                           "; undefined where the case has no such onset";
    columns.push_back({prefix + "speed", "m/s", {}, 1, "u, entrainment speed" + at});
    columns.push_back({prefix + "film", "m", {}, 1, "h*, film" + at});
    columns.push_back({prefix + "film_parameter", "", {}, 1, "λ* = h*/σ_s" + at});
  }
  if (sweep.solves_film)
    for (const SolvedColumn& column : solved_columns)
      columns.push_back({"solved_film." + std::string(column.name), std::string(column.unit),
                         column.is_of_words ? std::vector<std::string>(solved_outcome_words.begin(),
                                                                       solved_outcome_words.end())
                                            : std::vector<std::string>(),
                         sweep.scene.speeds.size(), std::string(column.meaning)});
  return columns;
}

// A chunk is long enough that the overhead of its record and of its place in the file is small, and
// short enough that little is lost with it. A point whose film is solved takes as long as a million
// other points: a chunk has up to four such points, or one where many threads would have nothing to
// do. Any other sweep has about 256 chunks of 1024 to 65536 points. A larger one has more chunks of
// 65536 points, and the largest have about 4096 chunks of up to 2²⁰ points. Where a group has that
// many points, a chunk may still have eight groups, because each column of a chunk has a record of
// its own. A chunk whose points are kept has at most some 131072 numbers, or one group.
std::uint64_t groups_a_chunk(const SceneSweep& sweep, std::uint64_t points) {
  constexpr std::uint64_t least = 1024, usual = 65536, most = 1 << 20, most_numbers = 1 << 17;
  std::uint64_t chunk_points = std::clamp(points / 256, least, usual);
  chunk_points = std::clamp(points / 4096, chunk_points, most);
  if (sweep.solves_film) chunk_points = std::clamp<std::uint64_t>(points / 64, 1, 4);
  std::uint64_t groups = chunk_points / std::max<std::uint64_t>(points / sweep.groups, 1);
  if (!sweep.solves_film) groups = std::max(groups, std::min<std::uint64_t>(8, sweep.groups / 16));
  if (sweep.keep_points)
    groups = std::min(groups, most_numbers / ((sweep.width() + sweep.variables.size()) *
                                              sweep.cases_kept_per_group()));
  return std::min(std::bit_floor(std::max<std::uint64_t>(groups, 1)), std::bit_ceil(sweep.groups));
}

}  // namespace

void lay_out(SceneSweep& sweep) {
  sweep.columns = columns_of(sweep);
  sweep.grid_cells = 1;
  for (const Variable& variable : sweep.variables)
    if (!variable.is_drawn()) sweep.grid_cells *= variable.grid.size();
  sweep.groups = sweep.grid_cells * sweep.draws;
  sweep.chunk_groups = groups_a_chunk(sweep, sweep.points());
  sweep.chunks = (sweep.groups + sweep.chunk_groups - 1) / sweep.chunk_groups;
}

}  // namespace tribo::sweep
