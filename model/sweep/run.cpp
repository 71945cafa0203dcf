// SPDX-License-Identifier: Apache-2.0
#include "sweep/run.hpp"

#include <fcntl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "sweep/compute.hpp"
#include "sweep/needs.hpp"
#include "sweep/on_threads.hpp"
#include "sweep/plan_reader.hpp"
#include "sweep/result_file.hpp"
#include "tribo/batch.hpp"
#include "tribo/version.hpp"

namespace tribo::sweep {
namespace {

namespace fs = std::filesystem;

// The path of a journal. Its number is the rank, plus a multiple of the number of ranks where the
// journals before it are of another arithmetic.
std::string journal_of(const std::string& result, int number) {
  return result + ".journal-" + std::to_string(number);
}

// The journals that are there for a result.
std::vector<std::string> journals_of(const std::string& result) {
  const fs::path path(result);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::string start = path.filename().string() + ".journal-";
  std::vector<std::string> found;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    const bool ends_in_number = name.size() > start.size() &&
                                name.find_first_not_of("0123456789", start.size()) == name.npos;
    if (name.starts_with(start) && ends_in_number)
      found.push_back(result + name.substr(path.filename().string().size()));
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Why a journal or result of another sweep is not this one's; empty if it is.
std::string difference(const JournalHeader& mine, const std::string& version,
                       const std::string& digest, const std::string& arithmetic, bool any) {
  if (version != mine.version)
    return "was computed by tribocheck " + version + ", this is " + mine.version;
  if (digest != mine.digest) return "is of another sweep: its files' texts are not these";
  if (arithmetic != mine.arithmetic && !any)
    return "was computed with " + arithmetic + ", this is " + mine.arithmetic +
           ": other last digits; --mixed-fma goes on all the same";
  return {};
}
std::string difference(const JournalHeader& mine, const JournalReader& reader, bool any) {
  const JournalHeader& theirs = reader.header();
  return difference(mine, theirs.version, theirs.digest, theirs.arithmetic, any);
}

bool is_of_shard(const JournalReader& reader, const Shard& shard) {
  const auto records = reader.records();
  return std::all_of(records.begin(), records.end(),
                     [&](const JournalReader::Record& record) { return shard.has(record.chunk); });
}

// journals: what is on the disk already needs no more room.
void check_room(const SweepPlan& plan, int threads, const std::string& result,
                const std::vector<std::string>& journals) {
  double there = 0;
  for (const std::string& path : journals)
    if (fs::is_regular_file(path)) there += static_cast<double>(fs::file_size(path));
  if (const std::string lack = lack_of_room(plan, threads, result, there); !lack.empty())
    throw RunRefused("the sweep " + lack);
}

// Throws RunRefused where one of them is not ours.
void remove_all(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) FilePlace(path).remove_ours(any_mark);
}

// The journals that can be read. A file without a readable head is of no use to anybody. Beside
// journals that can be read it is removed; but alone it may be something else, and the run is
// refused (an empty file is removed).
std::vector<JournalReader> readable(const std::vector<std::string>& paths,
                                    const RunSettings& settings) {
  std::vector<JournalReader> readers;
  std::vector<std::pair<std::string, std::string>> unreadable;  // paths, and why
  for (const std::string& path : paths) {
    try {
      readers.emplace_back(path, settings.stopped);
    } catch (const Stopped&) {
      throw;
    } catch (const std::runtime_error& error) {
      const bool is_empty = fs::is_regular_file(path) && fs::file_size(path) == 0;
      unreadable.emplace_back(path, is_empty ? path + " is empty" : error.what());
      if (is_empty) FilePlace(path).remove_ours(no_mark);
    }
  }
  for (const auto& [path, why] : unreadable) {
    if (readers.empty() && fs::exists(path))
      throw RunRefused(why + "; --force throws it away, or move it to another place");
    FilePlace(path).remove_ours(any_mark);
    settings.tell(why + "; it is removed, and what it held is computed anew");
  }
  return readers;
}

// --- Files that are there before the run.

struct Start {
  bool complete = false;               // the result is there
  std::vector<std::uint64_t> pending;  // chunks
  // The file that may be at the output when the result takes its place.
  Replaceable replaceable = {};
};

class Starter {
 public:
  // threads: of this rank.
  Starter(const SweepPlan& plan, const RunSettings& settings, const JournalHeader& header,
          int threads)
      : plan_(plan), settings_(settings), header_(header), threads_(threads) {}

