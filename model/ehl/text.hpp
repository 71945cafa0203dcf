// SPDX-License-Identifier: Apache-2.0
// Messages of the solvers, in printf()'s formats. A longer message is cut to 299 bytes.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace tribo::ehl {

template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 300> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

}  // namespace tribo::ehl
