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
  std::chrono::milliseconds work{1000};     // of answers, from the first one on
  std::chrono::milliseconds limit{600000};  // of the whole run
  bool answers_at_end_of_input = false;     // if so, it gets one round of cases, no more
  std::function<bool()> stopped;            // asked often: shall the run end at once?
};

struct BusyRun {
  std::size_t answers = 0;
  bool was_stopped = false;
  std::string failure;                   // why the run failed; empty: it did not
  std::vector<std::string> error_lines;  // where it failed: its last lines on stderr
};

// Runs the program and asks it some cases of the first function, some of the next one and so on, in
// rounds, until it has worked for `work` and has got cases of each function. Then closes its input
// and waits for its end. Throws std::system_error where the program cannot be started.
BusyRun keep_busy(const std::vector<std::string>& command, const std::vector<TestCase>& cases,
                  const BusySettings& settings);

}  // namespace tribo::conformance
