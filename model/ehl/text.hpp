// SPDX-License-Identifier: Apache-2.0
// Messages of the solvers, in printf()'s formats.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace tribo::ehl {

template <class... Values>
std::string text(const char* format, Values... values) {
  std::string line(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, values...)), '\0');
  std::snprintf(line.data(), line.size() + 1, format, values...);
  return line;
}

}  // namespace tribo::ehl
