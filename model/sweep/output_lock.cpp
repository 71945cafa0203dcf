// SPDX-License-Identifier: Apache-2.0
#include "sweep/output_lock.hpp"

#include <filesystem>
#include <optional>
#include <utility>

namespace tribo::sweep {

namespace fs = std::filesystem;

// A process that holds the lock removes the lock's file before it releases the lock. So a process
// that locks a file which has lost its name meanwhile has locked nothing, and begins again.
OutputLock::OutputLock(const std::string& output, std::string_view ending)
    : output_(output), place_(output, ending) {
  do {
    std::optional<Descriptor> file = place_.open_ours(no_mark);
    if (!file) file = place_.create();
    if (!file) continue;
    locking_ = lock_file(*file, place_.path());
    if (locking_ == Locking::taken_by_another) return;
    file_ = std::move(*file);
  } while (!leads_to_it());
}

OutputLock::OutputLock(const std::string& output) : OutputLock(output, ".lock") {
  if (locking_ == Locking::taken_by_another)
    throw RunRefused(output + " is being written by another process, which holds " + place_.path() +
                     "; wait until it has ended, or give another output");
}

std::optional<OutputLock> OutputLock::take(const std::string& output, std::string_view ending) {
  OutputLock lock(output, ending);
  if (lock.locking_ == Locking::taken_by_another) return std::nullopt;
  return lock;
}

OutputLock::~OutputLock() {
  if (place_.leads_to(file_)) place_.remove();
}

bool OutputLock::leads_to_it() const {
  return locking_ == Locking::without_locks || place_.leads_to(file_);
}

void OutputLock::check() const {
  if (!place_.is_folder_at_its_path())
    throw std::runtime_error("the folder of " + output_ +
                             " was removed or moved while this process computed; nothing can be "
                             "written there, and what was removed has to be computed anew");
  if (!leads_to_it())
    throw std::runtime_error(place_.path() + " was removed while this process held it, so that " +
                             "another one may write the same output; nothing is put in its place");
}

std::string output_behind_links(const std::string& path) {
  fs::path behind(path);
  constexpr int most_links = 40;  // as the system
  std::error_code none;
  for (int links = 0; fs::is_symlink(behind, none); ++links) {
    if (links == most_links) throw RunRefused(path + " is a symbolic link that leads in a circle");
    struct stat link {};
    const bool is_known = ::lstat(behind.c_str(), &link) == 0;
    if (is_known && link.st_uid != ::geteuid() && link.st_uid != 0)
      throw RunRefused(behind.string() +
                       " is a symbolic link of another user, and is not followed; allowed: the "
                       "file itself");
    behind = behind.parent_path() / fs::read_symlink(behind, none);
  }
  if (fs::exists(behind, none) && !fs::is_regular_file(behind, none))
    throw RunRefused(path + " is " +
                     (fs::is_directory(behind, none) ? "a directory" : "no regular file") +
                     "; allowed: a file, or none yet");
  return behind.string();
}

}  // namespace tribo::sweep
