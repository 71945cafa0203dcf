// SPDX-License-Identifier: Apache-2.0
#include "sweep/run.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <system_error>
#include <utility>

#include "sweep/arithmetic.hpp"
#include "sweep/compute.hpp"
#include "sweep/plan_reader.hpp"
#include "sweep/result_file.hpp"
#include "tribo/version.hpp"

namespace tribo::sweep {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view journal_ending = ".journal-";

std::vector<JournalReader> readers_of(const std::vector<std::string>& paths) {
  std::vector<JournalReader> readers;
  readers.reserve(paths.size());
  for (const std::string& path : paths) readers.emplace_back(path);
  return readers;
}

// Why a journal or result of another sweep is not this one's; empty if it is.
std::string difference(const JournalHeader& mine, const std::string& version,
                       const std::string& digest, const std::string& instruction_set, bool any) {
  if (version != mine.version)
    return "was computed by tribocheck " + version + ", this is " + mine.version;
  if (digest != mine.digest) return "is of another sweep: its files' texts are not these";
  if (instruction_set != mine.instruction_set && !any)
    return "was computed on " + instruction_set + ", this is " + mine.instruction_set +
           ": other last digits; --any-instruction-set goes on all the same";
  return {};
}

void remove_all(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) fs::remove(path);
}

// --- What is there before the run.

struct Start {
  bool complete = false;               // the result is there
  std::vector<std::uint64_t> pending;  // chunks
  std::uint64_t found = 0;             // chunks in journals
};

class Starter {
 public:
  Starter(const SweepPlan& plan, const RunSettings& settings, const JournalHeader& header)
      : plan_(plan), settings_(settings), header_(header) {}

  Start start() {
    const std::string& path = settings_.result;
    if (fs::exists(path) && !fs::is_regular_file(path))
      throw RunRefused(path + " is " +
                       (fs::is_directory(path) ? "a directory" : "no regular file") +
                       "; allowed: a file, or none yet");
    const std::vector<std::string> journals = journals_of(path);
    if (settings_.force) {
      remove_all(journals);
      fs::remove(path);
      return {false, wanted({}), 0};
    }
    if (fs::exists(path)) return existing_result(journals);
    if (!journals.empty() && !settings_.resume)
      throw RunRefused(journals.front() +
                       " is there, of a sweep that was stopped; --resume goes on "
                       "with it, --force throws it away");
    return from_journals(journals);
  }

 private:
  Start existing_result(const std::vector<std::string>& journals) {
    const std::string& path = settings_.result;
    if (!settings_.resume)
      throw RunRefused(path +
                       " is there already; --resume keeps it if it is this sweep's, --force "
                       "replaces it");
    const std::string why = settings_.shard ? of_shard(path) : of_result(path);
    if (!why.empty()) throw RunRefused(path + ' ' + why + "; --force replaces it");
    remove_all(journals);
    return {true, {}, 0};
  }

  std::string of_result(const std::string& path) const {
    ResultIdentity identity;
    try {
      identity = identity_of_result(path);
    } catch (const std::runtime_error& error) {
      throw RunRefused(std::string(error.what()) + "; --force replaces it");
    }
    return difference(header_, identity.version, identity.digest, identity.instruction_set,
                      settings_.any_instruction_set);
  }

  std::string of_shard(const std::string& path) const {
    const JournalReader reader = read(path);
    if (std::string why = different(reader); !why.empty()) return why;
    for (const JournalReader::Record& record : reader.records())
      if (!settings_.shard->has(record.chunk)) return "is another shard";
    return {};
  }

  JournalReader read(const std::string& path) const {
    try {
      return JournalReader(path);
    } catch (const std::runtime_error& error) {
      throw RunRefused(std::string(error.what()) + "; --force throws it away");
    }
  }
  std::string different(const JournalReader& reader) const {
    const JournalHeader& theirs = reader.header();
    return difference(header_, theirs.version, theirs.digest, theirs.instruction_set,
                      settings_.any_instruction_set);
  }

  Start from_journals(const std::vector<std::string>& journals) {
    std::vector<bool> there(plan_.chunks());
    Start start;
    for (const std::string& path : journals) {
      const JournalReader reader = read(path);
      if (const std::string why = different(reader); !why.empty())
        throw RunRefused(std::string(path).append(" ").append(why));
      if (reader.lost_bytes() > 0)
        settings_.tell(path + ": " + std::to_string(reader.lost_bytes()) +
                       " bytes are no whole record, and are computed anew");
      for (const JournalReader::Record& record : reader.records())
        if (record.chunk < there.size()) there[record.chunk] = true;
    }
    start.found = static_cast<std::uint64_t>(std::count(there.begin(), there.end(), true));
    start.pending = wanted(there);
    if (settings_.resume)
      settings_.tell(start.found == 0 ? "nothing to go on with; starting anew"
                                      : "going on: " + std::to_string(start.found) + " of " +
                                            std::to_string(start.found + start.pending.size()) +
                                            " chunks are there");
    return start;
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
};

// --- The end: from journals to one file.

// A shard is a journal with its chunks in order.
void write_shard(const std::string& path, const Shard& shard, const JournalSet& chunks) {
  const std::string part = path + ".part";
  fs::remove(part);
  {
    Journal journal = Journal::create(part, chunks.header());
    for (std::uint64_t chunk = 0; chunk < chunks.chunks(); ++chunk)
      if (shard.has(chunk)) journal.append(chunk, chunks.read(chunk));
    journal.sync();
  }
  fs::rename(part, path);
}

class Run {
 public:
  Run(const SweepPlan& plan, const RunSettings& settings, const Ranks& ranks)
      : plan_(plan), settings_(settings), ranks_(ranks), header_(header_of(plan)) {}

