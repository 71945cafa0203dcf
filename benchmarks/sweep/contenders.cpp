// SPDX-License-Identifier: Apache-2.0
#include "contenders.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "alone.hpp"
#include "sweep/case_solver.hpp"
#include "sweep/cases.hpp"
#include "sweep/chunk_solver.hpp"
#include "sweep/packed_values.hpp"
#include "sweep/part.hpp"
#include "sweep/parts_in_hand.hpp"
#include "sweep/run.hpp"
#include "sweep/summary.hpp"
#include "tests/support/temporary_folder.hpp"
#include "workloads.hpp"

namespace tribo::benchmarks {
namespace {

constexpr std::uint64_t draws = 1 << 20;           // in chunks of 4096
constexpr std::uint64_t draws_of_a_run = 1 << 18;  // a run includes its start and its end
constexpr std::uint64_t chunks_in_turn = 8;        // different chunks, on one thread
constexpr std::uint64_t chunks_on_threads = 256;   // chunks of an iteration on threads

// Writes the parts of a sweep as a run does: each part once it has all its chunks. Any thread may
// call keep().
class NewParts {
 public:
  explicit NewParts(const sweep::SweepPlan& plan) : header_(sweep::header_of(plan)) {
    sweep::ChunkList all(plan.chunks());
    std::iota(all.begin(), all.end(), std::uint64_t{0});
    chunks_a_part_ = sweep::cut_in_parts(plan, all).front().size();
  }
  void keep(const sweep::Chunk& chunk) {
    sweep::Bytes bytes = chunk.bytes();
    sweep::ChunksInMemory whole;
    std::uint64_t part = 0;
    {
      const std::lock_guard lock(mutex_);
      chunks_.emplace(next_++, std::move(bytes));
      if (chunks_.size() < chunks_a_part_) return;
      whole.swap(chunks_);
      part = parts_++;
    }
    // Threads write at the same time, but no two threads write to the same file.
    constexpr std::uint64_t most_threads = 256;
    const std::string path = folder_.file("part" + std::to_string(part % most_threads));
    sweep::PartFile file(path);
    sweep::write_part(path, file, header_, sweep::content_of(whole), {.any = true, .only = {}});
  }
  std::uint64_t kept() const { return next_; }

 private:
  TemporaryFolder folder_;
  sweep::PartHeader header_;
  std::size_t chunks_a_part_ = 1;
  std::mutex mutex_;
  std::uint64_t next_ = 0, parts_ = 0;
  sweep::ChunksInMemory chunks_;
};

// A workload with the data that its contenders share.
class Subject {
 public:
  explicit Subject(const Workload& workload)
      : workload_(workload),
        summaries_(plan_of(workload, draws, "summaries")),
        points_(plan_of(workload, draws, "points")) {
    sweep::CaseGenerator generator(scene());
    inputs_.resize(chunks_in_turn);
    for (std::uint64_t c = 0; c < chunks_in_turn; ++c) {
      inputs_[c].resize(cases() * scene().variables.size());
      generator.groups(c * scene().chunk_groups, inputs_[c]);
    }
    results_.resize(cases() * scene().width());
    Alone(scene()).solve(inputs_[0], results_);
  }

  const Workload& workload() const { return workload_; }
  const sweep::SweepPlan& summaries() const { return summaries_; }
  const sweep::SweepPlan& points() const { return points_; }
  const sweep::SceneSweep& scene() const { return summaries_.scenes.front(); }
  std::size_t cases() const { return scene().chunk_groups; }
  std::span<const double> inputs(std::uint64_t turn) const {
    return inputs_[turn % chunks_in_turn];
  }
  std::span<const double> block() const {
    return inputs(0).first(Alone::block_cases * scene().variables.size());
  }
  std::span<const double> results() const { return results_; }  // of the first chunk

