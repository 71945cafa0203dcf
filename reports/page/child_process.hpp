// SPDX-License-Identifier: Apache-2.0
// Running another program to its end, with all that it starts.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace tribo::report {

struct ChildEnd {
  int start_error = 0;   // an errno: it could not be started
  int exit_code = -1;    // −1: a signal ended it
  int signal = 0;        // the signal that ended it, or 0
  bool is_late = false;  // it was ended, as it had not ended in time
  std::string text;      // its output

  bool succeeded() const { return exited_with(0); }
  bool exited_with(int code) const { return start_error == 0 && !is_late && exit_code == code; }
};

// The program is looked for in PATH unless its name has a slash; its errors go where ours go, and
// it reads this file from where it stands, or nothing (−1). One that has not ended within `limit`
// is ended, with all that it has started; 0: no limit.
ChildEnd run_child(std::vector<std::string> command,
                   std::chrono::milliseconds limit = std::chrono::milliseconds(0), int input = -1);

}  // namespace tribo::report
