// SPDX-License-Identifier: Apache-2.0
#include "page/baselines.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace tribo::report {

Json read_baseline(const ReportPlaces& places, std::string_view file) {
  const auto path = places.reference / "baselines" / file;
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error(fmt::format("`{}` is not there", places.shown(path)));
  Json content = Json::parse(stream, nullptr, false);
  if (content.is_discarded())
    throw std::runtime_error(fmt::format("`{}` is not JSON", places.shown(path)));
  return content;
}

}  // namespace tribo::report
