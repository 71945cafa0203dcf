// SPDX-License-Identifier: Apache-2.0
// How far a long computation is, on stderr: only where a person watches it and nothing else is
// written to the same terminal, and only once it has taken a second.
#pragma once

#include <chrono>
#include <cstddef>

namespace tribo::cli {

struct ProgressStyle {
  const char* what = "points";
  std::size_t steps_between_looks = 1024;  // at the clock
  bool results_come_at_end = false;        // else a terminal that gets the results is left alone
};

class Progress {
 public:
  explicit Progress(std::size_t total, const ProgressStyle& style = {});
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  // wipes its line

  void step() {
    if (++done_ % style_.steps_between_looks == 0 && watched_) show();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void show();

  ProgressStyle style_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool watched_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

}  // namespace tribo::cli
