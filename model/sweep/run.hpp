// SPDX-License-Identifier: Apache-2.0
// Runs a sweep from its plan to its result on threads, ranks and helpers; resumes stopped runs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/disk.hpp"
#include "sweep/output_file.hpp"
#include "sweep/plan.hpp"
#include "sweep/ranks.hpp"

namespace tribo::sweep {

// Shard i (`part`) of n (`parts`), 1 ≤ i ≤ n: every n-th chunk, so that each gets some slow ones.
struct Shard {
  std::uint64_t part = 1, parts = 1;
  bool has(std::uint64_t chunk) const { return chunk % parts == part - 1; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

struct RunProgress {
  enum class Phase : std::uint8_t { computing, writing } phase = Phase::computing;
  std::uint64_t chunks = 0;  // that this run has to compute, or to write
  std::uint64_t done = 0;    // that all ranks have done
};

struct RunSettings {
  std::string result;  // path of the HDF5 file, or of the shard
  int threads = 0;     // of each rank; 0: as many as it may run on, 1 under mpirun
  std::optional<Shard> shard;
  bool resume = false;     // go on with parts that are there
  bool join = false;       // as resume, but also help a process that owns the output already
  bool force = false;      // throw away parts and the result that are there
  bool mixed_fma = false;  // go on with parts of another arithmetic
  std::function<void(const RunProgress&)> progress;  // some times a second, from one thread
  std::function<void(std::string_view)> tell;        // a line on what was found or done
  // Told the reason at once on a rank that fails, because the other ranks may go on for long.
  std::function<void(std::string_view)> failed;
  std::function<bool()> stopped;  // true: end early, and keep what is computed
  // Called on rank 0 once the result has its name, before another process can replace it. Its
  // argument is the open result, if this process has written it.
  std::function<void(std::optional<Descriptor>)> finished;
};

// Another rank failed, and has said why.
struct OtherRankFailed : std::runtime_error {
  OtherRankFailed() : std::runtime_error("another rank failed") {}
};

enum class RunEnd : std::uint8_t { done, stopped };

// Every rank calls it with the same plan and settings. Rank 0 takes the output's lock and writes
// the result. With `join`, if another process has the lock, it helps that process. Throws
// RunRefused, OtherRankFailed or std::runtime_error where it fails; computed parts are kept. Where
// a rank fails, the others compute its parts too, and the result is written if all are there.
RunEnd run(const SweepPlan& plan, RunSettings settings, const Ranks& ranks);

// Puts shards together to a result with the same bits as that of an undivided run. Throws
// RunRefused where chunks are missing, or shards do not fit together.
RunEnd merge(const std::vector<std::string>& shards, RunSettings settings);

}  // namespace tribo::sweep
