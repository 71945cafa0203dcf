// SPDX-License-Identifier: Apache-2.0
// Running another program to its end, with all that it starts.
#pragma once

#include <string>
#include <vector>

namespace tribo::report {

struct ChildEnd {
  int start_error = 0;  // an errno: it could not be started
  int exit_code = -1;   // −1: a signal ended it
  int signal = 0;       // that ended it, or 0
  std::string text;     // its output

  bool succeeded() const { return exited_with(0); }
  bool exited_with(int code) const { return start_error == 0 && exit_code == code; }
};

// The program is looked for in PATH unless its name has a slash; it gets no input, and its errors
// go where ours go.
ChildEnd run_child(std::vector<std::string> command);

}  // namespace tribo::report
