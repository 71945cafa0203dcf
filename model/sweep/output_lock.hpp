// SPDX-License-Identifier: Apache-2.0
// One process at a time works on an output: it looks at what is there, computes, and gives the
// result its name under this lock.
#pragma once

#include <stdexcept>
#include <string>

#include "sweep/disk.hpp"

namespace tribo::sweep {

// What is there does not fit what was asked: bad usage, not a failure.
struct RunRefused : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// A lock (flock) on the file OUTPUT.lock. The file is there only while a process holds the lock, or
// after such a process was killed. A process that finds the lock taken is refused.
class OutputLock {
 public:
  // Throws RunRefused where another process has it, std::runtime_error where it cannot be made.
  explicit OutputLock(const std::string& output);
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;
  ~OutputLock();

  // Throws std::runtime_error if somebody has removed the lock's file: then another process may
  // have taken its place.
  void check() const;

 private:
  bool is_named() const;

  std::string path_;
  Descriptor file_;
};

// The file that a path leads to, behind symbolic links; this file need not be there yet. Throws
// RunRefused where it is there and is no regular file.
std::string output_behind_links(const std::string& path);

}  // namespace tribo::sweep
