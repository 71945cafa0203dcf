// SPDX-License-Identifier: Apache-2.0
// Another program as a child process. When the program, the object here or this process ends, in
// whatever way, the program and all that it started end. The guard, a process in between, adopts
// the processes that the program leaves behind, even in another session, and ends them.
#pragma once

#include <sys/types.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::conformance {

// The file descriptors that the program gets as its stdin, stdout and stderr; −1: /dev/null.
struct ChildStreams {
  int input = -1, output = -1, errors = -1;
};

class GuardedChild {
 public:
  // The first word is the program. It is looked for in PATH unless it has a slash, and gets a
  // process group of its own. Throws std::system_error if it cannot be started. The calling thread
  // must live as long as the object, because its end counts as the end of this process.
  GuardedChild(std::vector<std::string> command, const ChildStreams& streams);
  GuardedChild(const GuardedChild&) = delete;
  GuardedChild& operator=(const GuardedChild&) = delete;
  ~GuardedChild() { end(); }

  // Has the program ended, and all that it had started?
  bool has_ended() { return ended(WNOHANG); }
  void wait();
  // Ends the program and all that it has started. This takes some milliseconds, and at most 3 s.
  void end();

  int exit_code() const { return exited_ ? status_ : -1; }             // of a normal end, else −1
  int signal() const { return has_ended_ && !exited_ ? status_ : 0; }  // that ended it, or 0
  // CPU time of the program and of all that it had started; known after end().
  double cpu_seconds() const { return cpu_seconds_; }
  // The guard: the parent of the program.
  pid_t guard_id() const { return guard_; }

 private:
  bool ended(int options);

  pid_t guard_ = -1;
  bool has_ended_ = false;
  bool exited_ = false;  // with code status_; else killed by signal status_
  int status_ = 0;
  double cpu_seconds_ = 0;
};

inline constexpr std::size_t longest_line = std::size_t{1} << 20;

// A program whose output is read line by line. No call waits longer than its limit.
class ChildProcess {
 public:
  using Time = std::chrono::milliseconds;
  enum class Pipes : std::uint8_t {
    all,     // lines go to its stdin and come from its stdout, and the end of its stderr is kept
    output,  // it reads /dev/null, and its stderr is ours
  };
  // Starts the program as GuardedChild does. Throws std::system_error where it cannot be started.
  ChildProcess(std::vector<std::string> command, Pipes pipes);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();  // kills it

  // Queues a line for the child. The line is written as fast as the child reads.
  void send(std::string_view line);
  std::size_t unread() const;         // bytes that the child has not read yet
  std::size_t lines_at_hand() const;  // complete lines that have come
  bool is_within_a_line() const { return !received_.empty() && received_.back() != '\n'; }
  void close_input();  // once all is written

  enum class Event : std::uint8_t { line, nothing, too_long_line, end_of_output };
  // Waits up to `longest` for a line; `nothing`: none has come. too_long_line: it is over 1 MiB.
  // end_of_output: the child's stdout is closed, or the child has ended and all its output is read.
  Event next_line(std::string& line, Time longest);

  // All that the child writes until it ends; empty if it does not end within the limit. 0: there is
  // no limit.
  std::optional<std::string> rest_of_output(Time limit);

  bool refuses_input() const { return refuses_input_; }
  void kill();
  // How the child has ended: "exits with code 3", or "is killed by signal 11 (SIGSEGV, Segmentation
  // fault)". If a shell reports the signal by its exit code, ", as its exit code 139 says" follows.
  // If the child has not ended: "is still running".
  std::string end_text();
  bool has_ended() { return child_->has_ended(); }
  int exit_code() { return has_ended() ? child_->exit_code() : -1; }  // of a normal end, else −1
  int signal() { return has_ended() ? child_->signal() : 0; }         // that ended it, or 0
  const std::string& last_errors() const { return errors_; }    // the last 16 kB of its stderr
  pid_t guard_id() const { return child_->guard_id(); }         // that of the GuardedChild
  double cpu_seconds() const { return child_->cpu_seconds(); }  // known after kill()

 private:
  bool take_line(std::string& line);
  void pump(int milliseconds);
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

struct ChildEnd {
  int start_error = 0;   // an errno: it could not be started
  int exit_code = -1;    // −1: a signal ended it, or it was not started
  int signal = 0;        // the signal that ended it, or 0
  bool is_late = false;  // it had not ended in time, and was killed
  std::string text;      // its output; empty where it is late

  bool succeeded() const { return exited_with(0); }
  bool exited_with(int code) const { return !is_late && exit_code == code; }
};

// Runs a program to its end with Pipes::output. A program that has not ended within `limit` is
// killed, with all that it has started. 0: there is no limit.
ChildEnd run_child(std::vector<std::string> command, ChildProcess::Time limit = {});

}  // namespace tribo::conformance
