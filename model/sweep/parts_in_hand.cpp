// SPDX-License-Identifier: Apache-2.0
#include "sweep/parts_in_hand.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <regex>
#include <system_error>
#include <utility>

#include "sweep/result_file.hpp"
#include "tribo/onset.hpp"

namespace tribo::sweep {
namespace {

namespace fs = std::filesystem;

// --- Borders.

constexpr double part_seconds = 2;
constexpr double most_parts = 4000;
constexpr double most_numbers = 1 << 21;  // in a part: a process holds two or three parts

// A rough estimate of the cost of one or more chunks, or the most that a part may cost.
struct Cost {
  double seconds = 0;  // of one processor
  double numbers = 0;  // of 8 bytes each; estimated high

  void add(const Cost& other, double times = 1) {
    seconds += times * other.seconds;
    numbers += times * other.numbers;
  }
};

Cost cost_of_chunk(const SceneSweep& scene) {
  constexpr double point = 2e-7, solved = 0.5;
  const double speeds = scene.asks_at_speeds() ? static_cast<double>(scene.scene.speeds.size()) : 0;
  double a_case = speeds * (scene.outputs.empty() ? 0 : point);
  if (scene.solves_film) a_case += speeds * solved;
  for (const OnsetCriterion criterion : scene.criteria)
    a_case +=
        criterion == OnsetCriterion::film_maximum || criterion == OnsetCriterion::film_departure
            ? 1e-6
            : 5e-5;
  const std::size_t kept = scene.keep_points ? scene.width() + scene.variables.size() : 0;
  const auto cases = static_cast<double>(scene.chunk_cases());
  const double of_column = 8 + std::min(cases, 4096.0) / 2;  // its counts, which grow with cases
  return {a_case * static_cast<double>(scene.chunk_groups * scene.cases_per_group()),
          cases * static_cast<double>(kept) + static_cast<double>(scene.width()) * of_column};
}

// A part is full when it reaches one of these two limits.
Cost most_of_part(const Cost& all) {
  return {std::max(part_seconds, all.seconds / (most_parts / 2)),
          std::max(most_numbers, all.numbers / (most_parts / 2))};
}

std::size_t chunks_asked_for() {
  const char* const text = std::getenv("TRIBOCHECK_PART_CHUNKS");
  return text == nullptr ? 0 : static_cast<std::size_t>(std::atoi(text));
}

// --- Files.

// Looks for file names in the output's folder that start with `beginning` and the output's name.
// Returns what follows this start in each name; sorted.
std::vector<std::string> endings_beside(const std::string& output, const std::string& beginning) {
  const std::string start = beginning + fs::path(output).filename().string();
  std::vector<std::string> endings;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(output), none))
    if (const std::string name = entry.path().filename().string(); name.starts_with(start))
      endings.push_back(name.substr(start.size()));
  std::sort(endings.begin(), endings.end());
  return endings;
}

// The files beside an output whose endings_beside() match the regular expression `ending`.
std::vector<std::string> files_like(const std::string& output, const std::string& beginning,
                                    const std::string& ending) {
  const std::size_t name = output.rfind('/') + 1;
  const std::regex ends(ending);
  std::vector<std::string> found;
  for (const std::string& one : endings_beside(output, beginning))
    if (std::regex_match(one, ends))
      found.push_back(output.substr(0, name) + beginning + output.substr(name) + one);
  return found;
}

const std::string part_ending = R"(\.part-\d+-\d+(-\d+)?)";
const std::string begun_ending = R"(\.\d+-\d+)";  // of files that were not renamed yet

}  // namespace

std::vector<ChunkList> cut_in_parts(const SweepPlan& plan, const ChunkList& chunks) {
  std::vector<Cost> of_scene;
  for (const SceneSweep& scene : plan.scenes) of_scene.push_back(cost_of_chunk(scene));
  const auto cost_of = [&](std::uint64_t chunk) { return of_scene[place_of(plan, chunk).scene]; };
  Cost all;
  for (const std::uint64_t chunk : chunks) all.add(cost_of(chunk));
  const Cost most = most_of_part(all);
  const std::size_t asked = chunks_asked_for();
  std::vector<ChunkList> parts;
  Cost part;
  for (const std::uint64_t chunk : chunks) {
    const bool is_full = asked > 0 ? !parts.empty() && parts.back().size() >= asked
                                   : part.seconds >= most.seconds || part.numbers >= most.numbers;
    if (parts.empty() || is_full) {
      parts.emplace_back();
      part = {};
    }
    parts.back().push_back(chunk);
    part.add(cost_of(chunk));
  }
  return parts;
}

