// SPDX-License-Identifier: Apache-2.0
// Running another program to its end.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tribo::report {

enum class Heard : std::uint8_t {
  last_errors,  // no output; of its errors the last few kilobytes
  output,       // its output; its errors go where ours go
};

struct ChildEnd {
  int start_error = 0;   // an errno: it could not be started
  int status = -1;       // as waitpid gives it; -1: not known
  bool is_late = false;  // it was killed, as it had not ended in time
  std::string text;      // what was heard

  bool succeeded() const;
  bool exited_with(int code) const;
  int signal() const;  // that ended it, or 0
};

// The program is looked for in PATH unless its name has a slash; it gets no input. One that has not
// ended within `limit` is killed; 0: no limit.
ChildEnd run_child(std::vector<std::string> command, Heard heard,
                   std::chrono::milliseconds limit = std::chrono::milliseconds(0));

}  // namespace tribo::report
