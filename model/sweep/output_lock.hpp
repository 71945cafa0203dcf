// SPDX-License-Identifier: Apache-2.0
// Locks that end with the process that holds them. One process at a time owns an output: it looks
// at what is there, and gives the result its name under the lock OUTPUT.lock. A part that is
// computed is claimed by a lock of its own (parts_in_hand.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sweep/output_file.hpp"

namespace tribo::sweep {

// A lock (flock) on a small file of its own. The file is there only while a process holds the lock,
// or after such a process was killed. On a file system that has no locks each process gets it.
class OutputLock {
 public:
  // Throws RunRefused where another process has OUTPUT.lock, or where that is a file that is not
  // ours; std::runtime_error where it cannot be made.
  explicit OutputLock(const std::string& output);
  // The lock OUTPUT + ENDING; nothing where another process has it. Throws likewise.
  static std::optional<OutputLock> take(const std::string& output, std::string_view ending);
  OutputLock(OutputLock&&) = default;
  OutputLock& operator=(OutputLock&&) = default;
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  ~OutputLock();

  // False if somebody has removed the lock's file, so that another process may have taken its
  // place, or the folder.
  bool holds() const { return leads_to_it() && place_.is_folder_at_its_path(); }
  // Throws std::runtime_error, with a text that says why, if it does not hold.
  void check() const;

 private:
  OutputLock(const std::string& output, std::string_view ending);
  // Without locks, any process that ends removes the file.
  bool leads_to_it() const;

  std::string output_;
  Locking locking_ = Locking::locked;
  FilePlace place_;
  Descriptor file_;
};

// The file that a path leads to, behind symbolic links; this file need not be there yet. Throws
// RunRefused where it is there and is no regular file, and where a link is of another user, who
// would choose which file is replaced.
std::string output_behind_links(const std::string& path);

}  // namespace tribo::sweep
