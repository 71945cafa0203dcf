// SPDX-License-Identifier: Apache-2.0
// A sweep made by hand, with chunks of seeded numbers, and folders for its files.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/temporary_folder.hpp"
#include "sweep/chunk.hpp"
#include "sweep/part.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

inline std::string content_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
// Removes the file first: some file systems wait for the disk when a file is overwritten.
inline void write_content(const std::string& path, const std::string& content) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << content;
}

// The message of the exception that `throws` throws; "none" if nothing.
template <class Throw>
std::string error_of(Throw&& throws) {
  try {
    throws();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

inline Column column(std::string name, std::string unit, std::vector<std::string> words,
                     std::size_t width) {
  Column made;
  made.name = std::move(name);
  made.unit = std::move(unit);
  made.words = std::move(words);
  made.width = width;
  return made;
}

// 21 cases in chunks of 8, so that the last is not full; words, drawn fields, columns of three
// speeds and of an onset.
inline SceneSweep small_scene(const std::string& id) {
  SceneSweep scene;
  scene.file = "sweeps/" + id + ".toml";
  scene.text = "# \u00b5 of " + id + "\nload = 20\n";
  scene.scene.id = id;
  scene.scene.speeds.list = {0.1, 0.5, 2.0};
  scene.outputs.insert(Output::film);
  scene.outputs.insert(Output::regime);
  Variable model;
  model.path = "closures.asperity";
  model.meaning = "model of the asperities";
  model.text = "each of 2";
  model.words = {"greenwood_tripp", "greenwood_williamson"};
  model.grid = {0, 1};
  Variable viscosity;
  viscosity.path = "lubricant.viscosity";
  viscosity.unit = "Pa\u00b7s";
  viscosity.meaning = "viscosity at ambient pressure";
  viscosity.text = "uniform, from 0.02 to 0.03";
  viscosity.distribution = Distribution::uniform(0.02, 0.03);
  scene.variables = {model, viscosity};
  scene.columns = {column("film", "m", {}, 3),
                   column("regime", "", {"boundary", "mixed", "elastohydrodynamic"}, 3),
                   column("onset.film_maximum.speed", "m/s", {}, 1),
                   column("onset.film_maximum.film", "m", {}, 1)};
  scene.groups = 21;
  scene.draws = 21;
  scene.chunk_groups = 8;
  scene.chunks = 3;
  scene.seed = 7;
  return scene;
}

inline SweepPlan small_plan() {
  SceneSweep with_sensitivity = small_scene("tilted \u03bb");
  with_sensitivity.sensitivity = true;
  with_sensitivity.groups = 20;
  SceneSweep summaries_alone = small_scene("summaries");
  summaries_alone.keep_points = false;
  return {{small_scene("plain"), with_sensitivity, summaries_alone}, "0.1.0", "0123456789abcdef"};
}

// The numbers of all cases; the second column of onsets is always undefined.
struct SmallCases {
  std::vector<std::vector<double>> inputs;   // of each variable
  std::vector<std::vector<double>> columns;  // of each column, case by case
};
inline SmallCases small_cases(const SceneSweep& scene) {
  std::mt19937_64 random(scene.seed + scene.scene.id.size());
  const auto unit = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  SmallCases cases{std::vector<std::vector<double>>(scene.variables.size()),
                   std::vector<std::vector<double>>(scene.columns.size())};
  for (std::uint64_t i = 0; i < scene.cases(); ++i) {
    cases.inputs[0].push_back(static_cast<double>(random() % 2));
    cases.inputs[1].push_back(0.02 + 0.01 * unit());
    for (std::size_t c = 0; c < scene.columns.size(); ++c)
      for (std::size_t s = 0; s < scene.columns[c].width; ++s)
        cases.columns[c].push_back(
            !scene.columns[c].words.empty() ? static_cast<double>(random() % 3)
            : c == 3 || random() % 5 == 0   ? std::numeric_limits<double>::quiet_NaN()
                                            : 1e-8 * unit());
  }
  return cases;
}

inline PackedValues packed_part(const std::vector<double>& values, std::size_t first,
                                std::size_t count, bool are_words) {
  std::vector<double> part(count);
  for (std::size_t i = 0; i < count && first + i < values.size(); ++i) part[i] = values[first + i];
  if (!are_words) return pack(std::span<const double>(part));
  return pack(std::vector<std::uint8_t>(part.begin(), part.end()));
}

// Chunk `number` of a scene, which has the number `of_plan` in the plan.
inline Chunk small_chunk(const SceneSweep& scene, std::uint64_t number, std::uint64_t of_plan) {
  const SmallCases cases = small_cases(scene);
  const std::size_t count = scene.chunk_cases(), first = number * count;
  Chunk chunk;
  chunk.number = of_plan;
  if (scene.keep_points) {
    for (std::size_t v = 0; v < scene.variables.size(); ++v)
      chunk.values.push_back(
          packed_part(cases.inputs[v], first, count, !scene.variables[v].words.empty()));
    for (std::size_t c = 0; c < scene.columns.size(); ++c) {
      const std::size_t width = scene.columns[c].width;
      chunk.values.push_back(packed_part(cases.columns[c], first * width, count * width,
                                         !scene.columns[c].words.empty()));
    }
  }
  for (std::size_t c = 0; c < scene.columns.size(); ++c) {
    const std::size_t width = scene.columns[c].width;
    auto& summaries = chunk.summaries.emplace_back(width);
    for (std::size_t s = 0; s < width; ++s) {
      std::vector<double> values;
      for (std::size_t i = first; i < std::min<std::size_t>(first + count, scene.cases()); ++i)
        values.push_back(cases.columns[c][i * width + s]);
      summaries[s].add(values);
    }
    if (!scene.sensitivity) continue;
    auto& sensitivities = chunk.sensitivities.emplace_back(width);
    for (std::size_t s = 0; s < width; ++s)
      for (std::uint64_t g = number * scene.chunk_groups;
           g < std::min((number + 1) * scene.chunk_groups, scene.groups); ++g) {
        const double of_a = cases.columns[c][2 * g * width + s];
        const double of_b = cases.columns[c][(2 * g + 1) * width + s];
        const std::vector<double> values{of_a, of_b, of_b};
        sensitivities[s][static_cast<std::uint32_t>(block_of(g, scene.groups))].add(values, 0);
      }
  }
  return chunk;
}

// All chunks of a plan, as a run gathers them.
inline PartSet chunks_of(const SweepPlan& plan) {
  ChunksInMemory chunks;
  std::uint64_t of_plan = 0;
  for (const SceneSweep& scene : plan.scenes)
    for (std::uint64_t i = 0; i < scene.chunks; ++i, ++of_plan)
      chunks[of_plan] = small_chunk(scene, i, of_plan).bytes();
  std::vector<Part> parts;
  parts.emplace_back(
      PartHeader{plan.version, 1, plan.digest, "AVX2", {{"plain.toml", "load = 20\n"}}},
      std::move(chunks));
  return {std::move(parts), plan.chunks(), false};
}

}  // namespace tribo::sweep
