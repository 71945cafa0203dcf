// SPDX-License-Identifier: Apache-2.0
#include "sweep/run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <future>
#include <system_error>
#include <thread>
#include <utility>

#include "sweep/chunk_solver.hpp"
#include "sweep/needs.hpp"
#include "sweep/on_threads.hpp"
#include "sweep/output_file.hpp"
#include "sweep/part.hpp"
#include "sweep/parts_in_hand.hpp"
#include "sweep/plan_reader.hpp"
#include "sweep/result_file.hpp"
#include "tribo/batch.hpp"
#include "tribo/version.hpp"

namespace tribo::sweep {
namespace {

namespace fs = std::filesystem;

// Why a part does not belong to this sweep; empty if it does.
std::string difference(const PartHeader& mine, const PartHeader& theirs, bool any) {
  if (theirs.numbers != mine.numbers)
    return "was computed by tribocheck " + theirs.version + ", whose numbers are not those of " +
           mine.version;
  if (theirs.digest != mine.digest) return "is of another sweep: its files' texts are not these";
  if (theirs.arithmetic != mine.arithmetic && !any)
    return "was computed with " + theirs.arithmetic + ", this is " + mine.arithmetic +
           ": other last digits; --mixed-fma goes on all the same";
  return {};
}

constexpr Shard no_shard{0, 0};

// The note in the file of an output's lock: the sweep that the owner of the output computes. The
// file of an owner that was killed stays there.
struct OwnersNote {
  PartHeader header;  // without files
  Shard shard;        // or no_shard

  template <class To, class Note>
  static void fields(To& to, Note& of) {
    to(of.header, of.shard.part, of.shard.parts);
  }
};

// The owner's note; nullopt: there is no whole one, as the owner is about to write it, or to end.
std::optional<OwnersNote> noted_at(const std::string& output) {
  const Bytes bytes = OutputLock::noted(output);
  OwnersNote note;
  try {
    Receiver{bytes}(note);
    return note;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

bool is_of_shard(const Part& part, const Shard& shard) {
  const auto records = part.records();
  return std::all_of(records.begin(), records.end(),
                     [&](const Part::Record& record) { return shard.has(record.chunk); });
}

// `there`: files that are on the disk already, and need no more room.
void check_room(const SweepPlan& plan, int threads, const std::string& result,
                const std::vector<std::string>& there) {
  double bytes = 0;
  for (const std::string& path : there)
    if (fs::is_regular_file(path)) bytes += static_cast<double>(fs::file_size(path));
  if (const std::string lack = lack_of_room(plan, threads, result, bytes); !lack.empty())
    throw RunRefused("the sweep " + lack);
}

// Throws RunRefused where one of the files is not ours.
void remove_all(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) FilePlace(path).remove_ours(any_mark);
}

// The text of an error of reading a file. What says nothing about the file is thrown on.
std::string fault_of(const std::runtime_error& error) {
  if (dynamic_cast<const Stopped*>(&error) || dynamic_cast<const std::system_error*>(&error)) throw;
  return error.what();
}

// The parts that can be read. A damaged part is of no use to anybody, and is removed. Throws
// RunRefused where a file is not ours.
std::vector<Part> readable(const std::vector<std::string>& paths, const RunSettings& settings,
                           const std::function<bool()>& stopped) {
  std::vector<Part> parts;
  for (const std::string& path : paths) {
    static_cast<void>(FilePlace(path).open_ours(is_start_of_part));
    try {
      parts.emplace_back(path, stopped);
    } catch (const std::runtime_error& error) {
      const std::string fault = fault_of(error);
      FilePlace(path).remove_ours(is_start_of_part);
      settings.tell(fault + "; it is removed, and what it held is computed anew");
    }
  }
  return parts;
}

ChunkList chunks_of(const SweepPlan& plan, const std::optional<Shard>& shard) {
  ChunkList chunks;
  for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk)
    if (!shard || shard->has(chunk)) chunks.push_back(chunk);
  return chunks;
}

// --- Files that are there before the run.

struct Start {
  bool complete = false;    // the result is there
  std::vector<bool> there;  // of this run's parts; a part is there only with all its chunks
  // The file at the output that the result may replace.
  Replaceable replaceable = {};
};

class Starter {
 public:
  // parts: those of this run. threads: those of this rank.
  Starter(const SweepPlan& plan, const RunSettings& settings, const PartHeader& header,
          const std::vector<ChunkList>& parts, int threads)
      : plan_(plan), settings_(settings), header_(header), parts_(parts), threads_(threads) {}

