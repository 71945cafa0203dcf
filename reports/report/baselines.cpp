// SPDX-License-Identifier: Apache-2.0
#include "report/baselines.hpp"

#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "report/number_text.hpp"

namespace tribo::report {

using Json = nlohmann::json;

Baseline read_baseline(const ReportPlaces& places, const char* name) {
  const auto path = places.reference / "baselines" / name;
  std::ifstream file(path);
  if (!file) return {{}, fmt::format("`{}` is not there", places.shown(path))};
  Json content = Json::parse(file, nullptr, false);
  if (content.is_discarded()) return {{}, fmt::format("`{}` is not JSON", places.shown(path))};
  return {std::move(content), {}};
}

std::string provenance(const Json& baseline) {
  const Json& environment = baseline.at("environment");
  const std::string took =
      baseline.contains("seconds")
          ? fmt::format(", in {} s", rounded(baseline.at("seconds").get<double>(), 3))
          : std::string();
  return fmt::format(
      "Measured on {} at commit `{}`{}; {}; {}.", baseline.at("date").get<std::string>(),
      baseline.at("commit").get<std::string>().substr(0, 12), took,
      environment.at("cpu").get<std::string>(), environment.at("compiler").get<std::string>());
}

}  // namespace tribo::report
