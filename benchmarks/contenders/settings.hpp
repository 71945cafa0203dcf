// SPDX-License-Identifier: Apache-2.0
// At which tolerances, numbers of points and of knots contenders run.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace tribo::benchmarks {

enum class Settings : std::uint8_t {
  usual,  // settings that people write
  swept,  // from coarse to fine, for error against work
};

template <class T>
std::vector<T> chosen(Settings settings, std::initializer_list<T> usual,
                      std::initializer_list<T> swept) {
  return settings == Settings::usual ? usual : swept;
}

}  // namespace tribo::benchmarks