  // left: the note of a process that was killed.
  Start start(const std::optional<OwnersNote>& left) {
    const std::string& path = settings_.result;
    std::vector<std::string> files = files_of_parts(path);
    const std::vector<std::string> found = parts_of(path), journals = journals_of(path);
    const std::optional<FileIdentity> there = FilePlace(path).identity();
    if (settings_.force) {
      files.insert(files.end(), journals.begin(), journals.end());
      check_room(plan_, threads_, path, files);
      remove_all(files);  // the result stays until the new one takes its place
      return {false, std::vector<bool>(parts_.size()), {true, there}};
    }
    if (fs::exists(path)) {
      if (!settings_.resume)
        throw RunRefused(path + " is there already; --resume keeps it if it is this sweep's, " +
                         "--force replaces it");
      const std::string why = why_not_it(settings_.stopped);
      if (why.empty()) {
        remove_all(files);
        return {true, {}, {}};
      }
      // Has a run with --force begun this sweep, and was it stopped?
      const bool is_begun =
          left && there && refusal(*left).empty() && left->header.replaces == there->text();
      if (!is_begun && !any_goes_on(found, "")) throw RunRefused(why + "; --force replaces it");
      if (!is_begun && (!there || !any_goes_on(found, there->text())))
        throw RunRefused(why + ", and was put there after the parts beside it were begun; " +
                         "move it away, and --resume goes on");
      settings_.tell(why + (found.empty()
                                ? "; it is replaced, as --force has asked, once this is done"
                                : "; the parts beside it are gone on with, and then it is "
                                  "replaced"));
    }
    if (!journals.empty())
      throw RunRefused(journals.front() +
                       " was left by an older tribocheck, and this one reads no journals; that one "
                       "goes on with it, --force throws it away");
    if (!found.empty() && !settings_.resume)
      throw RunRefused(found.front() +
                       " is there, of a sweep that was stopped; --resume goes on "
                       "with it, --force throws it away");
    Start start = from_parts(found);
    start.replaceable.only = there;
    return start;
  }

  // Why the file at the output is not what this run makes; empty if it is.
  std::string why_not_it(const std::function<bool()>& stopped = {}) const {
    return settings_.shard ? of_shard(settings_.result, stopped)
                           : of_result(settings_.result, stopped);
  }

  // Why this run cannot use a part; empty if it can.
  std::string refusal(const Part& part) const {
    std::string why = difference(header_, part.header(), settings_.mixed_fma);
    if (why.empty() && settings_.shard && !is_of_shard(part, *settings_.shard))
      why = "is of another shard; --force throws it away";
    return why;
  }

  // Why another process's sweep, by its note, is not this one; empty if it is.
  std::string refusal(const OwnersNote& note) const {
    std::string why = difference(header_, note.header, settings_.mixed_fma);
    if (why.empty() && note.shard != settings_.shard.value_or(no_shard)) why = "is another shard";
    return why;
  }

 private:
  std::string of_result(const std::string& path, const std::function<bool()>& stopped) const {
    try {
      const ResultIdentity identity = ResultFile(path, stopped).identity();
      const bool is_mine = identity.digest == plan_.digest;
      if (!is_mine && identity.version != plan_.version)
        return path + " was computed by tribocheck " + identity.version + ", this is " +
               plan_.version + ", and its numbers or its sweep are others";
      PartHeader theirs = header_;
      theirs.arithmetic = identity.arithmetic;
      if (!is_mine) theirs.digest.clear();
      const std::string why = difference(header_, theirs, settings_.mixed_fma);
      return why.empty() ? why : path + ' ' + why;
    } catch (const std::runtime_error& error) {
      return fault_of(error);
    }
  }

