// SPDX-License-Identifier: Apache-2.0
// Names that the writer and the reader of results share.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace tribo::sweep {

inline constexpr std::string_view result_format = "tribocheck sweep 2";

// "onset.film_maximum.speed" lies at onset/film_maximum/speed.
inline std::string path_of_column(std::string name) {
  std::replace(name.begin(), name.end(), '.', '/');
  return name;
}

}  // namespace tribo::sweep
