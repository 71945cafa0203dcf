// SPDX-License-Identifier: Apache-2.0
// One process at a time works on an output: it looks at what is there, computes, and gives the
// result its name under this lock.
#pragma once

#include <string>

#include "sweep/output_file.hpp"

namespace tribo::sweep {

// A lock (flock) on the file OUTPUT.lock. The file is there only while a process holds the lock, or
// after such a process was killed. A process that finds the lock taken is refused.
class OutputLock {
 public:
  // Throws RunRefused where another process has it, or where OUTPUT.lock is a file that is not
  // ours; std::runtime_error where it cannot be made.
  explicit OutputLock(const std::string& output);
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  ~OutputLock();

  // False if somebody has removed the lock's file, so that another process may have taken its
  // place, or the folder.
  bool holds() const { return place_.leads_to(file_) && place_.is_folder_at_its_path(); }
  // Throws std::runtime_error, with a text that says why, if it does not hold.
  void check() const;

 private:
  std::string output_;
  FilePlace place_;
  Descriptor file_;
};

// The file that a path leads to, behind symbolic links; this file need not be there yet. Throws
// RunRefused where it is there and is no regular file, and where a link is of another user, who
// would choose which file is replaced.
std::string output_behind_links(const std::string& path);

}  // namespace tribo::sweep