  std::string of_shard(const std::string& path, const std::function<bool()>& stopped) const {
    try {
      const Part part(path, stopped);
      std::string why = difference(header_, part.header(), settings_.mixed_fma);
      if (!why.empty()) return path + ' ' + why;
      if (!is_of_shard(part, *settings_.shard)) return path + " is another shard";
      std::vector<bool> there(plan_.chunks());
      note(part, there);
      const std::vector<bool> parts = parts_in(there);
      return std::find(parts.begin(), parts.end(), false) == parts.end()
                 ? ""
                 : path + " is another shard, or not the whole of this one";
    } catch (const std::runtime_error& error) {
      return fault_of(error);
    }
  }

  // Is any part of this run, with `replaces` as the file that it may replace? Empty: any file.
  bool any_goes_on(const std::vector<std::string>& paths, const std::string& replaces) const {
    return std::any_of(paths.begin(), paths.end(), [&](const std::string& path) {
      try {
        const Part part(path, settings_.stopped);
        return refusal(part).empty() && (replaces.empty() || part.header().replaces == replaces);
      } catch (const std::runtime_error& error) {
        static_cast<void>(fault_of(error));
        return false;
      }
    });
  }

  Start from_parts(const std::vector<std::string>& paths) {
    std::vector<bool> there(plan_.chunks());
    for (const Part& part : readable(paths, settings_, settings_.stopped)) {
      if (const std::string why = refusal(part); !why.empty())
        throw RunRefused(part.path() + ' ' + why);
      note(part, there);
    }
    check_room(plan_, threads_, settings_.result, paths);
    const auto found = std::count(there.begin(), there.end(), true);
    std::size_t all = 0;
    for (const ChunkList& part : parts_) all += part.size();
    if (settings_.resume && (found > 0 || !settings_.join))
      settings_.tell(found == 0 ? "nothing to go on with; starting anew"
                                : "going on: " + std::to_string(found) + " of " +
                                      std::to_string(all) + " chunks are there");
    return {false, parts_in(there), {}};
  }

  static void note(const Part& part, std::vector<bool>& there) {
    for (const Part::Record& record : part.records())
      if (record.chunk < there.size()) there[record.chunk] = true;
  }

  // The parts of this run whose chunks are all there.
  std::vector<bool> parts_in(const std::vector<bool>& there) const {
    std::vector<bool> whole;
    for (const ChunkList& part : parts_)
      whole.push_back(
          std::all_of(part.begin(), part.end(), [&](std::uint64_t chunk) { return there[chunk]; }));
    return whole;
  }

  const SweepPlan& plan_;
  const RunSettings& settings_;
  const PartHeader& header_;
  const std::vector<ChunkList>& parts_;
  int threads_;
};

// --- The end: from parts to one file.

std::function<void(std::uint64_t)> told_of_writing(const RunSettings& settings,
                                                   std::uint64_t chunks) {
  return [&settings, chunks](std::uint64_t written) {
    if (settings.stopped && settings.stopped()) throw Stopped();
    if (settings.progress) settings.progress({RunProgress::Phase::writing, chunks, written});
  };
}

// Writes a shard: one part with all chunks of the shard.
void write_shard(const std::string& path, PartHeader header, const ChunkList& chunks,
                 const PartSet& parts, const std::function<void(std::uint64_t)>& told,
                 const Replaceable& replaceable) {
  PartFile file(path, is_start_of_part);
  // A shard without chunks is of the arithmetic of the process that writes it.
  if (parts.count() > 0) header.arithmetic = parts.arithmetics();
  header.replaces.clear();
  PartContent content{chunks, 0, {}};
  for (const std::uint64_t chunk : chunks) content.bytes += parts.size_of(chunk);
  std::uint64_t written = 0;
  content.read = [&](std::uint64_t chunk) {
    told(++written);
    return parts.read(chunk);
  };
  write_part(path, file, header, content, replaceable);
}

// Starts the thread that computes, while the calling thread shows the progress.
std::future<void> started_thread(std::function<void()> work) {
  try {
    return std::async(std::launch::async, std::move(work));
  } catch (const std::system_error& error) {
    throw std::runtime_error("the system starts no thread (" + error.code().message() +
                             "); allowed: a higher limit of processes, as by ulimit -u");
  }
}

constexpr std::chrono::milliseconds moment{50};

class Run {
  using Clock = std::chrono::steady_clock;

