// SPDX-License-Identifier: Apache-2.0
#include "page/baselines.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "protocol/bounded_json.hpp"

namespace tribo::report {

Json read_baseline(const ReportPlaces& places, std::string_view file) {
  const auto path = places.reference / "baselines" / file;
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error(fmt::format("`{}` is not there", places.shown(path)));
  Json content;
  try {
    content = protocol::read_bounded_json<Json>(stream);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("`{}`: {}", places.shown(path), error.what()));
  }
  if (content.is_discarded())
    throw std::runtime_error(fmt::format("`{}` is not JSON", places.shown(path)));
  return content;
}

std::runtime_error of_another_shape(const ReportPlaces& places, std::string_view file,
                                    const std::exception& error) {
  return std::runtime_error(fmt::format("`{}` has another shape: {}",
                                        places.shown(places.reference / "baselines" / file),
                                        error.what()));
}

Json run_of(const Json& baseline) {
  Json run;
  copy<std::string>(baseline, {"commit", "date"}, run);
  if (baseline.contains("seconds")) copy<double>(baseline, {"seconds"}, run);
  copy<std::string>(baseline.at("environment"), {"cpu", "compiler"}, run["environment"]);
  return run;
}

void add_missing(Group& group, const BaselinePart& part, const std::string& why) {
  group.data[std::string(part.key)] = {{"missing", why}};
  for (const BaselineKind& kind : baseline_kinds)
    if (kind.file == part.file)
      group.not_run.push_back({std::string(part.what), why, fmt::format("`make {}`", kind.target)});
}

}  // namespace tribo::report
