// SPDX-License-Identifier: Apache-2.0
// How the processes of a sweep share its work: each takes parts that are not there. OUTPUT.part-F-L
// holds the chunks from F to L, and OUTPUT.part-F-L-S each S-th of them; whoever computes it claims
// it by a lock, this name and .lock, writes it at a name that no other process uses, and renames it
// when it is whole. Where a file system has no locks, two processes may compute the same part: that
// loses time, never numbers.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sweep/output_file.hpp"
#include "sweep/part.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

using ChunkList = std::vector<std::uint64_t>;  // numbers, ascending

// Cuts chunks into at most some 4096 parts of some seconds of one processor each. The borders
// follow from the plan and the chunks alone: from how many points there are, and what a point of
// its kind takes on an ordinary machine. TRIBOCHECK_PART_CHUNKS in the environment, for tests, asks
// for so many chunks a part.
std::vector<ChunkList> cut_in_parts(const SweepPlan& plan, const ChunkList& chunks);

// No part of cut_in_parts() has more chunks, when all chunks of the plan are cut. It does not cut
// them: a sweep that has no room may have 10⁸ chunks.
double most_chunks_of_part(const SweepPlan& plan);

// Two lists of chunks that a run or a shard is cut into have the same path only if they are the
// same.
std::string path_of_part(const std::string& output, const ChunkList& chunks);
// The parts that are there of an output; and all files that computing them leaves, with claims and
// with files that a killed process has not given their name.
std::vector<std::string> parts_of(const std::string& output);
std::vector<std::string> files_of_parts(const std::string& output);
// Removes the files that killed processes have not given their name, of parts and of the result,
// for the process that holds the output's lock; not those of parts that another process has
// claimed.
void remove_begun(const std::string& output);
// The journals that a tribocheck before this one, which had them in place of parts, has left.
std::vector<std::string> journals_of(const std::string& output);

// A part among so many with which this process begins: by its host and number, and by the turn.
std::size_t place_of_process(std::size_t parts, std::uint64_t turn = 0);

class PartsInHand {
 public:
  struct Settings {
    std::string output;
    PartHeader header;
    std::size_t begin = 0;       // the part with which this process begins
    bool in_memory = false;      // all parts are of this process, and none is written
    std::function<bool()> over;  // asked before a part is begun: is nobody waiting for it any more?
  };
  // there: the parts that need not be computed. Throws std::runtime_error, with a text that names
  // the file, where the others could not be written.
  PartsInHand(Settings settings, std::vector<ChunkList> parts, const std::vector<bool>& there);

  // Looks for work of this process: chunks in hand, or else a part that it claims. False where all
  // parts are there or claimed.
  bool has_work();
  // Is every part there, or the whole over?
  bool is_done();
  // The next chunk of this process. Any thread may ask.
  std::optional<std::uint64_t> next();
  // Keeps a chunk that next() has given; the last one of its part writes the part. Any thread may
  // call. Throws std::runtime_error, with a text that names the file, where it cannot be written.
  void keep(std::uint64_t chunk, Bytes bytes);
  // Chunks that are there or kept, as far as is known: of other processes once a second.
  std::uint64_t chunks_there();
  ChunksInMemory take_memory() { return std::move(in_memory_); }

 private:
  using Clock = std::chrono::steady_clock;
  struct InHand {
    std::size_t part;
    std::optional<OutputLock> claim = {};
    std::size_t next = 0;  // of its chunks, to be handed out
    ChunksInMemory kept = {};
  };
  bool has_chunks() const;
  bool find_work(std::unique_lock<std::mutex>& lock);
  std::vector<std::size_t> missing();
  std::optional<InHand> claim();
  void look();
  void write(InHand done);

  Settings settings_;
  std::vector<ChunkList> parts_;
  std::vector<bool> there_;
  std::mutex mutex_;                 // not held while files are looked at
  std::condition_variable claimed_;  // is_claiming_ has ended
  bool is_claiming_ = false;         // one thread at a time, for all
  std::list<InHand> in_hand_;        // the last one has chunks left to hand out, if any has
  std::atomic<bool> is_over_ = false;
  std::uint64_t jumps_ = 0;
  Clock::time_point looked_ = Clock::now();
  ChunksInMemory in_memory_;
};

}  // namespace tribo::sweep
