// SPDX-License-Identifier: Apache-2.0
// A sweep made by hand, with chunks of seeded numbers, and folders for its files.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/temporary_folder.hpp"
#include "sweep/chunk.hpp"
#include "sweep/part.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

using tribo::content_of;

// Removes the file first: some file systems wait for the disk when a file is overwritten.
inline void write_content(const std::string& path, const std::string& content) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << content;
}

// The message of the exception that `throws` throws; "none" if it throws none.
template <class Throw>
std::string error_of(Throw&& throws) {
  try {
    throws();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

inline std::vector<std::uint64_t> bits_of(std::span<const double> values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

// Writes while no file may be longer than `room`, as on a full disk. This has to fail with a
// message of this pattern and leave nothing in the folder. The next attempt in the same process has
// to succeed. Both run in a child process, because HDF5 does not free all of a file that it could
// not close.
template <class Write, class IsWhole>
void expect_whole_or_nothing(const TemporaryFolder& folder, std::uint64_t room,
                             const std::string& pattern, const Write& write,
                             const IsWhole& is_whole) {
  const auto write_twice = [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlim_t before = std::exchange(limit.rlim_cur, room);
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string error = error_of(write);
    const bool is_gone = std::filesystem::is_empty(folder.path());
    limit.rlim_cur = before;
    setrlimit(RLIMIT_FSIZE, &limit);
    write();
    std::fputs(error.c_str(), stderr);
    ::_exit(is_gone && is_whole() ? 0 : 1);
  };
  EXPECT_EXIT(write_twice(), testing::ExitedWithCode(0), pattern) << room;
  EXPECT_EQ(std::filesystem::is_empty(folder.path()), false);
  for (const auto& written : std::filesystem::directory_iterator(folder.path()))
    std::filesystem::remove(written);
}

// 21 cases in chunks of 8: the last chunk is not full. There are words, a drawn field, and columns
// of three speeds and of an onset.
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
  scene.columns = {{"film", "m", {}, 3},
                   {"regime", "", {"boundary", "mixed", "elastohydrodynamic"}, 3},
                   {"onset.film_maximum.speed", "m/s", {}, 1},
                   {"onset.film_maximum.film", "m", {}, 1}};
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

inline PackedValues packed(const std::vector<double>& numbers, bool are_words) {
  if (!are_words) return pack(std::span<const double>(numbers));
  return pack(std::vector<std::uint8_t>(numbers.begin(), numbers.end()));
}

// Chunk `number` of a scene by its definition, from the values and results of all cases of all
// groups, row by row.
inline Chunk chunk_of(const SceneSweep& scene, std::uint64_t number,
                      const std::vector<double>& values, const std::vector<double>& results) {
  const std::size_t rows = scene.cases_per_group(), kept = scene.cases_kept_per_group();
  const std::uint64_t first = number * scene.chunk_groups;
  const std::uint64_t end = std::min(first + scene.chunk_groups, scene.groups);
  // The `wide` numbers from `at` on of the first `cases` cases of each of these groups.
  const auto gathered = [&](const std::vector<double>& from, std::uint64_t group,
                            std::uint64_t last, std::size_t cases, std::size_t at,
                            std::size_t wide) {
    const std::size_t row_size = from.size() / (scene.groups * rows);
    std::vector<double> numbers;
    for (std::uint64_t g = group; g < last; ++g)
      for (std::size_t r = 0; r < cases; ++r) {
        const double* const row = &from[(g * rows + r) * row_size + at];
        numbers.insert(numbers.end(), row, row + wide);
      }
    return numbers;
  };
  Chunk chunk;
  const auto keep = [&](const std::vector<double>& from, std::size_t at, std::size_t wide,
                        bool are_words) {
    if (!scene.keep_points) return;
    std::vector<double> numbers = gathered(from, first, end, kept, at, wide);
    numbers.resize(scene.chunk_cases() * wide);
    chunk.values.push_back(packed(numbers, are_words));
  };
  for (std::size_t v = 0; v < scene.variables.size(); ++v)
    keep(values, v, 1, !scene.variables[v].words.empty());
  std::size_t at = 0;
  for (const Column& column : scene.columns) {
    keep(results, at, column.width, !column.words.empty());
    auto& summaries = chunk.summaries.emplace_back(column.width);
    if (scene.sensitivity) chunk.sensitivities.emplace_back(column.width);
    for (std::size_t j = 0; j < column.width; ++j, ++at) {
      summaries[j].add(gathered(results, first, end, kept, at, 1));
      for (std::uint64_t g = first; scene.sensitivity && g < end; ++g)
        chunk.sensitivities.back()[j][static_cast<std::uint32_t>(block_of(g, scene.groups))].add(
            gathered(results, g, g + 1, rows, at, 1), 0);
    }
  }
  return chunk;
}

// Chunk `number` of a scene, which has the number `of_plan` in the plan. The third case of a group
// with sensitivity has the results of the second.
inline Chunk small_chunk(const SceneSweep& scene, std::uint64_t number, std::uint64_t of_plan) {
  const SmallCases cases = small_cases(scene);
  const std::size_t kept = scene.cases_kept_per_group();
  std::vector<double> values, results;
  for (std::uint64_t g = 0; g < scene.groups; ++g)
    for (std::size_t r = 0; r < scene.cases_per_group(); ++r) {
      const std::uint64_t i = g * kept + std::min(r, kept - 1);
      for (const std::vector<double>& input : cases.inputs) values.push_back(input[i]);
      for (std::size_t c = 0; c < scene.columns.size(); ++c) {
        const std::size_t width = scene.columns[c].width;
        const double* const row = &cases.columns[c][i * width];
        results.insert(results.end(), row, row + width);
      }
    }
  Chunk chunk = chunk_of(scene, number, values, results);
  chunk.number = of_plan;
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
