// SPDX-License-Identifier: Apache-2.0
#include "sweep/chunk_solver.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

#include "sweep/case_solver.hpp"
#include "sweep/cases.hpp"
#include "sweep/on_threads.hpp"

namespace tribo::sweep {
namespace {

// A block of this many numbers is solved and then summed up while it is in the cache.
constexpr std::size_t block_numbers = 8192;

}  // namespace

struct ChunkSolver::OfScene {
  OfScene(const SceneSweep& s, const std::function<bool()>& stopped)
      : sweep(s), generator(s), solver(s, stopped) {
    if (!s.sensitivity) return;
    // The constants c of sensitivity.hpp are the results at the nominal values.
    std::vector<double> nominal_values;
    for (const Variable& variable : s.variables) nominal_values.push_back(variable.nominal);
    nominal.resize(s.width());
    solver.solve(nominal_values, nominal);
    for (double& value : nominal)
      if (!std::isfinite(value)) value = 0;
  }

  // Copies the kept cases of the block to their places in the chunk, from group `first` of the
  // chunk on.
  void keep(std::uint64_t first) {
    const std::size_t rows = sweep.cases_per_group(), kept_rows = sweep.cases_kept_per_group();
    const std::size_t variables = sweep.variables.size(), width = sweep.width();
    const std::size_t groups = values.size() / (rows * variables);
    const auto for_each_case = [&](const auto& visit) {  // visit(its place, its row of the block)
      for (std::size_t g = 0; g < groups; ++g)
        for (std::size_t row = 0; row < kept_rows; ++row)
          visit((first + g) * kept_rows + row, g * rows + row);
    };
    for (std::size_t v = 0; v < variables; ++v)
      for_each_case([&, to = kept[v].data()](std::size_t place, std::size_t row) {
        to[place] = values[row * variables + v];
      });
    std::size_t at = 0;
    for (std::size_t c = 0; c < sweep.columns.size(); ++c) {
      const std::size_t w = sweep.columns[c].width;
      for_each_case([&, to = kept[variables + c].data()](std::size_t place, std::size_t row) {
        std::copy_n(&results[row * width + at], w, to + place * w);
      });
      at += w;
    }
  }

  const SceneSweep& sweep;
  CaseGenerator generator;
  CaseSolver solver;
  std::vector<double> nominal;
  std::vector<double> values, results;    // of a block
  std::vector<std::vector<double>> kept;  // of the chunk: inputs, columns
};

namespace {

// A kept array as bytes; a word is kept as its place in a list.
PackedValues packed(const std::vector<double>& values, bool words) {
  if (!words) return pack(std::span<const double>(values));
  std::vector<std::uint8_t> places(values.size());
  std::transform(values.begin(), values.end(), places.begin(),
                 [](double value) { return static_cast<std::uint8_t>(value); });
  return pack(std::span<const std::uint8_t>(places));
}

class ChunkInHand {
 public:
  ChunkInHand(const SceneSweep& sweep, Chunk& chunk) : sweep_(sweep), chunk_(chunk) {
    for (const Column& column : sweep.columns) {
      chunk_.summaries.emplace_back(column.width);
      if (sweep.sensitivity) chunk_.sensitivities.emplace_back(column.width);
    }
  }

  // The results of some groups' cases, row by row.
  void add(std::uint64_t first, std::span<const double> results, std::span<const double> nominal) {
    const std::size_t width = sweep_.width(), kept = sweep_.cases_kept_per_group();
    const std::size_t group_size = sweep_.cases_per_group() * width;
    std::size_t at = 0;
    for (std::size_t c = 0; c < sweep_.columns.size(); ++c)
      for (std::size_t j = 0; j < sweep_.columns[c].width; ++j, ++at) {
        of_column_.clear();
        for (std::size_t group = 0; group < results.size(); group += group_size)
          for (std::size_t row = 0; row < kept; ++row)
            of_column_.push_back(results[group + row * width + at]);
        chunk_.summaries[c][j].add(of_column_);
        if (!sweep_.sensitivity) continue;
        for (std::size_t g = 0; g < results.size() / group_size; ++g)
          add_sensitivity(first + g, c, j, at, results.subspan(g * group_size, group_size),
                          nominal[at]);
      }
  }