  Start start() {
    const std::string& path = settings_.result;
    const std::vector<std::string> journals = journals_of(path);
    const std::optional<FileIdentity> there = FilePlace(path).identity();
    if (settings_.force) {
      check_room(plan_, threads_, path, journals);
      remove_all(journals);  // the result stays until the new one takes its place
      return {false, wanted({}), {true, there}};
    }
    if (fs::exists(path)) {
      if (!settings_.resume)
        throw RunRefused(path + " is there already; --resume keeps it if it is this sweep's, " +
                         "--force replaces it");
      const std::string why = settings_.shard ? of_shard(path) : of_result(path);
      if (why.empty()) {
        remove_all(journals);
        return {true, {}, {}};
      }
      if (!any_goes_on(journals, "")) throw RunRefused(why + "; --force replaces it");
      if (!there || !any_goes_on(journals, there->text()))
        throw RunRefused(why + ", and was put there after the journals beside it were begun; " +
                         "move it away, and --resume goes on");
      // --force has begun this, and was stopped.
      settings_.tell(why + "; the journals beside it are gone on with, and then it is replaced");
    }
    if (!journals.empty() && !settings_.resume)
      throw RunRefused(journals.front() +
                       " is there, of a sweep that was stopped; --resume goes on "
                       "with it, --force throws it away");
    Start start = from_journals(journals);
    start.replaceable.only = there;
    return start;
  }