 public:
  Run(const SweepPlan& plan, RunSettings settings, const Ranks& ranks)
      : plan_(plan),
        settings_(std::move(settings)),
        ranks_(ranks),
        header_(header_of(plan)),
        threads_(settings_.threads > 0 || ranks.count() == 1 ? settings_.threads : 1),
        chunks_(chunks_of(plan, settings_.shard)),
        parts_(cut_in_parts(plan, chunks_)) {
    settings_.resume = settings_.resume || settings_.join;
  }

  RunEnd run() {
    agree_on_plan();
    for (;;) {
      Start start = start_on_first();
      std::exception_ptr failure;
      if (!start.complete) failure = failure_of([&] { compute_missing(start.there); });
      if (ranks_.count() == 1 && failure != nullptr) std::rethrow_exception(failure);
      ranks_.everywhere(true);  // waits: the others compute what a failed rank has left
      if (ranks_.rank() == 0 && !lock_) {
        if (is_stopped()) return stopped_helping();
        std::this_thread::sleep_for(moment);
        continue;  // until the owner has put its result there, or has given up
      }
      RunEnd end = RunEnd::done;
      together([&] {
        if (ranks_.rank() == 0 && !start.complete) end = finish(start, failure == nullptr ? 3 : 1);
      });
      if (end == RunEnd::done && ranks_.rank() == 0 && settings_.finished)
        settings_.finished(std::move(written_));
      if (failure != nullptr) std::rethrow_exception(failure);
      return end;
    }
  }

 private:
  // The exception of a step on this rank, or null. Where there are several ranks, its text is told
  // at once.
  template <class Step>
  std::exception_ptr failure_of(Step&& step) const {
    try {
      step();
    } catch (const Stopped&) {
      return std::current_exception();
    } catch (const std::exception& error) {
      if (ranks_.count() > 1 && settings_.failed) settings_.failed(error.what());
      return std::current_exception();
    }
    return nullptr;
  }

  // Runs a step that may throw on this rank, and lets all ranks know whether it did.
  template <class Step>
  void together(Step&& step) const {
    const std::exception_ptr failure = failure_of(step);
    const bool all_good = ranks_.everywhere(failure == nullptr);
    if (failure != nullptr) std::rethrow_exception(failure);
    if (!all_good) throw OtherRankFailed();
  }

  void agree_on_plan() {
    const std::string mine = header_.digest + ' ' + header_.arithmetic;
    const std::string first = ranks_.from_first(mine);
    together([&] {
      if (settings_.join && ranks_.count() > 1)
        throw RunRefused("--join is for processes without mpirun, whose ranks help each other");
      if (first == mine) return;
      throw RunRefused("rank " + std::to_string(ranks_.rank()) +
                       " reads other files than rank 0, or computes with another arithmetic (" +
                       header_.arithmetic + "); --without-fma makes them the same");
    });
  }

  Starter starter() const { return {plan_, settings_, header_, parts_, threads_}; }

  Start start_on_first() {
    Start start;
    together([&] {
      if (ranks_.rank() != 0) return;
      settings_.result = output_behind_links(settings_.result);
      const bool is_first = !std::exchange(has_begun_, true);
      if (is_first) before_ = FilePlace(settings_.result).identity();
      if (!settings_.join) lock_.emplace(settings_.result);
      if (settings_.join) lock_ = OutputLock::take(settings_.result, ".lock");
      if (!lock_) {
        // The owner has put the result there already, and only shows it.
        if (is_first && before_ && starter().why_not_it().empty()) before_.reset();
        return start_helping(start);
      }
      if (settings_.join && !lock_->is_exclusive()) check_owner();
      if (lock_->is_exclusive()) remove_begun(settings_.result);
      const std::optional<OwnersNote> left = noted_at(settings_.result);
      try {
        start = starter().start(left);
      } catch (const std::exception&) {
        if (left && !left->header.replaces.empty()) lock_->leave();
        throw;
      }
      if (start.complete) return;
      check_place(settings_.result, settings_.shard ? is_start_of_part : is_start_of_result);
      if (start.replaceable.only) header_.replaces = start.replaceable.only->text();
      OwnersNote note{header_, settings_.shard.value_or(no_shard)};
      note.header.files.clear();
      Bytes bytes;
      Sender{bytes}(note);
      lock_->note(bytes);
    });
    settings_.result = ranks_.from_first(settings_.result);
    header_.replaces = ranks_.from_first(header_.replaces);
    start.complete = ranks_.from_first(start.complete ? "complete" : "") == "complete";
    std::string there;
    for (const bool is_there : start.there) there += is_there ? '1' : '0';
    start.there.clear();
    for (const char mark : ranks_.from_first(there)) start.there.push_back(mark == '1');
    return start;
  }