 private:
  void add_sensitivity(std::uint64_t group, std::size_t c, std::size_t j, std::size_t at,
                       std::span<const double> results, double nominal) {
    const std::size_t width = sweep_.width();
    of_column_.resize(sweep_.cases_per_group());
    for (std::size_t row = 0; row < of_column_.size(); ++row)
      of_column_[row] = results[row * width + at];
    const auto block = static_cast<std::uint32_t>(block_of(group, sweep_.groups));
    chunk_.sensitivities[c][j][block].add(of_column_, nominal);
  }

  const SceneSweep& sweep_;
  Chunk& chunk_;
  std::vector<double> of_column_;  // the values of one column, of some groups or of one
};

}  // namespace

ChunkSolver::ChunkSolver(const SweepPlan& plan, std::function<bool()> stopped)
    : plan_(plan), stopped_(std::move(stopped)), scenes_(plan.scenes.size()) {}
ChunkSolver::ChunkSolver(ChunkSolver&&) noexcept = default;
ChunkSolver::~ChunkSolver() = default;

Chunk ChunkSolver::solve(std::uint64_t number) {
  const ChunkPlace place = place_of(plan_, number);
  const SceneSweep& sweep = plan_.scenes[place.scene];
  if (!scenes_[place.scene]) scenes_[place.scene] = std::make_unique<OfScene>(sweep, stopped_);
  OfScene& of = *scenes_[place.scene];

  Chunk chunk;
  chunk.number = number;
  ChunkInHand in_hand(sweep, chunk);
  const std::size_t variables = sweep.variables.size(), width = sweep.width();
  const std::size_t rows = sweep.cases_per_group();
  if (sweep.keep_points) {
    of.kept.resize(variables + sweep.columns.size());
    for (std::size_t v = 0; v < variables; ++v) of.kept[v].assign(sweep.chunk_cases(), 0);
    for (std::size_t c = 0; c < sweep.columns.size(); ++c)
      of.kept[variables + c].assign(sweep.chunk_cases() * sweep.columns[c].width, 0);
  }
  const std::uint64_t block =
      std::max<std::uint64_t>(1, block_numbers / (rows * (width + variables)));
  for (std::uint64_t first = 0; first < place.groups; first += block) {
    const auto some = static_cast<std::size_t>(std::min(block, place.groups - first));
    of.values.resize(some * rows * variables);
    of.results.resize(some * rows * width);
    of.generator.groups(place.first_group + first, of.values);
    of.solver.solve(of.values, of.results);
    in_hand.add(place.first_group + first, of.results, of.nominal);
    if (sweep.keep_points) of.keep(first);
  }
  if (!sweep.keep_points) return chunk;
  for (std::size_t v = 0; v < variables; ++v)
    chunk.values.push_back(packed(of.kept[v], !sweep.variables[v].words.empty()));
  for (std::size_t c = 0; c < sweep.columns.size(); ++c)
    chunk.values.push_back(packed(of.kept[variables + c], !sweep.columns[c].words.empty()));
  return chunk;
}

int compute(const SweepPlan& plan, int threads, const NextChunk& next,
            const std::function<void(const Chunk&)>& keep, const std::function<bool()>& stopped) {
  std::atomic<bool> failed = false;
  // More threads than the machine has are allowed, as they are elsewhere.
  return on_threads(thread_count(threads), [&] {
    ChunkSolver solver(plan, [&] { return failed || (stopped && stopped()); });
    try {
      while (!failed) {
        const auto chunk = next();
        if (!chunk) return;
        keep(solver.solve(*chunk));
      }
    } catch (const Stopped&) {  // in the middle of a chunk, which a later run computes anew
    } catch (...) {
      failed = true;
      throw;
    }
  });
}

}  // namespace tribo::sweep