 private:
  std::string of_result(const std::string& path) const {
    try {
      const ResultIdentity identity = ResultFile(path).identity();
      const std::string why = difference(header_, identity.version, identity.digest,
                                         identity.arithmetic, settings_.mixed_fma);
      return why.empty() ? why : path + ' ' + why;
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  std::string of_shard(const std::string& path) const {
    try {
      const JournalReader reader(path);
      std::string why = difference(header_, reader, settings_.mixed_fma);
      if (!why.empty()) return path + ' ' + why;
      if (!is_of_shard(reader, *settings_.shard)) return path + " is another shard";
      std::vector<bool> there(plan_.chunks());
      note(reader, there);
      return wanted(there).empty() ? "" : path + " is another shard, or not the whole of this one";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  // Is there a journal of this very run? replaces: and may it replace this file; empty: any.
  bool any_goes_on(const std::vector<std::string>& journals, const std::string& replaces) const {
    return std::any_of(journals.begin(), journals.end(), [&](const std::string& path) {
      try {
        const JournalReader reader(path, settings_.stopped);
        return refusal(reader).empty() &&
               (replaces.empty() || reader.header().replaces == replaces);
      } catch (const Stopped&) {
        throw;
      } catch (const std::runtime_error&) {
        return false;
      }
    });
  }

  // Why a journal is not gone on with; empty if it is.
  std::string refusal(const JournalReader& reader) const {
    std::string why = difference(header_, reader, settings_.mixed_fma);
    if (why.empty() && settings_.shard && !is_of_shard(reader, *settings_.shard))
      why = "is of another shard; --force throws it away";
    return why;
  }

  Start from_journals(const std::vector<std::string>& journals) {
    std::vector<bool> there(plan_.chunks());
    for (const JournalReader& reader : readable(journals, settings_)) {
      if (const std::string why = refusal(reader); !why.empty())
        throw RunRefused(reader.path() + ' ' + why);
      if (reader.lost_bytes() > 0)
        settings_.tell(reader.path() + ": " + std::to_string(reader.lost_bytes()) +
                       " bytes are no whole record, and are computed anew");
      note(reader, there);
    }
    check_room(plan_, threads_, settings_.result, journals);
    const auto found = std::count(there.begin(), there.end(), true);
    Start start{false, wanted(there), {}};
    if (settings_.resume)
      settings_.tell(found == 0 ? "nothing to go on with; starting anew"
                                : "going on: " + std::to_string(found) + " of " +
                                      std::to_string(static_cast<std::uint64_t>(found) +
                                                     start.pending.size()) +
                                      " chunks are there");
    return start;
  }

  static void note(const JournalReader& reader, std::vector<bool>& there) {
    for (const JournalReader::Record& record : reader.records())
      if (record.chunk < there.size()) there[record.chunk] = true;
  }

  // Without those that are there.
  std::vector<std::uint64_t> wanted(const std::vector<bool>& there) const {
    std::vector<std::uint64_t> pending;
    for (std::uint64_t chunk = 0; chunk < plan_.chunks(); ++chunk) {
      if (settings_.shard && !settings_.shard->has(chunk)) continue;
      if (there.empty() || !there[chunk]) pending.push_back(chunk);
    }
    return pending;
  }

  const SweepPlan& plan_;
  const RunSettings& settings_;
  const JournalHeader& header_;
  int threads_;
};

// --- The end: from journals to one file.

// A shard is a journal with its chunks in order.
void write_shard(const std::string& path, const Shard& shard, const JournalSet& chunks,
                 const std::function<void(std::uint64_t)>& told, const Replaceable& replaceable) {
  try {
    PartFile part(path, is_start_of_journal);
    JournalHeader header = chunks.header();
    // A shard without chunks is of the arithmetic of the process that writes it.
    if (chunks.count() > 0) header.arithmetic = chunks.arithmetics();
    header.replaces.clear();
    Journal journal =
        Journal::begin(Descriptor(::fcntl(part.file(), F_DUPFD_CLOEXEC, 0)), part.path(), header);
    std::uint64_t written = 0;
    for (std::uint64_t chunk = 0; chunk < chunks.chunks(); ++chunk) {
      if (!shard.has(chunk)) continue;
      journal.append(chunk, chunks.read(chunk));
      told(++written);
    }
    part.keep(replaceable);
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot write " + path + ": " + error.what());
  }
}

class Run {
  using Clock = std::chrono::steady_clock;

 public:
  Run(const SweepPlan& plan, RunSettings settings, const Ranks& ranks)
      : plan_(plan),
        settings_(std::move(settings)),
        ranks_(ranks),
        header_(header_of(plan)),
        threads_(settings_.threads > 0 || ranks.count() == 1 ? settings_.threads : 1) {}

  RunEnd run() {
    agree_on_plan();
    Start start = start_on_first();
    if (!start.complete) compute_all(std::move(start.pending));
    if (ranks_.rank() > 0) return RunEnd::done;
    if (!start.complete && finish(start.replaceable) == RunEnd::stopped) return RunEnd::stopped;
    if (settings_.finished) settings_.finished(std::move(written_));
    return RunEnd::done;
  }

 private:
  // Runs what may throw on this rank, and has all ranks know of it.
  template <class Step>
  void together(Step&& step) {
    std::exception_ptr failure;
    try {
      step();
    } catch (...) {
      failure = std::current_exception();
    }
    const bool all_good = ranks_.everywhere(failure == nullptr);
    if (failure != nullptr) std::rethrow_exception(failure);
    if (!all_good) throw OtherRankFailed();
  }

  void agree_on_plan() {
    const std::string mine = header_.digest + ' ' + header_.arithmetic;
    const std::string first = ranks_.from_first(mine);
    together([&] {
      if (first == mine) return;
      throw RunRefused("rank " + std::to_string(ranks_.rank()) +
                       " reads other files than rank 0, or computes with another arithmetic (" +
                       header_.arithmetic + "); --without-fma makes them the same");
    });
  }

  Start start_on_first() {
    Start start;
    together([&] {
      if (ranks_.rank() != 0) return;
      settings_.result = output_behind_links(settings_.result);
      lock_.emplace(settings_.result);
      start = Starter(plan_, settings_, header_, threads_).start();
      if (!start.complete) {
        if (settings_.shard)
          static_cast<void>(FilePlace(settings_.result, ".part").open_ours(is_start_of_journal));
        else
          check_place_of_result(settings_.result);
      }
      if (start.replaceable.only) header_.replaces = start.replaceable.only->text();
    });
    settings_.result = ranks_.from_first(settings_.result);
    start.complete = ranks_.from_first(start.complete ? "complete" : "") == "complete";
    return start;
  }

  void compute_all(std::vector<std::uint64_t> pending) {
    std::optional<Journal> journal;
    together([&] { journal.emplace(open_journal()); });
    const std::uint64_t total = pending.size();
    ChunkQueue queue(std::move(pending));
    std::atomic<std::uint64_t> computed = 0;
    std::atomic<bool> is_lost = false;
    int started = 0;
    together([&] {
      const bool good = ranks_.share(
          queue,
          [&](const NextChunk& next) {
            started = compute(
                plan_, threads_, next,
                [&](const Chunk& chunk) {
                  journal->append(chunk.number, chunk.bytes());
                  ++computed;
                },
                [&] { return is_lost || is_stopped(); });
          },
          [&](std::uint64_t elsewhere) {
            if (ranks_.rank() == 0 && settings_.progress)
              settings_.progress({RunProgress::Phase::computing, total, computed + elsewhere});
          },
          [&] {
            // Where the output's folder is gone, nobody waits for what cannot be written.
            is_lost = ranks_.rank() == 0 && !(lock_->holds() && journal->is_there());
            return is_lost || is_stopped();
          });
      journal->sync();
      if (!good) throw OtherRankFailed();
    });
    if (const int asked = thread_count(threads_); started < asked)
      settings_.tell("the system allows " + std::to_string(started) + " of the " +
                     std::to_string(asked) + " threads, and these have computed it");
  }

  bool is_stopped() const { return settings_.stopped && settings_.stopped(); }

  // A journal that was begun with another arithmetic stays as it is: a journal has one arithmetic.
  Journal open_journal() const {
    for (int number = ranks_.rank();; number += ranks_.count()) {
      const std::string path = journal_of(settings_.result, number);
      if (!fs::exists(path)) return Journal::create(path, header_);
      if (JournalReader(path, settings_.stopped).header().arithmetic == header_.arithmetic)
        return Journal::resume(path);
    }
  }

  // Where the lock or the folder is gone, no result is made, and nobody is told to go on there.
  void check_lock() const { lock_->check(); }

  RunEnd finish(const Replaceable& replaceable) {
    check_lock();
    const std::vector<std::string> paths = journals_of(settings_.result);
    if (paths.empty())
      throw std::runtime_error("the journals of " + settings_.result +
                               " were removed while it was computed; start it again");
    RunSettings patient = settings_;  // to count what is kept, for a moment
    patient.stopped = [this, end = Clock::now() + std::chrono::milliseconds(500)] {
      return is_stopped() && Clock::now() > end;
    };
    std::vector<JournalReader> readers = readable(paths, patient);
    for (const JournalReader& reader : readers)
      if (const std::string why = difference(header_, reader, settings_.mixed_fma); !why.empty())
        throw std::runtime_error(reader.path() + ' ' + why +
                                 "; another process has put it there, and nothing is written");
    const JournalSet chunks(std::move(readers), plan_.chunks(), settings_.mixed_fma);
    std::uint64_t missing = 0;
    for (std::uint64_t chunk = 0; chunk < plan_.chunks(); ++chunk)
      if ((!settings_.shard || settings_.shard->has(chunk)) && !chunks.has(chunk)) ++missing;
    const std::string kept =
        std::to_string(chunks.count()) + " chunks are kept beside " + settings_.result;
    if (missing > 0) {
      settings_.tell("stopped: " + kept + ", and " + std::to_string(missing) +
                     " are still to be computed; --resume goes on");
      return RunEnd::stopped;
    }
    check_lock();
    try {
      write(chunks, replaceable);
    } catch (const Stopped&) {
      settings_.tell("stopped: all " + kept + "; --resume writes the result");
      return RunEnd::stopped;
    } catch (const std::exception& error) {
      throw std::runtime_error(std::string(error.what()) + "; all " + kept +
                               ", and --resume writes the result once this is mended");
    }
    for (const std::string& path : paths) remove_or_tell(path);
    return RunEnd::done;
  }

  void write(const JournalSet& chunks, const Replaceable& replaceable) {
    const auto told = [&](std::uint64_t written) {
      if (is_stopped()) throw Stopped();
      if (settings_.progress)
        settings_.progress({RunProgress::Phase::writing, chunks.count(), written});
    };
    if (settings_.shard)
      write_shard(settings_.result, *settings_.shard, chunks, told, replaceable);
    else
      written_ = write_result(settings_.result, plan_, chunks, told, replaceable);
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
  JournalHeader header_;
  int threads_;
  std::optional<OutputLock> lock_;     // of rank 0
  std::optional<Descriptor> written_;  // the result, where this process has written it
};

SweepPlan plan_of(const JournalHeader& header) {
  std::vector<SceneSweep> scenes;
  for (const auto& [name, text] : header.files) {
    SweepReading reading = parse_sweep(text, name);
    if (!reading.sweep) throw RunRefused(reading.errors.front().line());
    scenes.push_back(std::move(*reading.sweep));
  }
  return make_plan(std::move(scenes));
}

void check_is_no_input(const std::string& output, const std::vector<std::string>& shards) {
  const std::vector<std::string> journals = journals_of(output);
  std::error_code none;
  for (const std::string& shard : shards) {
    if (fs::equivalent(shard, output, none))
      throw RunRefused("-o " + output + " is one of the shards; allowed: another file");
    for (const std::string& journal : journals)
      if (fs::equivalent(shard, journal, none))
        throw RunRefused(shard + " is the journal of " + output +
                         " itself; allowed: another file for -o");
  }
}

RunEnd merge_under_lock(const std::vector<std::string>& shards, const RunSettings& settings,
                        const std::vector<std::string>& journals, const Replaceable& replaceable) {
  std::optional<JournalSet> chunks;
  std::optional<SweepPlan> plan;
  try {
    std::vector<JournalReader> readers;
    for (const std::string& shard : shards) readers.emplace_back(shard, settings.stopped);
    const JournalHeader& header = readers.front().header();
    if (header.version != version)
      throw RunRefused(shards.front() + " was computed by tribocheck " + header.version +
                       ", this is " + std::string(version));
    plan = plan_of(header);
    if (plan->digest != header.digest)
      throw RunRefused(shards.front() + " is of a sweep that this tribocheck lays out otherwise");
    chunks.emplace(std::move(readers), plan->chunks(), settings.mixed_fma);
  } catch (const Stopped&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw RunRefused(error.what());
  }
  if (chunks->count() < chunks->chunks())
    throw RunRefused(std::to_string(chunks->chunks() - chunks->count()) + " of " +
                     std::to_string(chunks->chunks()) +
                     " chunks are in none of these; allowed: all shards of one sweep");
  check_room(*plan, 1, settings.result, shards);
  const auto told = [&](std::uint64_t written) {
    if (settings.stopped && settings.stopped()) throw Stopped();
    if (settings.progress)
      settings.progress({RunProgress::Phase::writing, chunks->chunks(), written});
  };
  Descriptor written = write_result(settings.result, *plan, *chunks, told, replaceable);
  remove_all(journals);
  if (settings.finished) settings.finished(std::move(written));
  return RunEnd::done;
}

}  // namespace

JournalHeader header_of(const SweepPlan& plan) {
  JournalHeader header{plan.version, plan.digest, std::string(arithmetic()), {}};
  for (const SceneSweep& scene : plan.scenes) header.files.emplace_back(scene.file, scene.text);
  return header;
}

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
  check_place_of_result(settings.result);
  const Replaceable replaceable{settings.force, FilePlace(settings.result).identity()};
  if (replaceable.only && !settings.force)
    throw RunRefused(settings.result + " is there already; --force replaces it");
  const std::vector<std::string> journals = journals_of(settings.result);
  if (!journals.empty() && !settings.force)
    throw RunRefused(journals.front() +
                     " is there, of a sweep that was stopped; --force throws it away");
  try {
    return merge_under_lock(shards, settings, journals, replaceable);
  } catch (const Stopped&) {
    settings.tell("stopped: nothing is written, and the shards are as they were");
    return RunEnd::stopped;
  }
}

}  // namespace tribo::sweep
