// SPDX-License-Identifier: Apache-2.0
#include "sweep/parts_in_hand.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <system_error>
#include <utility>

namespace tribo::sweep {
namespace {

namespace fs = std::filesystem;

// --- Borders.

constexpr double part_seconds = 2;
constexpr double most_parts = 4000;
constexpr double most_numbers = 1 << 21;  // that a part keeps: a process holds two parts or three

// Seconds of one processor for a chunk, within a factor of some.
double seconds_of_chunk(const SceneSweep& scene) {
  constexpr double point = 2e-7, solved = 0.5;
  const double speeds = scene.asks_at_speeds() ? static_cast<double>(scene.scene.speeds.size()) : 0;
  double a_case = speeds * (scene.outputs.empty() ? 0 : point);
  if (scene.solves_film) a_case += speeds * solved;
  for (const OnsetCriterion criterion : scene.criteria)
    a_case +=
        criterion == OnsetCriterion::film_maximum || criterion == OnsetCriterion::film_departure
            ? 1e-6
            : 5e-5;
  return a_case * static_cast<double>(scene.chunk_groups * scene.cases_per_group());
}

// Numbers of 8 bytes, at most some: of each column its counts too, whose bars grow with the cases.
double numbers_of_chunk(const SceneSweep& scene) {
  const std::size_t kept = scene.keep_points ? scene.width() + scene.variables.size() : 0;
  const auto cases = static_cast<double>(scene.chunk_cases());
  const double of_column = 8 + std::min(cases, 4096.0) / 2;
  return cases * static_cast<double>(kept) + static_cast<double>(scene.width()) * of_column;
}

std::size_t chunks_asked_for() {
  const char* const text = std::getenv("TRIBOCHECK_PART_CHUNKS");
  return text == nullptr ? 0 : static_cast<std::size_t>(std::atoi(text));
}

// --- Files.

// The files beside an output whose names are BEGINNING, that of the output, and an ending.
std::vector<std::string> files_like(const std::string& output, const std::string& beginning,
                                    const char* ending) {
  const std::string folder = folder_of(output);
  const std::string start = beginning + fs::path(output).filename().string();
  const std::regex ends(ending);
  std::vector<std::string> found;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(start) && std::regex_match(name.substr(start.size()), ends))
      found.push_back(output.substr(0, output.rfind('/') + 1) + name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<ChunkList> cut_in_parts(const SweepPlan& plan, const ChunkList& chunks) {
  struct Cost {
    double seconds, numbers;
  };
  std::vector<Cost> of_scene;
  for (const SceneSweep& scene : plan.scenes)
    of_scene.push_back({seconds_of_chunk(scene), numbers_of_chunk(scene)});
  const auto cost_of = [&](std::uint64_t chunk) { return of_scene[place_of(plan, chunk).scene]; };
  Cost all{0, 0};
  for (const std::uint64_t chunk : chunks) {
    all.seconds += cost_of(chunk).seconds;
    all.numbers += cost_of(chunk).numbers;
  }
  const Cost most{std::max(part_seconds, all.seconds / (most_parts / 2)),
                  std::max(most_numbers, all.numbers / (most_parts / 2))};
  const std::size_t asked = chunks_asked_for();
  std::vector<ChunkList> parts;
  Cost part{0, 0};
  for (const std::uint64_t chunk : chunks) {
    const bool is_full = asked > 0 ? !parts.empty() && parts.back().size() >= asked
                                   : part.seconds >= most.seconds || part.numbers >= most.numbers;
    if (parts.empty() || is_full) {
      parts.emplace_back();
      part = {0, 0};
    }
    parts.back().push_back(chunk);
    part.seconds += cost_of(chunk).seconds;
    part.numbers += cost_of(chunk).numbers;
  }
  return parts;
}

std::string path_of_part(const std::string& output, const ChunkList& chunks) {
  return output + ".part-" + std::to_string(chunks.front()) + '-' + std::to_string(chunks.back());
}

std::vector<std::string> parts_of(const std::string& output) {
  return files_like(output, "", R"(\.part-\d+-\d+)");
}

std::vector<std::string> files_of_parts(const std::string& output) {
  std::vector<std::string> files = files_like(output, "", R"(\.part-\d+-\d+(\.lock)?)");
  for (const std::string& begun : files_like(output, ".", R"(\.part-\d+-\d+\.\d+-\d+)"))
    files.push_back(begun);
  return files;
}

std::vector<std::string> journals_of(const std::string& output) {
  return files_like(output, "", R"(\.journal-\d+(\.new)?)");
}

PartsInHand::PartsInHand(Settings settings, std::vector<ChunkList> parts,
                         const std::vector<bool>& there)
    : settings_(std::move(settings)), parts_(std::move(parts)), there_(there) {}

bool PartsInHand::is_there(std::size_t part) {
  if (!there_[part] && !settings_.in_memory)
    there_[part] = FilePlace(path_of_part(settings_.output, parts_[part])).status().has_value();
  return there_[part];
}

bool PartsInHand::has_work_locked() {
  if (!in_hand_.empty() && in_hand_.back().next < parts_[in_hand_.back().part].size()) return true;
  for (std::size_t i = 0; i < parts_.size() && !is_over_; ++i) {
    const std::size_t part = (settings_.begin + i) % parts_.size();
    const auto is_ours = [part](const InHand& ours) { return ours.part == part; };
    if (std::any_of(in_hand_.begin(), in_hand_.end(), is_ours) || is_there(part)) continue;
    std::optional<OutputLock> claim;
    if (!settings_.in_memory) {
      claim = OutputLock::take(path_of_part(settings_.output, parts_[part]), ".lock");
      // It may have been written, and even put into the result, before it was claimed.
      if (!claim || is_there(part)) continue;
      is_over_ = settings_.over && settings_.over();
      if (is_over_) return false;
    }
    in_hand_.push_back({part, std::move(claim)});
    return true;
  }
  return false;
}

bool PartsInHand::has_work() {
  const std::lock_guard lock(mutex_);
  return has_work_locked();
}

bool PartsInHand::is_done() {
  const std::lock_guard lock(mutex_);
  look_at_all();
  return is_over_ || std::find(there_.begin(), there_.end(), false) == there_.end();
}

std::optional<std::uint64_t> PartsInHand::next() {
  const std::lock_guard lock(mutex_);
  if (!has_work_locked()) return std::nullopt;
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

// The claim ends with `done`, after the part has its name.
void PartsInHand::write(InHand done) {
  const std::string path = path_of_part(settings_.output, parts_[done.part]);
  if (FilePlace(path).status()) {
    // Another process has computed the same part, on a file system without locks. The two would
    // meet at each part from here on: this one goes on somewhere else.
    const std::lock_guard lock(mutex_);
    settings_.begin = place_of_process(parts_.size(), ++jumps_);
    return;
  }
  PartFile file(path);
  try {
    write_part(path, file, settings_.header, content_of(done.kept), {.any = true, .only = {}});
  } catch (const std::runtime_error&) {
    // Where another process has put the same part there at the same time, that one serves.
    const FilePlace place(path);
    if (!place.status() || place.leads_to(file.file())) throw;
  }
}

void PartsInHand::look_at_all() {
  looked_ = Clock::now();
  for (std::size_t part = 0; part < parts_.size(); ++part) is_there(part);
}

std::uint64_t PartsInHand::chunks_there() {
  const std::lock_guard lock(mutex_);
  if (!settings_.in_memory && Clock::now() - looked_ > std::chrono::seconds(1)) look_at_all();
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
