// SPDX-License-Identifier: Apache-2.0
#include "page/baselines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "page/number_text.hpp"

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

std::runtime_error of_another_shape(const ReportPlaces& places, std::string_view file,
                                    const std::exception& error) {
  return std::runtime_error(fmt::format("`{}` has another shape: {}",
                                        places.shown(places.reference / "baselines" / file),
                                        error.what()));
}

std::string target_of(std::string_view file) {
  for (const BaselineKind& kind : baseline_kinds)
    if (kind.file == file) return fmt::format("`make {}`", kind.target);
  return {};
}

std::string short_commit(const std::string& commit) {
  constexpr std::size_t shown = 12;
  const std::size_t digits = std::min(commit.find_first_not_of("0123456789abcdef"), commit.size());
  return commit.substr(0, std::min(shown, digits)) + commit.substr(digits);
}

std::string measured_when(const Json& baseline) {
  return fmt::format("Measured on {} at commit `{}`.", baseline.at("date").get<std::string>(),
                     short_commit(baseline.at("commit").get<std::string>()));
}

std::string provenance(const Json& baseline) {
  const Json& environment = baseline.at("environment");
  const std::string took =
      baseline.contains("seconds")
          ? fmt::format(", in {} s", rounded(baseline.at("seconds").get<double>(), 3))
          : std::string();
  return fmt::format(
      "Measured on {} at commit `{}`{}; {}; {}.", baseline.at("date").get<std::string>(),
      short_commit(baseline.at("commit").get<std::string>()), took,
      environment.at("cpu").get<std::string>(), environment.at("compiler").get<std::string>());
}

}  // namespace tribo::report