  RunEnd run() {
    agree_on_plan();
    Start start = start_on_first();
    if (start.complete) return RunEnd::done;
    compute_all(std::move(start.pending));
    return ranks_.rank() == 0 ? finish() : RunEnd::done;
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
    const std::string mine = header_.digest + ' ' + header_.instruction_set;
    const std::string first = ranks_.from_first(mine);
    together([&] {
      if (first == mine) return;
      throw RunRefused("rank " + std::to_string(ranks_.rank()) +
                       " reads other files than rank 0, or computes on another instruction set (" +
                       header_.instruction_set + "); --instruction-set makes them the same");
    });
  }

  Start start_on_first() {
    Start start;
    together([&] {
      if (ranks_.rank() == 0) start = Starter(plan_, settings_, header_).start();
    });
    start.complete = ranks_.from_first(start.complete ? "complete" : "") == "complete";
    return start;
  }

  void compute_all(std::vector<std::uint64_t> pending) {
    std::optional<Journal> journal;
    together([&] { journal.emplace(open_journal()); });
    const std::uint64_t total = pending.size();
    ChunkQueue queue(std::move(pending));
    std::atomic<std::uint64_t> computed = 0;
    const int threads = settings_.threads > 0 || ranks_.count() == 1 ? settings_.threads : 1;
    together([&] {
      const bool good = ranks_.share(
          queue,
          [&](const NextChunk& next) {
            compute(plan_, threads, next, [&](const Chunk& chunk) {
              journal->append(chunk.number, chunk.bytes());
              ++computed;
            });
          },
          [&](std::uint64_t elsewhere) {
            if (ranks_.rank() == 0 && settings_.progress)
              settings_.progress({RunProgress::Phase::computing, total, computed + elsewhere});
          },
          [&] { return settings_.stopped && settings_.stopped(); });
      journal->sync();
      if (!good) throw OtherRankFailed();
    });
  }

  Journal open_journal() const {
    const std::string path = journal_of(settings_.result, ranks_.rank());
    return fs::exists(path) ? Journal::resume(path) : Journal::create(path, header_);
  }

  RunEnd finish() const {
    const std::vector<std::string> paths = journals_of(settings_.result);
    const JournalSet chunks(readers_of(paths), plan_.chunks(), settings_.any_instruction_set);
    std::uint64_t missing = 0;
    for (std::uint64_t chunk = 0; chunk < plan_.chunks(); ++chunk)
      if ((!settings_.shard || settings_.shard->has(chunk)) && !chunks.has(chunk)) ++missing;
    if (missing > 0) {
      settings_.tell("stopped: " + std::to_string(chunks.count()) + " chunks are kept beside " +
                     settings_.result + ", " + std::to_string(missing) +
                     " are missing; --resume goes on");
      return RunEnd::stopped;
    }
    if (settings_.shard)
      write_shard(settings_.result, *settings_.shard, chunks);
    else
      write(chunks);
    remove_all(paths);
    return RunEnd::done;
  }

  void write(const JournalSet& chunks) const {
    write_result(settings_.result, plan_, chunks, [&](std::uint64_t written) {
      if (settings_.progress)
        settings_.progress({RunProgress::Phase::writing, chunks.chunks(), written});
    });
  }

  const SweepPlan& plan_;
  const RunSettings& settings_;
  const Ranks& ranks_;
  JournalHeader header_;
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

}  // namespace

std::string journal_of(const std::string& result, int rank) {
  return result + std::string(journal_ending) + std::to_string(rank);
}

std::vector<std::string> journals_of(const std::string& result) {
  const fs::path path(result);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::string start = path.filename().string() + std::string(journal_ending);
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

JournalHeader header_of(const SweepPlan& plan) {
  JournalHeader header{plan.version, plan.digest, arithmetic(), {}};
  for (const SceneSweep& scene : plan.scenes) header.files.emplace_back(scene.file, scene.text);
  return header;
}

RunEnd run(const SweepPlan& plan, const RunSettings& settings, const Ranks& ranks) {
  return Run(plan, settings, ranks).run();
}

void merge(const std::vector<std::string>& shards, const RunSettings& settings) {
  if (fs::exists(settings.result) && !settings.force)
    throw RunRefused(settings.result + " is there already; --force replaces it");
  std::optional<JournalSet> chunks;
  std::optional<SweepPlan> plan;
  try {
    std::vector<JournalReader> readers = readers_of(shards);
    const JournalHeader& header = readers.front().header();
    if (header.version != version)
      throw RunRefused(shards.front() + " was computed by tribocheck " + header.version +
                       ", this is " + std::string(version));
    plan = plan_of(header);
    if (plan->digest != header.digest)
      throw RunRefused(shards.front() + " is of a sweep that this tribocheck lays out otherwise");
    chunks.emplace(std::move(readers), plan->chunks(), settings.any_instruction_set);
  } catch (const std::runtime_error& error) {
    throw RunRefused(error.what());
  }
  if (chunks->count() < chunks->chunks())
    throw RunRefused(std::to_string(chunks->chunks() - chunks->count()) + " of " +
                     std::to_string(chunks->chunks()) +
                     " chunks are in none of these; allowed: all shards of one sweep");
  write_result(settings.result, *plan, *chunks, [&](std::uint64_t written) {
    if (settings.progress)
      settings.progress({RunProgress::Phase::writing, chunks->chunks(), written});
  });
}

}  // namespace tribo::sweep
