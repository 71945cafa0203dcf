// SPDX-License-Identifier: Apache-2.0
// Tells on stderr how far a long computation is.
#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

#include "sweep/run.hpp"

namespace tribo::cli {

// A line on stderr that each step overwrites, shown on a terminal only.
class StepLine {
 public:
  // The first line is shown after `first`, and then one at most every `between`.
  StepLine(std::chrono::milliseconds first, std::chrono::milliseconds between);
  StepLine(const StepLine&) = delete;
  StepLine& operator=(const StepLine&) = delete;
  ~StepLine() { wipe(); }

  bool is_watched() const { return watched_; }
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

struct ProgressStyle {
  const char* what = "points";
  std::size_t steps_between_looks = 1024;  // looks at the clock
  bool results_come_at_end = false;        // false: nothing is shown if stdout is a terminal
};

// Counts steps. The count is shown only where nothing else is written to the same terminal, and
// only after a second. Its line is wiped at the end.
class Progress {
 public:
  explicit Progress(std::size_t total, const ProgressStyle& style = {});

  void step() {
    if (++done_ % style_.steps_between_looks == 0 && watched_ && line_.is_due()) show();
  }

 private:
  void show();

  ProgressStyle style_;
  std::size_t total_, done_ = 0;
  bool watched_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  StepLine line_{std::chrono::seconds(1), std::chrono::milliseconds(200)};
};

// Tells once, in a line on stderr, how long all cases will take, if that is more than 10 s. The
// forecast is made from at least 20 answers over at least 3 s.
class Forecast {
 public:
  Forecast(std::size_t total, std::string_view advice) : total_(total), advice_(advice) {}

  void step();

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_, done_ = 0;
  std::string_view advice_;  // ends the line
  Clock::time_point first_ = {};
  bool is_told_ = false;
};

// Shows how far a sweep is. On a terminal one line is rewritten. In a file, or anything else that
// is read later, a line is added each minute. In a pipe nothing is written.
class SweepProgress {
 public:
  explicit SweepProgress(double points_a_chunk) : points_a_chunk_(points_a_chunk) {}

  void show(const sweep::RunProgress& progress);
  void wipe() { line_.wipe(); }  // before another line is written

 private:
  using Clock = std::chrono::steady_clock;

  bool is_due();

  double points_a_chunk_;
  sweep::RunProgress::Phase phase_ = sweep::RunProgress::Phase::computing;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_logged_ = start_ + std::chrono::minutes(1);
  StepLine line_{std::chrono::seconds(1), std::chrono::milliseconds(200)};
};

}  // namespace tribo::cli
