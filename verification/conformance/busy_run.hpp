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
  bool answers_at_end_of_input = false;     // then it gets one round of cases, and no more
  std::function<bool()> stopped;            // asked often: shall the run end at once?
};

struct BusyRun {
  std::size_t answers = 0;
  bool was_stopped = false;
  std::string failure;                   // why it did not come to its end; empty: it did
  std::vector<std::string> error_lines;  // the last that it wrote to stderr, where it failed
};

// Runs the program and asks it the cases, some of each function after the other and again from the
// first, until it has worked for the time asked for and has seen each function; then closes its
// input and waits for its end. Throws std::system_error where it cannot be started.
BusyRun keep_busy(const std::vector<std::string>& command, const std::vector<TestCase>& cases,
                  const BusySettings& settings);

}  // namespace tribo::conformance