  // Why the process that owns the output computes something else than this one; empty if it
  // computes the same, or has not said yet.
  std::string why_not_of_owner() const {
    const std::optional<OwnersNote> note = noted_at(settings_.result);
    return note ? starter().refusal(*note) : "";
  }

  void check_owner() {
    std::string why = why_not_of_owner();
    if (why.empty()) return;
    if (lock_) {  // there are no locks, and nobody knows whether the other process still runs
      lock_->leave();
      why += "; if it was killed, remove " + settings_.result + ".lock";
    }
    throw RunRefused(settings_.result +
                     " is being written by another process, and what it computes " + why);
  }

  void start_helping(Start& start) {
    check_owner();
    // The owner computes the one part of a short sweep. Help begins once the owner's note is there.
    start.there.assign(parts_.size(), parts_.size() == 1 || !noted_at(settings_.result));
  }

  RunEnd stopped_helping() {
    settings_.tell("stopped: parts that are computed are kept beside " + settings_.result +
                   ", and other processes go on");
    return RunEnd::stopped;
  }

  // The sweep is over for a helper when the owner has put its result there.
  bool is_over() const {
    return settings_.join && FilePlace(settings_.result).identity() != before_;
  }

  // A sweep of one part, of which nothing is there, writes its result at once.
  bool is_at_once(const std::vector<bool>& there) const {
    return parts_.size() == 1 && !there.front() &&
           !FilePlace(path_of_part(settings_.result, parts_.front())).status();
  }

  void compute_missing(std::vector<bool> there) {
    PartsInHand::Settings hand{
        settings_.result, header_, 0, is_at_once(there),
        [this] { return is_over() || (settings_.join && !lock_ && !why_not_of_owner().empty()); }};
    if (hand.in_memory && ranks_.rank() > 0) return;
    if (settings_.join) hand.begin = place_of_process(parts_.size());
    if (ranks_.count() > 1)
      hand.begin = parts_.size() * static_cast<std::size_t>(ranks_.rank()) /
                   static_cast<std::size_t>(ranks_.count());
    const FilePlace place(settings_.result);
    PartsInHand parts(std::move(hand), parts_, there);
    std::atomic<bool> is_lost = false;
    int started = 0;
    const auto ends = [&] { return is_lost || is_stopped(); };
    const std::uint64_t first_there = parts.chunks_there();
    std::future<void> worker = started_thread([&] {
      while (!ends()) {
        if (!parts.has_work()) {
          if (parts.is_done()) return;
          std::this_thread::sleep_for(moment);  // other processes compute the parts that are left
          continue;
        }
        const int now = compute(
            plan_, threads_, [&] { return parts.next(); },
            [&](const Chunk& chunk) { parts.keep(chunk.number, chunk.bytes()); }, ends);
        started = std::max(started, now);
      }
    });
    try {
      while (worker.wait_for(moment) != std::future_status::ready) {
        // Where the output's folder is gone, nothing can be written, and nobody waits for it.
        if (!place.is_folder_at_its_path() || (lock_ && !lock_->holds())) is_lost = true;
        if (ranks_.rank() == 0 && settings_.progress)
          settings_.progress({RunProgress::Phase::computing, chunks_.size() - first_there,
                              parts.chunks_there() - first_there});
      }
      worker.get();
    } catch (...) {
      is_lost = true;
      if (worker.valid()) worker.wait();
      // Another process has ended the sweep, and has removed what this one was about to write.
      if (is_over() && starter().why_not_it().empty()) return;
      if (lock_) check_lock();  // says more than the error of the failed write
      throw;
    }
    if (!lock_ && is_lost)
      throw std::runtime_error("the folder of " + settings_.result + " is gone");
    if (const int asked = thread_count(threads_); started > 0 && started < asked)
      settings_.tell("the system allows " + std::to_string(started) + " of the " +
                     std::to_string(asked) + " threads, and these have computed it");
    in_memory_ = parts.take_memory();
  }