double most_chunks_of_part(const SweepPlan& plan) {
  if (const std::size_t asked = chunks_asked_for(); asked > 0) return static_cast<double>(asked);
  Cost all;
  for (const SceneSweep& scene : plan.scenes)
    all.add(cost_of_chunk(scene), static_cast<double>(scene.chunks));
  const Cost most = most_of_part(all);
  double chunks = 0;
  for (const SceneSweep& scene : plan.scenes) {
    const Cost chunk = cost_of_chunk(scene);
    chunks = std::max(
        chunks, std::ceil(std::min(most.seconds / chunk.seconds, most.numbers / chunk.numbers)));
  }
  return std::min(chunks + 1, static_cast<double>(plan.chunks()));
}

std::string path_of_part(const std::string& output, const ChunkList& chunks) {
  std::string path =
      output + ".part-" + std::to_string(chunks.front()) + '-' + std::to_string(chunks.back());
  const std::uint64_t step = chunks.size() > 1 ? chunks[1] - chunks[0] : 1;
  return step == 1 ? path : path + '-' + std::to_string(step);
}

std::vector<std::string> parts_of(const std::string& output) {
  return files_like(output, "", part_ending);
}

std::vector<std::string> files_of_parts(const std::string& output) {
  std::vector<std::string> files = files_like(output, "", part_ending + R"((\.lock)?)");
  for (const std::string& begun : files_like(output, ".", part_ending + begun_ending))
    files.push_back(begun);
  return files;
}

void remove_begun(const std::string& output) {
  const auto remove = [](const std::string& path) {
    try {
      FilePlace(path).remove_ours([](std::span<const std::byte> start) {
        return is_start_of_part(start) || is_start_of_result(start);
      });
    } catch (const RunRefused&) {  // somebody else's file: no sweep needs its name
    }
  };
  for (const std::string& begun : files_like(output, ".", begun_ending)) remove(begun);
  const std::size_t name = output.rfind('/') + 1;
  for (const std::string& begun : files_like(output, ".", part_ending + begun_ending)) {
    const std::string part = begun.substr(name + 1, begun.rfind('.') - name - 1);
    const auto claim = OutputLock::take(output.substr(0, name) + part, ".lock");
    if (claim && claim->is_exclusive()) remove(begun);
  }
}

std::vector<std::string> journals_of(const std::string& output) {
  return files_like(output, "", R"(\.journal-\d+(\.new)?)");
}

PartsInHand::PartsInHand(Settings settings, std::vector<ChunkList> parts,
                         const std::vector<bool>& there)
    : settings_(std::move(settings)), parts_(std::move(parts)), there_(there) {
  std::string longest;
  for (std::size_t part = 0; part < parts_.size() && !settings_.in_memory; ++part)
    if (const std::string path = path_of_part(settings_.output, parts_[part]);
        !there_[part] && path.size() > longest.size())
      longest = path;
  if (!longest.empty()) static_cast<void>(PartFile(longest));  // a trial: makes and removes it
}

bool PartsInHand::has_chunks() const {
  return !in_hand_.empty() && in_hand_.back().next < parts_[in_hand_.back().part].size();
}

// Notes the parts that are there, by one look at the folder.
void PartsInHand::look() {
  if (settings_.in_memory) return;
  const std::vector<std::string> found = endings_beside(settings_.output, "");
  const std::lock_guard lock(mutex_);
  for (std::size_t part = 0; part < parts_.size(); ++part)
    if (!there_[part])
      there_[part] = std::binary_search(found.begin(), found.end(), path_of_part("", parts_[part]));
  looked_ = Clock::now();
}

// The parts that are neither there nor in hand, in the order in which this process takes them.
std::vector<std::size_t> PartsInHand::missing() {
  look();
  const std::lock_guard lock(mutex_);
  std::vector<bool> is_known = there_;
  for (const InHand& ours : in_hand_) is_known[ours.part] = true;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (const std::size_t part = (settings_.begin + i) % parts_.size(); !is_known[part])
      missing.push_back(part);
  return missing;
}

