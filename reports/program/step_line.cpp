// SPDX-License-Identifier: Apache-2.0
#include "step_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "tribo/scene_reader.hpp"

namespace tribo::cli {

StepLine::StepLine(std::chrono::milliseconds first, std::chrono::milliseconds between)
    : watched_(::isatty(STDERR_FILENO) != 0), between_(between), next_(Clock::now() + first) {}

void StepLine::show(std::string_view step) {
  if (!is_due()) return;
  next_ = Clock::now() + between_;
  shown_ = true;
  const std::string line = fmt::format("\r{}\033[K", printable(step, std::string::npos));
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void StepLine::wipe() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace tribo::cli