  bool is_all_in_memory() const {
    return !in_memory_.empty() && in_memory_.size() == chunks_.size();
  }
  bool is_stopped() const { return settings_.stopped && settings_.stopped(); }

  // Where the lock or the folder is gone, no result is made, and nobody is told to go on there.
  void check_lock() const { lock_->check(); }

  // The computed chunks, in the parts that are whole.
  PartSet gathered() {
    std::vector<Part> parts;
    if (is_all_in_memory()) parts.emplace_back(header_, std::move(in_memory_));
    // After a stop, the kept parts are looked for half a second longer.
    const auto patient = [this, end = Clock::now() + std::chrono::milliseconds(500)] {
      return is_stopped() && Clock::now() > end;
    };
    for (Part& part : readable(parts_of(settings_.result), settings_, patient)) {
      if (const std::string why = difference(header_, part.header(), settings_.mixed_fma);
          !why.empty())
        throw std::runtime_error(part.path() + ' ' + why +
                                 "; another process has put it there, and nothing is written");
      parts.push_back(std::move(part));
    }
    return {std::move(parts), plan_.chunks(), settings_.mixed_fma};
  }

  RunEnd finish(const Start& start, int most_rounds) {
    for (int round = 1;; ++round) {
      check_lock();
      if (is_over() && starter().why_not_it().empty()) return cleaned();
      const bool is_at_once = is_all_in_memory();
      const PartSet parts = gathered();
      const auto missing = std::count_if(chunks_.begin(), chunks_.end(),
                                         [&](std::uint64_t chunk) { return !parts.has(chunk); });
      const std::string kept = std::to_string(is_at_once ? 0 : parts.count()) +
                               " chunks are kept beside " + settings_.result;
      if (missing > 0 && (is_stopped() || round == most_rounds)) {
        if (is_at_once || parts.count() == 0) leave_note();
        settings_.tell("stopped: " + kept + ", and " + std::to_string(missing) +
                       " are still to be computed; --resume goes on");
        return RunEnd::stopped;
      }
      if (missing == 0) return write_and_clean(parts, start.replaceable, is_at_once ? "" : kept);
      compute_missing(std::vector<bool>(parts_.size()));  // what was removed or damaged meanwhile
    }
  }

  // kept: a text on the parts on the disk; empty: there are none.
  RunEnd write_and_clean(const PartSet& parts, const Replaceable& replaceable,
                         const std::string& kept) {
    check_lock();
    try {
      write(parts, replaceable);
    } catch (const Stopped&) {
      if (kept.empty()) leave_note();
      settings_.tell(kept.empty() ? "stopped: nothing is kept of so short a sweep; --resume goes on"
                                  : "stopped: all " + kept + "; --resume writes the result");
      return RunEnd::stopped;
    } catch (const std::exception& error) {
      // On a file system without locks another owner may have been faster.
      if (settings_.join && starter().why_not_it().empty()) return RunEnd::done;
      if (kept.empty()) throw;
      throw std::runtime_error(std::string(error.what()) + "; all " + kept +
                               ", and --resume writes the result once this is mended");
    }
    return cleaned();
  }

  // Keeps the note of the file that --force lets this run replace: there may be no part to name it.
  void leave_note() {
    if (!header_.replaces.empty()) lock_->leave();
  }

  RunEnd cleaned() {
    for (const std::string& path : files_of_parts(settings_.result)) remove_or_tell(path);
    return RunEnd::done;
  }

  void write(const PartSet& parts, const Replaceable& replaceable) {
    const auto told = told_of_writing(settings_, parts.count());
    if (settings_.shard)
      write_shard(settings_.result, header_, chunks_, parts, told, replaceable);
    else
      written_ = write_result(settings_.result, plan_, parts, told, replaceable, settings_.join);
  }

  void remove_or_tell(const std::string& path) const {
    try {
      FilePlace(path).remove_ours(any_mark);
    } catch (const std::exception& error) {
      settings_.tell(std::string(error.what()) + "; the result is written, and needs it no more");
    }
  }

