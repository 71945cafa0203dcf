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

// A block of about block_numbers numbers is solved, then summed up in the cache. It has at least
// few_groups groups, up to most_block_numbers: with fewer, summing up takes longer than solving.
constexpr std::size_t block_numbers = 8192, few_groups = 8, most_block_numbers = 1 << 17;

}  // namespace

struct ChunkSolver::OfScene {
  OfScene(const SceneSweep& s, const std::function<bool()>& stopped)
      : sweep(s),
        variables(s.variables.size()),
        width(s.width()),
        rows(s.cases_per_group()),
        generator(s),
        solver(s, stopped) {
    if (s.keep_points) list_kept();
    if (!s.sensitivity) return;
    // The constants c of sensitivity.hpp are the results at the nominal values.
    std::vector<double> nominal_values;
    for (const Variable& variable : s.variables) nominal_values.push_back(variable.nominal);
    nominal.resize(width);
    solver.solve(nominal_values, nominal);
    for (double& value : nominal)
      if (!std::isfinite(value)) value = 0;
  }

  // The inputs and columns of the chunk that are kept, in their order.
  struct Kept {
    const std::vector<double>& block;  // a row of it has the numbers of a case
    std::size_t row_size, at, width;   // `width` numbers of a row are kept, from `at` on
    bool words;
    std::vector<double> numbers = {};  // of the chunk

    // A word is kept as its place in a list.
    PackedValues packed() const {
      if (!words) return pack(std::span<const double>(numbers));
      std::vector<std::uint8_t> places(numbers.size());
      std::transform(numbers.begin(), numbers.end(), places.begin(),
                     [](double number) { return static_cast<std::uint8_t>(number); });
      return pack(std::span<const std::uint8_t>(places));
    }
  };
  void list_kept() {
    for (std::size_t v = 0; v < variables; ++v)
      kept.push_back({values, variables, v, 1, !sweep.variables[v].words.empty()});
    std::size_t at = 0;
    for (const Column& column : sweep.columns) {
      kept.push_back({results, width, at, column.width, !column.words.empty()});
      at += column.width;
    }
  }

  // Copies the kept cases of the block to their places in the chunk, from group `first` of the
  // chunk on.
  void keep(std::uint64_t first, std::size_t groups) {
    const std::size_t kept_rows = sweep.cases_kept_per_group();
    for (Kept& one : kept)
      for (std::size_t g = 0; g < groups; ++g)
        for (std::size_t row = 0; row < kept_rows; ++row) {
          const double* const from = &one.block[(g * rows + row) * one.row_size + one.at];
          double* const to = &one.numbers[((first + g) * kept_rows + row) * one.width];
          if (one.width == 1)
            *to = *from;
          else
            std::copy_n(from, one.width, to);
        }
  }

  // Adds the results of the block to the sums. Its first group is group `first` of the scene.
  void sum_up(Chunk& chunk, std::uint64_t first, std::size_t groups) {
    const std::size_t kept_rows = sweep.cases_kept_per_group();
    std::size_t at = 0;
    for (std::size_t c = 0; c < sweep.columns.size(); ++c)
      for (std::size_t j = 0; j < sweep.columns[c].width; ++j, ++at) {
        take_column(at, 0, groups, kept_rows);
        chunk.summaries[c][j].add(of_column);
        for (std::size_t g = 0; sweep.sensitivity && g < groups; ++g) {
          take_column(at, g, g + 1, rows);
          const auto block = static_cast<std::uint32_t>(block_of(first + g, sweep.groups));
          chunk.sensitivities[c][j][block].add(of_column, nominal[at]);
        }
      }
  }
  // Takes the numbers of a column from the first `cases` cases of the groups from `group` to `end`.
  void take_column(std::size_t at, std::size_t group, std::size_t end, std::size_t cases) {
    of_column.clear();
    for (; group < end; ++group)
      for (std::size_t row = 0; row < cases; ++row)
        of_column.push_back(results[(group * rows + row) * width + at]);
  }

  const SceneSweep& sweep;
  const std::size_t variables, width, rows;  // of a block: numbers a case, and cases a group
  CaseGenerator generator;
  CaseSolver solver;
  std::vector<double> nominal;
  std::vector<double> values, results;  // of a block
  std::vector<Kept> kept;               // none where points are not kept
  std::vector<double> of_column;
};

ChunkSolver::ChunkSolver(const SweepPlan& plan, std::function<bool()> stopped)
    : plan_(plan), stopped_(std::move(stopped)), scenes_(plan.scenes.size()) {}
ChunkSolver::~ChunkSolver() = default;

Chunk ChunkSolver::solve(std::uint64_t number) {
  const ChunkPlace place = place_of(plan_, number);
  const SceneSweep& sweep = plan_.scenes[place.scene];
  if (!scenes_[place.scene]) scenes_[place.scene] = std::make_unique<OfScene>(sweep, stopped_);
  OfScene& of = *scenes_[place.scene];

  Chunk chunk;
  chunk.number = number;
  for (const Column& column : sweep.columns) {
    chunk.summaries.emplace_back(column.width);
    if (sweep.sensitivity) chunk.sensitivities.emplace_back(column.width);
  }
  for (OfScene::Kept& one : of.kept) one.numbers.assign(sweep.chunk_cases() * one.width, 0);
  const std::size_t of_group = of.rows * (of.width + of.variables);
  const std::uint64_t block = std::max<std::uint64_t>(
      {1, block_numbers / of_group, std::min(few_groups, most_block_numbers / of_group)});
  for (std::uint64_t first = 0; first < place.groups; first += block) {
    const auto groups = static_cast<std::size_t>(std::min(block, place.groups - first));
    of.values.resize(groups * of.rows * of.variables);
    of.results.resize(groups * of.rows * of.width);
    of.generator.groups(place.first_group + first, of.values);
    of.solver.solve(of.values, of.results);
    of.sum_up(chunk, place.first_group + first, groups);
    of.keep(first, groups);
  }
  for (const OfScene::Kept& one : of.kept) chunk.values.push_back(one.packed());
  return chunk;
}

int compute(const SweepPlan& plan, int threads, const NextChunk& next,
            const std::function<void(const Chunk&)>& keep, const std::function<bool()>& stopped) {
  std::atomic<bool> failed = false;
  // `threads` may exceed the number of processors, as everywhere.
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
