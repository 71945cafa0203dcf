// SPDX-License-Identifier: Apache-2.0
#include "page/work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace tribo::report {
namespace {

constexpr std::string_view our_family = "tribocheck";

double number(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Way way_of(const Json& row) {
  return {row.at("family").get<std::string>(), row.at("name").get<std::string>(),
          row.at("ns").get<double>(), number(row.at("max_ulp")), number(row.at("evaluations"))};
}

}  // namespace

std::vector<Way> fastest_ways(const Json& baseline, const std::string& job) {
  std::vector<Way> ways;
  for (const Json& row : baseline.at("error_against_work")) {
    if (row.at("job") != job || row.at("failures").get<double>() > 0) continue;
    Way way = way_of(row);
    if (std::isnan(way.max_ulp)) continue;
    const auto same = std::find_if(ways.begin(), ways.end(),
                                   [&](const Way& one) { return one.family == way.family; });
    if (same == ways.end())
      ways.push_back(std::move(way));
    else if (way.ns < same->ns)
      *same = std::move(way);
  }
  return ways;
}

Contest contest(const std::vector<Way>& ways) {
  Contest found;
  for (const Way& way : ways) {
    const Way*& best = way.family == our_family ? found.ours : found.other;
    if (best == nullptr || way.ns < best->ns) best = &way;
  }
  return found;
}

std::vector<std::string> jobs(const Json& baseline) {
  std::vector<std::string> found;
  for (const Json& row : baseline.at("error_against_work")) {
    const auto job = row.at("job").get<std::string>();
    if (std::find(found.begin(), found.end(), job) == found.end()) found.push_back(job);
  }
  return found;
}

std::string job_name(const std::string& job) {
  constexpr std::pair<std::string_view, std::string_view> names[] = {
      {"moment_5_2", "moments F~5/2~"},
      {"moment_2", "moments F~2~"},
      {"root_wide", "film parameter, all inputs wide"},
      {"root_one_surface", "film parameter, one surface"},
      {"curve_200", "a Stribeck curve"},
      {"points_1e6", "many operating points of a scene"},
  };
  for (const auto& [key, name] : names)
    if (key == job) return std::string(name);
  return "`" + job + "`";
}

}  // namespace tribo::report
