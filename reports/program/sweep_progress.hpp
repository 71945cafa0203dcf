// SPDX-License-Identifier: Apache-2.0
// How far a sweep is, on stderr: a line that is rewritten on a terminal, nothing in a pipe, and a
// line a minute where stderr is a file or anything else that is read later.
#pragma once

#include <chrono>
#include <cstdint>

#include "sweep/run.hpp"

namespace tribo::cli {

class SweepProgress {
 public:
  explicit SweepProgress(double points_a_chunk);
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;
  ~SweepProgress() { wipe(); }

  void show(const sweep::RunProgress& progress);
  void wipe();  // before another line is written

 private:
  using Clock = std::chrono::steady_clock;
  enum class Kind : std::uint8_t { terminal, pipe, log };

  static Kind kind_of_stderr();

  Kind kind_ = kind_of_stderr();
  double points_a_chunk_;
  sweep::RunProgress::Phase phase_ = sweep::RunProgress::Phase::computing;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace tribo::cli
