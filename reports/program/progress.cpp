// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace tribo::cli {

Progress::Progress(std::size_t total, const ProgressStyle& style)
    : style_(style),
      total_(total),
      watched_(::isatty(STDERR_FILENO) != 0 &&
               (style.results_come_at_end || ::isatty(STDOUT_FILENO) == 0)) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show() {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string line =
      fmt::format("\r{} of {} {}, {:.0f} %, {:.3g} a second\033[K", done_, total_, style_.what,
                  100 * static_cast<double>(done_) / static_cast<double>(total_),
                  static_cast<double>(done_) / seconds);
  std::fputs(line.c_str(), stderr);
}

}  // namespace tribo::cli
