// SPDX-License-Identifier: Apache-2.0
// The processes that share a sweep: one, or as many as mpirun started. Rank 0 hands out chunks to
// whoever asks, so that a slow rank holds nobody up; what is computed stays with the rank that did.
// Built with ranks_mpi.cpp where MPI was found, else with ranks_alone.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sweep/chunk_queue.hpp"

namespace tribo::sweep {

// The next chunk for this process; nothing: no more. Any thread may ask.
using NextChunk = std::function<std::optional<std::uint64_t>()>;

class Ranks {
 public:
  // Joins the other processes if mpirun started this process. Throws std::invalid_argument if
  // mpirun did and this program was built without MPI. A process may have one Ranks at a time; with
  // MPI, only one in all its life.
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();  // waits for the others

  int rank() const { return rank_; }
  int count() const { return count_; }
  static bool has_mpi();

  // Rank 0's text, on all ranks.
  std::string from_first(std::string text) const;
  // Is it so on every rank? Waits for all.
  bool everywhere(bool mine) const;

  // Runs compute(next) on every rank; returns when all ranks have left it. Only the `queue` of rank
  // 0 is used. tick() is called some times a second, on rank 0 with the number of chunks that other
  // ranks have computed so far. Once stopped() is true, no more chunks are handed out. Rank 0 gets
  // false if compute threw on another rank; an exception of this rank's compute is thrown on.
  bool share(ChunkQueue& queue, const std::function<void(const NextChunk&)>& compute,
             const std::function<void(std::uint64_t)>& tick,
             const std::function<bool()>& stopped) const;

 private:
  int rank_ = 0;
  int count_ = 1;
  bool joined_ = false;  // MPI is to be ended
};

}  // namespace tribo::sweep
