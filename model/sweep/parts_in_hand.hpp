// SPDX-License-Identifier: Apache-2.0
// How the processes of a sweep share its work: each computes parts whose files are missing. The
// file OUTPUT.part-F-L holds the chunks from F to L, and OUTPUT.part-F-L-S each S-th of them. A
// process claims a part by a lock (this name and .lock), writes it at a name that no other process
// uses, and renames it when it is whole. On a file system without locks two processes may compute
// the same part, which costs time but changes no number.
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

// Cuts chunks into parts of about two seconds of one processor or two million numbers, or of more
// where there would be over 4000 parts. The borders depend on the plan and the chunks alone; times
// are estimated from the number of points and their kind. For tests, TRIBOCHECK_PART_CHUNKS in the
// environment is the number of chunks of a part.
std::vector<ChunkList> cut_in_parts(const SweepPlan& plan, const ChunkList& chunks);

// About the most chunks of a part when cut_in_parts() cuts all chunks of the plan. It is found
// without cutting, because a sweep that has no room may have 10⁸ chunks.
double most_chunks_of_part(const SweepPlan& plan);

// The path of a part. Parts with different chunks, in all runs and shards, have different paths.
std::string path_of_part(const std::string& output, const ChunkList& chunks);
// The parts of an output that are there. The second function gives also the files of their locks,
// and the files that a killed process has not renamed.
std::vector<std::string> parts_of(const std::string& output);
std::vector<std::string> files_of_parts(const std::string& output);
// Removes files of parts and of the result that killed processes have not renamed, but not files of
// parts that another process has claimed. Only the owner of the output's lock may call it.
void remove_begun(const std::string& output);
// The journals of an output: files that older versions of tribocheck wrote in place of parts.
std::vector<std::string> journals_of(const std::string& output);

// The part, of `parts` parts, with which this process begins, from its host, its number and `turn`.
std::size_t place_of_process(std::size_t parts, std::uint64_t turn = 0);

class PartsInHand {
 public:
  struct Settings {
    std::string output;
    PartHeader header;
    std::size_t begin = 0;       // the part with which this process begins
    bool in_memory = false;      // all parts are of this process, and none is written
    std::function<bool()> over;  // asked before a part is begun: is the sweep over?
  };
  // `there`: the parts that need not be computed. Throws std::runtime_error, with a text that names
  // the file, where the others could not be written.
  PartsInHand(Settings settings, std::vector<ChunkList> parts, const std::vector<bool>& there);

  // Has this process chunks in hand? If not, it claims a part. False where all parts are there or
  // claimed, or where the sweep is over.
  bool has_work();
  // Is every part there, or is the sweep over?
  bool is_done();
  // The next chunk of this process. Any thread may ask.
  std::optional<std::uint64_t> next();
  // Keeps a chunk that next() has given; the last one of its part writes the part. Any thread may
  // call. Throws std::runtime_error, with a text that names the file, where it cannot be written.
  void keep(std::uint64_t chunk, Bytes bytes);
  // Counts the chunks that are there or kept. It looks for those of others once a second.
  std::uint64_t chunks_there();
  ChunksInMemory take_memory() { return std::move(in_memory_); }

 private:
  using Clock = std::chrono::steady_clock;
  struct InHand {
    std::size_t part;
    std::optional<OutputLock> claim = {};
    std::size_t next = 0;  // the next of its chunks to hand out
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
  std::condition_variable claimed_;  // notified when is_claiming_ ends
  bool is_claiming_ = false;         // one thread claims at a time, for all
  std::list<InHand> in_hand_;        // the last one has chunks left to hand out, if any has
  std::atomic<bool> is_over_ = false;
  std::uint64_t jumps_ = 0;
  Clock::time_point looked_ = Clock::now();
  ChunksInMemory in_memory_;
};

}  // namespace tribo::sweep
