// SPDX-License-Identifier: Apache-2.0
#include "sweep/needs_text.hpp"

#include <array>
#include <cstdio>

namespace tribo::sweep {

std::string bytes_text(double bytes) {
  std::array<char, 32> text{};
  const double unit = bytes < 1e6 ? 1e3 : bytes < 1e9 ? 1e6 : 1e9;
  const char* const name = bytes < 1e6 ? "kB" : bytes < 1e9 ? "MB" : "GB";
  std::snprintf(text.data(), text.size(), bytes / unit < 999.5 ? "%.3g %s" : "%.0f %s",
                bytes / unit, name);
  return text.data();
}

std::string time_text(double seconds) {
  const auto text = [seconds](const char* form, double unit) {
    std::array<char, 32> written{};
    std::snprintf(written.data(), written.size(), form, seconds / unit);
    return std::string(written.data());
  };
  if (seconds < 99.5) return text("%.2g s", 1);
  if (seconds < 99.5 * 60) return text("%.2g min", 60);
  if (seconds < 2e5) return text("%.2g h", 3600);
  return text(seconds < 999.5 * 86400 ? "%.3g days" : "%.0f days", 86400);
}

}  // namespace tribo::sweep