  const SweepPlan& plan_;
  RunSettings settings_;
  const Ranks& ranks_;
  PartHeader header_;
  int threads_;
  ChunkList chunks_;              // of this run
  std::vector<ChunkList> parts_;  // into which they are cut
  ChunksInMemory in_memory_;
  std::optional<FileIdentity> before_;  // the file at the output when this process began
  bool has_begun_ = false;
  std::optional<OutputLock> lock_;     // of rank 0, if it does not help another process
  std::optional<Descriptor> written_;  // the result, where this process has written it
};

SweepPlan plan_of(const PartHeader& header) {
  std::vector<SceneSweep> scenes;
  for (const auto& [name, text] : header.files) {
    SweepReading reading = parse_sweep(text, name);
    if (!reading.sweep) throw RunRefused(reading.errors.front().line());
    scenes.push_back(std::move(*reading.sweep));
  }
  return make_plan(std::move(scenes));
}

void check_is_no_input(const std::string& output, const std::vector<std::string>& shards) {
  const std::vector<std::string> parts = parts_of(output);
  std::error_code none;
  for (const std::string& shard : shards)
    for (const std::string& part : parts)
      if (fs::equivalent(shard, part, none))
        throw RunRefused(shard + " is a part of " + output +
                         " itself; allowed: another file for -o");
}

RunEnd merge_under_lock(const std::vector<std::string>& shards, const RunSettings& settings,
                        const std::vector<std::string>& files, const Replaceable& replaceable) {
  std::optional<PartSet> chunks;
  std::optional<SweepPlan> plan;
  try {
    std::vector<Part> parts;
    for (const std::string& shard : shards) parts.emplace_back(shard, settings.stopped);
    const PartHeader& header = parts.front().header();
    if (header.numbers != numbers_version)
      throw RunRefused(shards.front() + " was computed by tribocheck " + header.version +
                       ", whose numbers are not those of " + std::string(version));
    plan = plan_of(header);
    if (plan->digest != header.digest)
      throw RunRefused(shards.front() + " is of a sweep that this tribocheck lays out otherwise");
    chunks.emplace(std::move(parts), plan->chunks(), settings.mixed_fma);
  } catch (const std::runtime_error& error) {
    throw RunRefused(fault_of(error));
  }
  if (chunks->count() < chunks->chunks())
    throw RunRefused(std::to_string(chunks->chunks() - chunks->count()) + " of " +
                     std::to_string(chunks->chunks()) +
                     " chunks are in none of these; allowed: all shards of one sweep");
  check_room(*plan, 1, settings.result, shards);
  Descriptor written = write_result(settings.result, *plan, *chunks,
                                    told_of_writing(settings, chunks->chunks()), replaceable);
  remove_all(files);
  if (settings.finished) settings.finished(std::move(written));
  return RunEnd::done;
}

}  // namespace

RunEnd run(const SweepPlan& plan, RunSettings settings, const Ranks& ranks) {
  if (!settings.tell) settings.tell = [](std::string_view) {};
  Run run(plan, settings, ranks);
  try {
    return run.run();
  } catch (const Stopped&) {
    settings.tell("stopped: what is computed is kept beside " + settings.result +
                  ", and --resume goes on");
    return RunEnd::stopped;
  }
}

RunEnd merge(const std::vector<std::string>& shards, RunSettings settings) {
  settings.result = output_behind_links(settings.result);
  const OutputLock lock(settings.result);
  check_is_no_input(settings.result, shards);
  check_place(settings.result, is_start_of_result);
  const Replaceable replaceable{settings.force, FilePlace(settings.result).identity()};
  if (replaceable.only && !settings.force)
    throw RunRefused(settings.result + " is there already; --force replaces it");
  std::vector<std::string> parts = parts_of(settings.result),
                           files = files_of_parts(settings.result);
  for (const std::string& journal : journals_of(settings.result))
    for (std::vector<std::string>* const list : {&parts, &files}) list->push_back(journal);
  if (!parts.empty() && !settings.force)
    throw RunRefused(parts.front() +
                     " is there, of a sweep that was stopped; --force throws it away");
  try {
    return merge_under_lock(shards, settings, files, replaceable);
  } catch (const Stopped&) {
    settings.tell("stopped: nothing is written, and the shards are as they were");
    return RunEnd::stopped;
  }
}

}  // namespace tribo::sweep