// Claims a part for this process; nothing where no part is left for it.
std::optional<PartsInHand::InHand> PartsInHand::claim() {
  for (const std::size_t part : missing()) {
    InHand made{part};
    if (settings_.in_memory) return made;
    const std::string path = path_of_part(settings_.output, parts_[part]);
    made.claim = OutputLock::take(path, ".lock");
    // Before the claim, another process may have written the part, or even put it into the result.
    if (!made.claim || FilePlace(path).status()) continue;
    is_over_ = settings_.over && settings_.over();
    if (is_over_) break;
    return made;
  }
  return std::nullopt;
}

// Claims a part if no chunks are in hand; false: all parts are there, claimed or not needed. One
// thread claims while the others wait for it. Meanwhile any thread may call keep().
bool PartsInHand::find_work(std::unique_lock<std::mutex>& lock) {
  claimed_.wait(lock, [this] { return has_chunks() || !is_claiming_; });
  if (has_chunks() || is_over_) return has_chunks();
  is_claiming_ = true;
  lock.unlock();
  std::optional<InHand> found;
  std::exception_ptr failure;
  try {
    found = claim();
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  is_claiming_ = false;
  if (found) in_hand_.push_back(std::move(*found));
  claimed_.notify_all();
  if (failure != nullptr) std::rethrow_exception(failure);
  return has_chunks();
}

bool PartsInHand::has_work() {
  std::unique_lock lock(mutex_);
  return find_work(lock);
}

bool PartsInHand::is_done() {
  look();
  const std::lock_guard lock(mutex_);
  return is_over_ || std::find(there_.begin(), there_.end(), false) == there_.end();
}

std::optional<std::uint64_t> PartsInHand::next() {
  std::unique_lock lock(mutex_);
  if (!find_work(lock)) return std::nullopt;
  InHand& last = in_hand_.back();
  return parts_[last.part][last.next++];
}

void PartsInHand::keep(std::uint64_t chunk, Bytes bytes) {
  std::list<InHand> done;
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(in_hand_.begin(), in_hand_.end(), [&](const InHand& one) {
      return std::binary_search(parts_[one.part].begin(), parts_[one.part].end(), chunk);
    });
    found->kept.emplace(chunk, std::move(bytes));
    if (found->kept.size() < parts_[found->part].size()) return;
    done.splice(done.begin(), in_hand_, found);
    there_[done.front().part] = true;
    if (settings_.in_memory) {
      in_memory_.merge(done.front().kept);
      return;
    }
  }
  write(std::move(done.front()));
}

// Writes a part. The claim is kept until this function ends, when the file has its final name.
void PartsInHand::write(InHand done) {
  const std::string path = path_of_part(settings_.output, parts_[done.part]);
  if (FilePlace(path).status()) {
    // Another process has computed the same part, on a file system without locks. Both would
    // compute the same parts from here on. Therefore this one goes on at another part.
    const std::lock_guard lock(mutex_);
    settings_.begin = place_of_process(parts_.size(), ++jumps_);
    return;
  }
  PartFile file(path);
  try {
    write_part(path, file, settings_.header, content_of(done.kept), {.any = true, .only = {}});
  } catch (const std::runtime_error&) {
    // If another process has put the same part there at the same time, its file is used.
    const FilePlace place(path);
    if (!place.status() || place.leads_to(file.file())) throw;
  }
}

std::uint64_t PartsInHand::chunks_there() {
  std::unique_lock lock(mutex_);
  if (Clock::now() - looked_ > std::chrono::seconds(1)) {
    lock.unlock();
    look();
    lock.lock();
  }
  std::uint64_t chunks = 0;
  for (std::size_t part = 0; part < parts_.size(); ++part)
    if (there_[part]) chunks += parts_[part].size();
  for (const InHand& one : in_hand_) chunks += one.kept.size();
  return chunks;
}

std::size_t place_of_process(std::size_t parts, std::uint64_t turn) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string self = host.data() + std::to_string(::getpid()) + ' ' + std::to_string(turn);
  return parts == 0 ? 0 : std::hash<std::string>{}(self) % parts;
}

}  // namespace tribo::sweep