 private:
  const Workload& workload_;
  sweep::SweepPlan summaries_, points_;
  std::vector<std::vector<double>> inputs_;
  std::vector<double> results_;
};

using Shared = std::shared_ptr<const Subject>;
using Contender = std::function<void(const Subject&, benchmark::State&)>;

benchmark::internal::Benchmark* add(const Shared& subject, std::string_view name,
                                    Contender contender) {
  return benchmark::RegisterBenchmark(
      fmt::format("{}/{}", subject->workload().name, name).c_str(),
      [subject, contender = std::move(contender)](benchmark::State& state) {
        try {
          contender(*subject, state);
        } catch (const std::exception& error) {
          state.SkipWithError(error.what());
        }
      });
}

void set_points(benchmark::State& state, std::size_t points) {
  state.counters["points"] = static_cast<double>(points);
}

// --- One thread: the needed work alone, and the sweep.

// Times the way from drawn values to results, by Alone or by the sweep's own CaseSolver.
template <class Solver>
void solve_cases(const Subject& subject, benchmark::State& state) {
  Solver solver(subject.scene());
  std::vector<double> results(subject.cases() * subject.scene().width());
  std::uint64_t turn = 0;
  for (const auto _ : state) {
    solver.solve(subject.inputs(turn++), results);
    benchmark::DoNotOptimize(results.data());
    benchmark::ClobberMemory();
  }
  set_points(state, subject.cases());
}

Contender sweep_of(const sweep::SweepPlan& (Subject::*plan)() const) {
  return [plan](const Subject& subject, benchmark::State& state) {
    sweep::ChunkSolver solver((subject.*plan)());
    NewParts parts((subject.*plan)());
    std::uint64_t turn = 0;
    for (const auto _ : state) parts.keep(solver.solve(turn++ % chunks_in_turn));
    set_points(state, subject.cases());
  };
}

// --- Stages.

void draw(const Subject& subject, benchmark::State& state) {
  sweep::CaseGenerator generator(subject.scene());
  std::vector<double> values(subject.inputs(0).size());
  std::uint64_t turn = 0;
  for (const auto _ : state) {
    generator.groups(turn++ % chunks_in_turn * subject.scene().chunk_groups, values);
    benchmark::DoNotOptimize(values.data());
    benchmark::ClobberMemory();
  }
  set_points(state, subject.cases());
}

// Times one step of Alone on a block that was solved before. If the step gives results, they are
// overwritten beforehand, and it has to give the same results again; else the contender fails.
enum class Gives { nothing, results };
Contender stage(Gives gives, std::function<void(Alone&, const Subject&, std::span<double>)> step) {
  return [gives, step = std::move(step)](const Subject& subject, benchmark::State& state) {
    Alone solver(subject.scene());
    std::vector<double> results(Alone::block_cases * subject.scene().width());
    solver.solve(subject.block(), results);
    const std::vector<double> expected = results;
    if (gives == Gives::results) std::fill(results.begin(), results.end(), -1.0);
    for (const auto _ : state) {
      step(solver, subject, results);
      benchmark::DoNotOptimize(results.data());
      benchmark::ClobberMemory();
    }
    if (std::memcmp(results.data(), expected.data(), results.size() * sizeof(double)) != 0)
      state.SkipWithError("the step does not give the results of all steps");
    set_points(state, Alone::block_cases);
  };
}

void sum_up(const Subject& subject, benchmark::State& state) {
  const std::span<const double> results = subject.results();
  const std::size_t width = subject.scene().width();
  std::vector<double> column;
  for (const auto _ : state) {
    std::vector<sweep::ValueSummary> summaries(width);
    for (std::size_t c = 0; c < width; ++c) {
      column.clear();
      for (std::size_t i = c; i < results.size(); i += width) column.push_back(results[i]);
      summaries[c].add(column);
    }
    benchmark::DoNotOptimize(summaries.data());
  }
  set_points(state, subject.cases());
}

void pack(const Subject& subject, benchmark::State& state) {
  const std::size_t fields = subject.scene().variables.size(), width = subject.scene().width();
  std::vector<std::vector<double>> columns(fields + width);
  for (std::size_t i = 0; i < subject.cases(); ++i) {
    for (std::size_t v = 0; v < fields; ++v)
      columns[v].push_back(subject.inputs(0)[i * fields + v]);
    for (std::size_t c = 0; c < width; ++c)
      columns[fields + c].push_back(subject.results()[i * width + c]);
  }
  for (const auto _ : state)
    for (const std::vector<double>& column : columns) {
      const sweep::PackedValues packed = sweep::pack(std::span<const double>(column));
      benchmark::DoNotOptimize(packed.bytes.data());
    }
  set_points(state, subject.cases());
}

void keep(const Subject& subject, benchmark::State& state) {
  const sweep::Chunk chunk = sweep::ChunkSolver(subject.points()).solve(0);
  NewParts parts(subject.points());
  for (const auto _ : state) parts.keep(chunk);
  set_points(state, subject.cases());
}

// --- All threads.

// Seconds that this thread, since its start, was ready to run but waited for a processor, as Linux
// counts them. 0 if the system does not count them.
double seconds_kept_waiting() {
  std::ifstream file("/proc/thread-self/schedstat");
  double running = 0, waiting = 0;
  file >> running >> waiting;
  return 1e-9 * waiting;
}

// The real time of threads that share work, without their waits for other processes.
class UndisturbedTime {
 public:
  void begin() {
    const std::lock_guard lock(mutex_);
    started_.emplace(std::this_thread::get_id(), Moment{Clock::now(), seconds_kept_waiting()});
  }
  void end() {
    const std::lock_guard lock(mutex_);
    const Moment& start = started_.at(std::this_thread::get_id());
    seconds_ += std::chrono::duration<double>(Clock::now() - start.time).count() -
                (seconds_kept_waiting() - start.waited);
  }
  // All threads end at about the same time, as a thread that is disturbed less takes more chunks.
  double seconds(int threads) const { return seconds_ / threads; }
  bool has_begun() {
    const std::lock_guard lock(mutex_);
    return started_.contains(std::this_thread::get_id());
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Moment {
    Clock::time_point time;
    double waited;
  };
  std::mutex mutex_;
  std::map<std::thread::id, Moment> started_;
  double seconds_ = 0;
};

Contender on_threads(const sweep::SweepPlan& (Subject::*plan)() const, int threads) {
  return [plan, threads](const Subject& subject, benchmark::State& state) {
    NewParts parts((subject.*plan)());
    for (const auto _ : state) {
      std::atomic<std::uint64_t> next = 0;
      UndisturbedTime time;
      sweep::compute((subject.*plan)(), threads,
                     [&]() -> std::optional<std::uint64_t> {
                       if (!time.has_begun()) time.begin();
                       const std::uint64_t chunk = next++;
                       if (chunk < chunks_on_threads) return chunk;
                       time.end();
                       return std::nullopt;
                     },
                     [&](const sweep::Chunk& chunk) { parts.keep(chunk); });
      state.SetIterationTime(time.seconds(threads));
    }
    if (parts.kept() != chunks_on_threads * static_cast<std::uint64_t>(state.iterations()))
      state.SkipWithError("the threads did not compute each chunk once");
    set_points(state, chunks_on_threads * subject.cases());
    state.counters[std::string(threads_counter)] = threads;
  };
}

Contender whole_run(std::string_view kept, int threads) {
  return [kept, threads](const Subject& subject, benchmark::State& state) {
    const sweep::SweepPlan plan = plan_of(subject.workload(), draws_of_a_run, kept);
    const TemporaryFolder folder;
    const sweep::Ranks ranks;
    sweep::RunSettings settings;
    settings.result = folder.file("result.h5");
    settings.threads = threads;
    settings.force = true;
    settings.tell = [](std::string_view) {};
    for (const auto _ : state) sweep::run(plan, settings, ranks);
    set_points(state, plan.points());
    state.counters[std::string(threads_counter)] = threads;
  };
}

void register_sweep(const Workload& workload) {
  const auto subject = std::make_shared<const Subject>(workload);
  add(subject, alone, solve_cases<Alone>);
  add(subject, "summaries", sweep_of(&Subject::summaries));
  add(subject, "points", sweep_of(&Subject::points));
  add(subject, "stage: draw", draw);
  if (workload.varied.size() > 1) {
    add(subject, "stage: prepare",
        stage(Gives::nothing, [](Alone& solver, const Subject& of, std::span<double>) {
          solver.prepare(of.block());
        }));
    if (workload.settings.empty()) {
      add(subject, "stage: points",
          stage(Gives::results, [](Alone& solver, const Subject&, std::span<double> to) {
            solver.solve_points(to);
          }));
    } else {
      add(subject, "stage: onset",
          stage(Gives::results, [](Alone& solver, const Subject&, std::span<double> to) {
            solver.find_onsets(to);
          }));
    }
  }
  add(subject, "stage: cases", solve_cases<sweep::CaseSolver>);
  add(subject, "stage: sum up", sum_up);
  add(subject, "stage: pack points", pack);
  add(subject, "stage: parts of points", keep);
  for (const int threads : {1, 2}) {
    const auto timed = [&](std::string_view name, Contender contender) {
      return add(subject, fmt::format("{}, threads: {}", name, threads), std::move(contender))
          ->Iterations(1);
    };
    timed("chunks with summaries", on_threads(&Subject::summaries, threads))->UseManualTime();
    timed("chunks with points", on_threads(&Subject::points, threads))->UseManualTime();
    timed("run of summaries", whole_run("summaries", threads))->UseRealTime();
    timed("run of points", whole_run("points", threads))->UseRealTime();
  }
}

}  // namespace

void register_sweeps() {
  for (const Workload& workload : workloads()) register_sweep(workload);
}

}  // namespace tribo::benchmarks
