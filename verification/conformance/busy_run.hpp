// SPDX-License-Identifier: Apache-2.0
// A solver kept busy for some time, so that a profiler has something to measure.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "conformance/conformance_case.hpp"

namespace tribo::conformance {

struct BusySettings {
  std::chrono::milliseconds work{1000};     // how long it shall answer, from its first answer on
  std::chrono::milliseconds limit{600000};  // of the whole run
  bool answers_at_end_of_input = false;     // true: it gets only one round of cases
  std::function<bool()> stopped;            // called often; true ends the run at once
};

struct BusyRun {
  std::size_t answers = 0;
  bool was_stopped = false;
  std::string failure;                   // why the run failed; empty: it did not
  std::vector<std::string> error_lines;  // if it failed: the last lines of its stderr
};

// Runs the program and asks it cases in rounds; a round has some cases of each function. After at
// least one round and the time `work`, closes its input and waits for its end. There must be a
// case, and `stopped` must be set. Throws std::system_error if the program cannot be started.
BusyRun keep_busy(const std::vector<std::string>& command, const std::vector<TestCase>& cases,
                  const BusySettings& settings);

}  // namespace tribo::conformance
