// SPDX-License-Identifier: Apache-2.0
#include "kernels/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace tribo::benchmarks {

void show_progress(std::string_view step) {
  static const bool is_watched = ::isatty(STDERR_FILENO) != 0;
  if (!is_watched) return;
  const std::string line = fmt::format("\r{}\033[K", step);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace tribo::benchmarks
