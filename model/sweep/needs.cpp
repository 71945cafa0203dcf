// SPDX-License-Identifier: Apache-2.0
#include "sweep/needs.hpp"

#include <sys/statvfs.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <string_view>
#include <utility>

#include "sweep/chunk_solver.hpp"
#include "sweep/disk.hpp"
#include "sweep/needs_text.hpp"
#include "sweep/on_threads.hpp"
#include "sweep/part.hpp"
#include "sweep/parts_in_hand.hpp"
#include "sweep/result_file.hpp"

namespace tribo::sweep {
namespace {

// Time of the processor that this process used: other work of the machine is not counted.
double seconds_used() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The number of values that a case has in the widest column.
std::size_t widest(const SceneSweep& scene) {
  std::size_t widest = 1;
  for (const Column& column : scene.columns) widest = std::max(widest, column.width);
  return widest;
}

// A plan of this scene at `speeds` of its speeds, in chunks of `chunk_groups` groups.
SweepPlan thinned(const SceneSweep& scene, std::size_t speeds, std::uint64_t chunk_groups) {
  SceneSweep thin = scene;
  const Speeds& all = scene.scene.speeds;
  if (speeds < widest(scene)) {
    thin.scene.speeds.list.clear();
    for (std::size_t i = 0; i < speeds; ++i)
      thin.scene.speeds.list.push_back(all[i * (all.size() - 1) / (speeds - 1)]);
    for (Column& column : thin.columns)
      if (column.width > 1) column.width = speeds;
  }
  thin.chunk_groups = chunk_groups;
  thin.chunks = (thin.groups + chunk_groups - 1) / chunk_groups;
  return {{std::move(thin)}, {}, {}};
}

constexpr double allocation = 16;  // what an allocation costs besides its bytes

double memory_of(const SensitivitySums& sums) {
  return sizeof sums + 2 * (allocation + 8 * static_cast<double>(sums.total.capacity()));
}
double memory_of(const std::vector<std::vector<ValueSummary>>& summaries) {
  double memory = 0;
  for (const auto& column : summaries)
    for (const ValueSummary& summary : column)
      memory += sizeof summary + 2 * allocation + static_cast<double>(summary.sketch.memory());
  return memory;
}
double memory_of(const Chunk& chunk) {
  double memory = memory_of(chunk.summaries);
  for (const PackedValues& values : chunk.values)
    memory += static_cast<double>(values.bytes.capacity());
  constexpr double map_node = 48;
  for (const auto& column : chunk.sensitivities)
    for (const auto& blocks : column) {
      memory += sizeof blocks;
      for (const auto& [block, sums] : blocks) memory += map_node + memory_of(sums);
    }
  return memory;
}

// Means over some chunks that are spread over a scene.
struct Sample {
  double solve_seconds = 0, merge_seconds = 0;
  double write_seconds = 0;     // of the summaries of all values of a case, at the end
  double kept = 0, record = 0;  // bytes of a chunk: its points packed, and all of it in a part
  double chunk_memory = 0;
  double merged_memory = 0;  // of the merged summaries of these chunks
};

// The time that quantiles and histograms of all summaries take. With few cases the bounds of
// quantiles come from the binomial distribution itself, and take most of the time of a wide sweep.
double write_seconds_of(const std::vector<std::vector<ValueSummary>>& summaries) {
  constexpr std::size_t most_tried = 32;  // of a column
  double seconds = 0;
  for (const std::vector<ValueSummary>& column : summaries) {
    const std::size_t tried = std::min(column.size(), most_tried);
    const double before = seconds_used();
    for (std::size_t j = 0; j < tried; ++j) {
      for (const double level : quantile_levels) quantile_of(column[j], level);
      histogram_of(column[j].sketch, histogram_bins);
    }
    seconds +=
        (seconds_used() - before) * static_cast<double>(column.size()) / static_cast<double>(tried);
  }
  return seconds;
}

// The chunk of sample k. Each sample has an irregular place in its part of the chunks, because
// neighbouring cases are alike, and those of a grid repeat in equal steps.
std::uint64_t place_of_sample(std::uint64_t k, std::uint64_t parts, std::uint64_t chunks) {
  const double within = std::fmod(0.5 + 0.754877666246693 * static_cast<double>(k * k + k), 1.0);
  return static_cast<std::uint64_t>((static_cast<double>(k) + within) *
                                    static_cast<double>(chunks) / static_cast<double>(parts));
}

// Samples chunks for `seconds` seconds: at least `least` chunks, and at most 7.
Sample sample_of(const SweepPlan& plan, double seconds, int least = 2) {
  const SceneSweep& scene = plan.scenes.front();
  std::vector<std::vector<ValueSummary>> merged;
  for (const Column& column : scene.columns) merged.emplace_back(column.width);
  ChunkSolver solver(plan);
  solver.solve(0);  // so that work that is done only once is not counted
  Sample sum;
  double count = 0;
  const double start = seconds_used();
  for (const unsigned i : {0U, 4U, 2U, 6U, 1U, 5U, 3U}) {
    const double before = seconds_used();
    const Chunk chunk = solver.solve(place_of_sample(i, 7, scene.chunks));
    const Bytes record = chunk.bytes();
    const double solved = seconds_used();
    sum.solve_seconds += solved - before;
    const Chunk again = Chunk::from(record);
    for (std::size_t c = 0; c < merged.size(); ++c)
      for (std::size_t j = 0; j < merged[c].size(); ++j) merged[c][j].merge(again.summaries[c][j]);
    sum.merge_seconds += seconds_used() - solved;
    for (const PackedValues& values : chunk.values)
      sum.kept += static_cast<double>(values.bytes.size());
    sum.record += static_cast<double>(record.size());
    sum.chunk_memory += memory_of(again);
    ++count;
    if (count >= least && seconds_used() - start > seconds) break;
  }
  return {sum.solve_seconds / count, sum.merge_seconds / count, write_seconds_of(merged),
          sum.kept / count,          sum.record / count,        sum.chunk_memory / count,
          memory_of(merged)};
}

// Nearly all needs grow in a straight line with the number of speeds: two samples, at `few` and at
// `some` speeds, are extrapolated to all speeds.
Sample at_all_speeds(const SceneSweep& scene, std::uint64_t chunk_groups) {
  constexpr std::size_t few = 32, some = 128;
  constexpr double seconds = 0.1;
  const std::size_t all = widest(scene);
  if (all <= some) return sample_of(thinned(scene, all, chunk_groups), 2 * seconds);
  const Sample low = sample_of(thinned(scene, few, chunk_groups), seconds);
  const Sample high = sample_of(thinned(scene, some, chunk_groups), seconds);
  const double far = static_cast<double>(all - some) / (some - few);
  const auto reach = [&](double Sample::*figure) {
    return high.*figure + std::max(0.0, high.*figure - low.*figure) * far;
  };
  return {reach(&Sample::solve_seconds), reach(&Sample::merge_seconds),
          reach(&Sample::write_seconds), reach(&Sample::kept),
          reach(&Sample::record),        reach(&Sample::chunk_memory),
          reach(&Sample::merged_memory)};
}

// Samples chunks of the scene, with fewer groups if a chunk takes long. Some solved films take ten
// times as long as others: for them chunks of one group from all over the sweep are sampled.
Sample chunk_sample(const SceneSweep& scene) {
  constexpr std::uint64_t probed = 64;
  constexpr double seconds = 0.1;
  std::uint64_t groups = scene.chunk_groups;
  if (scene.solves_film) {
    groups = 1;
  } else if (groups > probed) {
    const double probe =
        sample_of(thinned(scene, std::min<std::size_t>(widest(scene), 128), probed), 0)
            .solve_seconds;
    const double most = static_cast<double>(probed) * seconds / std::max(probe, 1e-9);
    if (most < static_cast<double>(groups))
      groups = std::max(probed, static_cast<std::uint64_t>(most));
  }
  if (groups == scene.chunk_groups && !scene.solves_film) return at_all_speeds(scene, groups);
  Sample sample = scene.solves_film ? sample_of(thinned(scene, widest(scene), 1), 0, 7)
                                    : at_all_speeds(scene, groups);
  const double more = static_cast<double>(scene.chunk_groups) / static_cast<double>(groups);
  sample.solve_seconds *= more;
  sample.record += sample.kept * (more - 1);
  sample.kept *= more;
  return sample;
}

// --- Needs that are known without a sample. Numbers with the word "measured" were measured with
// HDF5 1.10.8. test_sweep.Estimates checks that the sums of all these are within 1.5 times of what
// a sweep takes.

constexpr double program_memory = 25e6;  // before it does anything, with its libraries; measured

constexpr double levels = quantile_levels.size();
// The numbers that the file has for the summary of one value of a case.
constexpr double numbers_of_summary = 6 + 3 * levels + 2 * histogram_bins + 1;

double numbers_of_sensitivity(const SceneSweep& scene) {
  return scene.sensitivity ? 6 * static_cast<double>(scene.drawn()) + 2 : 0;
}

// The bytes of HDF5's groups, datasets and attributes, measured.
double file_overhead(const SceneSweep& scene) {
  constexpr double a_scene = 10e3, a_column = 33e3, a_sensitivity = 22e3, an_input = 0.4e3;
  return a_scene + an_input * static_cast<double>(scene.variables.size()) +
         static_cast<double>(scene.columns.size()) *
             (a_column + (scene.sensitivity ? a_sensitivity : 0)) +
         static_cast<double>(scene.text.size());
}

double summary_bytes(const SceneSweep& scene) {
  return 8 * static_cast<double>(scene.width()) *
         (numbers_of_summary + numbers_of_sensitivity(scene));
}

// The memory of a result without its points, while it is read and printed.
double reading_memory(const SceneSweep& scene) {
  const auto width = static_cast<double>(scene.width());
  const double value =
      sizeof(ColumnResult::Value) + 16 * sizeof(Bounded) + 128 * sizeof(QuantileSketch::Bin) +
      2 * allocation +
      (scene.sensitivity ? 2 * 8 * 3 * 1.5 * static_cast<double>(scene.drawn()) : 0);
  return width * value + 8 * numbers_of_summary * static_cast<double>(widest(scene));
}

// Adds the bytes of a scene to the file and the parts. kept, record: bytes of one chunk there.
void add_files(Needs& needs, const SceneSweep& scene, double kept, double record) {
  constexpr double in_index = 75;  // HDF5's bytes for each chunk of a dataset, measured
  const auto chunks = static_cast<double>(scene.chunks);
  const auto datasets = static_cast<double>(scene.variables.size() + scene.columns.size());
  needs.file += (kept + (scene.keep_points ? in_index * datasets : 0)) * chunks +
                summary_bytes(scene) + file_overhead(scene);
  needs.parts += record * chunks;
}

struct Phases {
  double computing = 0, writing = 0, reading = 0;  // bytes
};

// The most chunks that a process holds: those of the part that it begins, and of the one before it,
// whose last chunks are still being computed.
double chunks_held(const SweepPlan& plan) { return 2 * most_chunks_of_part(plan); }

// sample: of its chunks; merged: the memory of all summaries; held: chunks_held().
Phases phases_of(const SceneSweep& scene, const Sample& sample, double merged, double threads,
                 double held) {
  const auto width = static_cast<double>(scene.width());
  const auto rows = static_cast<double>(scene.cases_per_group());
  const double kept_numbers = scene.keep_points
                                  ? static_cast<double>(scene.chunk_cases()) *
                                        (width + static_cast<double>(scene.variables.size()))
                                  : 0;
  constexpr double solver_numbers = 24;  // for each speed
  const double solver = 8 * (solver_numbers * static_cast<double>(widest(scene)) + rows * width);
  const double sums = scene.sensitivity
                          ? width * jackknife_blocks *
                                (sizeof(SensitivitySums) +
                                 2 * (allocation + 8 * static_cast<double>(scene.drawn())))
                          : 0;
  const auto chunks = static_cast<double>(scene.chunks);
  Phases phases;
  phases.computing =
      threads * (solver + 8 * kept_numbers + sample.chunk_memory + 1.5 * sample.record) +
      std::min(held, chunks) * sample.record +
      (2 * sizeof(std::uint64_t) + sizeof(Part::Record)) * chunks;
  phases.writing = merged + sums + sample.chunk_memory + sample.record +
                   1.5 * 8 * numbers_of_summary * static_cast<double>(widest(scene));
  phases.reading = reading_memory(scene);
  return phases;
}

// --- Free memory and disk.

// The number of a line "Name:   123 kB" in a system file, times `unit`; infinite without one.
double number_in(const char* path, std::string_view name, double unit) {
  std::ifstream file(path);
  std::string word;
  double number = 0;
  while (file >> word)
    if (word == name && file >> number) return number * unit;
  return std::numeric_limits<double>::infinity();
}
double number_in(const char* path) {
  std::ifstream file(path);
  double number = 0;  // "max": there is no limit
  return file >> number ? number : std::numeric_limits<double>::infinity();
}

double memory_there_is() {
  double least = number_in("/proc/meminfo", "MemAvailable:", 1024);
  // In a container: its limit of memory, less the memory in use that is no file cache.
  const double most = number_in("/sys/fs/cgroup/memory.max");
  const double used = number_in("/sys/fs/cgroup/memory.stat", "anon", 1);
  if (std::isfinite(most) && std::isfinite(used)) least = std::min(least, most - used);
  return least;
}

double room_beside(const std::string& path) {
  struct statvfs disk {};
  if (::statvfs(folder_of(path).c_str(), &disk) != 0)
    return std::numeric_limits<double>::infinity();
  return static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
}

}  // namespace

Needs needs_of(const SweepPlan& plan, int threads) {
  constexpr std::uint64_t sampled_groups = 256;
  const double count = thread_count(threads), held = chunks_held(plan);
  Needs needs;
  double computing = 0, writing = 0, reading = 0;
  for (const SceneSweep& scene : plan.scenes) {
    const Sample sample = chunk_sample(scene);
    // Summaries grow with the number of different values, and a chunk may have only one case: this
    // sample takes chunks of up to 256 groups. Solved films take too long for that.
    const double merged =
        scene.solves_film ? static_cast<double>(scene.width()) *
                                QuantileSketch::most_memory(static_cast<double>(scene.cases()))
        : scene.chunk_groups >= sampled_groups
            ? sample.merged_memory
            : at_all_speeds(scene, std::min(scene.groups, sampled_groups)).merged_memory;
    const Phases phases = phases_of(
        scene, sample, merged, std::min<double>(count, static_cast<double>(scene.chunks)), held);
    computing = std::max(computing, phases.computing);
    writing = std::max(writing, phases.writing);
    reading += phases.reading;
    const auto chunks = static_cast<double>(scene.chunks);
    const double seconds_of_value = 2e-6;  // to write its summary and to read it again, measured
    needs.seconds += sample.solve_seconds * chunks / std::min(count, chunks) +
                     sample.merge_seconds * chunks + sample.write_seconds +
                     seconds_of_value * static_cast<double>(scene.width());
    add_files(needs, scene, sample.kept, sample.record);
    needs.point_seconds.push_back(sample.solve_seconds * chunks /
                                  static_cast<double>(scene.points()));
  }
  needs.memory = program_memory + std::max({computing, writing, reading});
  return needs;
}

Needs most_needs(const SweepPlan& plan, int threads) {
  constexpr double packed = 9;      // bytes of a number: eight, if packing does not shorten it
  constexpr double a_dataset = 64;  // of a chunk of a dataset, whatever its size
  constexpr double in_sketch = 5;   // of a case in a part: four for its bin, one for the count
  constexpr double other = 128;     // of a summary, and of a block of sums, in a part
  const double held = chunks_held(plan);
  Needs needs{0, program_memory, 0, 0, {}};
  for (const SceneSweep& scene : plan.scenes) {
    const auto width = static_cast<double>(scene.width());
    const auto cases = static_cast<double>(scene.chunk_cases());
    const auto variables = static_cast<double>(scene.variables.size());
    const double kept =
        scene.keep_points ? packed * cases * (width + variables) +
                                a_dataset * (static_cast<double>(scene.columns.size()) + variables)
                          : 0;
    const double blocks =
        scene.sensitivity
            ? static_cast<double>(std::min<std::uint64_t>(jackknife_blocks, scene.chunk_groups))
            : 0;
    const double sums = other + 2 * 8 * static_cast<double>(scene.drawn());
    const auto summaries = [&](double values) {
      return width * (sizeof(ValueSummary) + 2 * allocation + QuantileSketch::most_memory(values));
    };
    Sample sample;
    sample.record = kept + width * (other + in_sketch * cases + blocks * sums);
    sample.chunk_memory = kept + summaries(cases) + width * blocks * 2 * sums;
    const Phases phases = phases_of(scene, sample, summaries(static_cast<double>(scene.cases())),
                                    thread_count(threads), held);
    needs.memory += phases.computing + phases.writing + phases.reading;
    add_files(needs, scene, kept, sample.record);
  }
  return needs;
}

std::string lack_of_room(const SweepPlan& plan, int threads, const std::string& result,
                         double there) {
  const double memory = memory_there_is(), disk = room_beside(result) + there;
  const auto fits = [&](const Needs& needs) {
    return needs.memory <= memory && needs.file + needs.parts <= disk;
  };
  if (fits(most_needs(plan, threads))) return {};
  const Needs needs = needs_of(plan, threads);
  if (needs.memory > memory)
    return "needs some " + bytes_text(needs.memory) + " of memory, and this machine has " +
           bytes_text(memory) + " free; allowed: fewer speeds, fewer outputs or fewer --threads";
  if (needs.file + needs.parts > disk)
    return "needs some " + bytes_text(needs.file + needs.parts) +
           " on the disk for the result and its parts, and there are " + bytes_text(disk) +
           " free; allowed: fewer cases, keep = \"summaries\", or another disk";
  return {};
}

}  // namespace tribo::sweep
