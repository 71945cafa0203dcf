// SPDX-License-Identifier: Apache-2.0
#include "page/section.hpp"

#include <fmt/format.h>

namespace tribo::report {

Section excused(Section empty, const std::string& why, const std::string& how_to) {
  empty.paragraphs.push_back(fmt::format("Not here: {}. {} makes it.", why, how_to));
  empty.verdicts.push_back({Standing::absent, empty.title, why + "."});
  empty.not_run.push_back({empty.title, why, how_to});
  return empty;
}

}  // namespace tribo::report
