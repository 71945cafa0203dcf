// SPDX-License-Identifier: Apache-2.0
#include "sweep/output_lock.hpp"

#include <filesystem>

namespace tribo::sweep {

namespace fs = std::filesystem;

// A process that holds the lock removes the lock's file before it releases the lock. So a process
// that locks a file which has lost its name meanwhile has locked nothing, and begins again.
OutputLock::OutputLock(const std::string& output) : path_(output + ".lock") {
  do {
    file_ = open_file(path_, O_RDWR | O_CREAT | O_NOFOLLOW, "cannot write " + output);
    if (!lock_file(file_, path_))
      throw RunRefused(output + " is being written by another process, which holds " + path_ +
                       "; wait until it has ended, or give another output");
  } while (!is_named());
}

OutputLock::~OutputLock() {
  if (is_named()) ::unlink(path_.c_str());
}

void OutputLock::check() const {
  if (!is_named())
    throw std::runtime_error(path_ + " was removed while this process held it, so that another " +
                             "one may write the same output; nothing is put in its place");
}

bool OutputLock::is_named() const {
  struct stat ours {
  }, named{};
  return ::fstat(file_, &ours) == 0 && ::stat(path_.c_str(), &named) == 0 &&
         ours.st_dev == named.st_dev && ours.st_ino == named.st_ino;
}

std::string output_behind_links(const std::string& path) {
  fs::path behind(path);
  constexpr int most_links = 40;  // as the system
  std::error_code none;
  for (int links = 0; fs::is_symlink(behind, none); ++links) {
    if (links == most_links) throw RunRefused(path + " is a symbolic link that leads in a circle");
    behind = behind.parent_path() / fs::read_symlink(behind, none);
  }
  if (fs::exists(behind, none) && !fs::is_regular_file(behind, none))
    throw RunRefused(path + " is " +
                     (fs::is_directory(behind, none) ? "a directory" : "no regular file") +
                     "; allowed: a file, or none yet");
  return behind.string();
}

}  // namespace tribo::sweep
