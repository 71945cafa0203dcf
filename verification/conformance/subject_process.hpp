// SPDX-License-Identifier: Apache-2.0
// Somebody else's program as a child process: lines go to its stdin and come from its stdout, and
// the end of its stderr is kept. Processes that the child has started end with it. Whatever the
// child does, no call here waits longer than its limit.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "conformance/guarded_child.hpp"

namespace tribo::conformance {

inline constexpr std::size_t longest_line = std::size_t{1} << 20;

class SubjectProcess {
 public:
  // Runs a command line by /bin/sh. Throws std::runtime_error where not even that starts.
  explicit SubjectProcess(const std::string& command);
  SubjectProcess(const SubjectProcess&) = delete;
  SubjectProcess& operator=(const SubjectProcess&) = delete;
  ~SubjectProcess();  // kills it

  // Queues a line for the child; pump() writes it as fast as the child reads.
  void send(std::string_view line);
  std::size_t unread() const;         // bytes that the child has not read yet
  std::size_t lines_at_hand() const;  // that next_line() gives without waiting
  bool is_within_a_line() const { return !received_.empty() && received_.back() != '\n'; }
  void close_input();  // once all is written

  enum class Event : std::uint8_t { line, nothing, too_long_line, end_of_output };
  // Waits up to so long for a line. end_of_output: its stdout is closed, or it is gone and all that
  // it wrote is read.
  Event next_line(std::string& line, std::chrono::milliseconds longest);

  bool refuses_input() const { return refuses_input_; }
  void kill();
  // "exits with code 3", "is killed by signal 11 (Segmentation fault)", "is still running".
  std::string end_text();
  bool has_ended() { return child_->has_ended(); }
  int exit_code() { return has_ended() ? child_->exit_code() : -1; }  // of a normal end, else −1
  const std::string& last_errors() const { return errors_; }  // the last 16 kB of its stderr

 private:
  bool take_line(std::string& line);
  void pump(int milliseconds);
  void read_output();
  void read_errors();
  void write_input();
  void refuse_input();

  std::optional<GuardedChild> child_;
  int input_ = -1, output_ = -1, error_ = -1;
  bool refuses_input_ = false, close_when_written_ = false;
  std::string to_write_;
  std::string received_;
  std::size_t searched_ = 0;
  std::string errors_;
};

}  // namespace tribo::conformance
