// SPDX-License-Identifier: Apache-2.0
// Another program, with all that it starts. Nothing of it outlives the program itself, this object,
// or this process, however that ends: a guard stands between, a process that adopts what the
// program leaves behind, also in a session of its own, and ends it all.
#pragma once

#include <sys/types.h>
#include <sys/wait.h>

#include <string>
#include <vector>

namespace tribo::conformance {

// The files that the program gets as its stdin, stdout and stderr; −1: /dev/null.
struct ChildStreams {
  int input = -1, output = -1, errors = -1;
};

class GuardedChild {
 public:
  // The program, the first word, is looked for in PATH unless its name has a slash. It gets a
  // process group of its own. Throws std::system_error where it cannot be started. The thread that
  // calls this is to live as long as the object: its end counts as the end of this process.
  GuardedChild(std::vector<std::string> command, const ChildStreams& streams);
  GuardedChild(const GuardedChild&) = delete;
  GuardedChild& operator=(const GuardedChild&) = delete;
  ~GuardedChild() { end(); }

  // Has the program ended, and all that it had started?
  bool has_ended() { return ended(WNOHANG); }
  void wait();
  // Ends the program and all that it has started; takes some milliseconds, and 3 s at the most.
  void end();

  int exit_code() const { return exited_ ? status_ : -1; }             // of a normal end, else −1
  int signal() const { return has_ended_ && !exited_ ? status_ : 0; }  // that ended it, or 0

 private:
  bool ended(int options);

  pid_t guard_ = -1;
  bool has_ended_ = false;
  bool exited_ = false;  // with code status_; else killed by signal status_
  int status_ = 0;
};

}  // namespace tribo::conformance
