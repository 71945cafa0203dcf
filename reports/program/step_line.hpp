// SPDX-License-Identifier: Apache-2.0
// One line on stderr that each step overwrites, where a person watches.
#pragma once

#include <chrono>
#include <string_view>

namespace tribo::cli {

class StepLine {
 public:
  // The first line is shown after `first`, and then one at most every `between`.
  explicit StepLine(std::chrono::milliseconds first = {}, std::chrono::milliseconds between = {});
  StepLine(const StepLine&) = delete;
  StepLine& operator=(const StepLine&) = delete;
  ~StepLine() { wipe(); }

  // Would a line be shown now?
  bool is_due() const { return watched_ && Clock::now() >= next_; }
  void show(std::string_view step);
  void wipe();  // before another line is written

 private:
  using Clock = std::chrono::steady_clock;

  bool watched_, shown_ = false;
  std::chrono::milliseconds between_;
  Clock::time_point next_;
};

}  // namespace tribo::cli
