// SPDX-License-Identifier: Apache-2.0
// A sweep from its plan to its result: threads, ranks, helpers, going on after a stop.
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

// The i-th of n shards, 1 ≤ i ≤ n: every n-th chunk, so that all get some slow chunks.
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
  int threads = 0;     // of each rank; 0: as many as the machine has, 1 under mpirun
  std::optional<Shard> shard;
  bool resume = false;     // go on with parts that are there
  bool join = false;       // as resume, but also help a process that owns the output already
  bool force = false;      // throw away parts and the result that are there
  bool mixed_fma = false;  // go on with parts of another arithmetic
  std::function<void(const RunProgress&)> progress;  // some times a second, from one thread
  std::function<void(std::string_view)> tell;        // a line on what was found or done
  // Says at once, on the rank that fails, why it fails, for the other ranks may go on for long.
  std::function<void(std::string_view)> failed;
  std::function<bool()> stopped;  // to end early, with what is computed kept
  // Called on rank 0 once the result has its name, and before another process can replace it; gets
  // the open result where this process has written it.
  std::function<void(std::optional<Descriptor>)> finished;
};

// Another rank failed, and has said why.
struct OtherRankFailed : std::runtime_error {
  OtherRankFailed() : std::runtime_error("another rank failed") {}
};

enum class RunEnd : std::uint8_t { done, stopped };

// Every rank calls it with the same plan and settings; rank 0 holds the output's lock and writes
// the result, or, with `join`, helps the process that does. Throws RunRefused, OtherRankFailed, and
// std::runtime_error where it fails; computed parts stay then. Where a rank fails, the others
// compute its parts too, and the result is written if all are there.
RunEnd run(const SweepPlan& plan, RunSettings settings, const Ranks& ranks);

// Puts shards together: the result has the bits of an undivided run. Throws RunRefused where chunks
// are missing, or shards do not fit together.
RunEnd merge(const std::vector<std::string>& shards, RunSettings settings);

}  // namespace tribo::sweep
