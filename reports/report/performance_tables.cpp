// SPDX-License-Identifier: Apache-2.0
#include "report/performance_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "report/baselines.hpp"
#include "report/number_text.hpp"
#include "tribo/batch.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::report {
namespace {

using Json = nlohmann::json;

constexpr std::size_t count = 10000;  // speeds of each scene, log-spaced over its range

std::vector<double> speeds_of(const SolvedCase& one) {
  Speeds speeds;
  speeds.from = one.range.low;
  speeds.to = one.range.high;
  speeds.count = count;
  speeds.spacing = Spacing::log;
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = speeds[i];
  return all;
}

// Steps of the roots with neither λ = λ₀ nor λ = λ_b known beforehand.
std::uint64_t steps_without_skips(const MixedContact<double>& contact,
                                  const std::vector<double>& speeds) {
  detail::SharingSurface surface = contact.sharing().surface();
  surface.film_from = std::numeric_limits<double>::infinity();
  surface.floor_up_to = 0;
  std::uint64_t steps = 0;
  for (const double speed : speeds)
    steps += static_cast<std::uint64_t>(
        detail::film_parameter(surface, contact.flooded_film_parameter(speed)).iterations);
  return steps;
}

struct Asked {
  const char* name;
  OutputSet outputs;
};

OutputSet set_of(std::initializer_list<Output> outputs) {
  OutputSet set;
  for (const Output output : outputs) set.insert(output);
  return set;
}

// Moments, of the root, the shares and the outputs, and starvation ratios that were computed; and
// what the same set would take if every point took every step.
std::vector<std::string> skip_row(const SolvedCase& one, const std::vector<double>& speeds,
                                  std::uint64_t all_steps, const Asked& asked) {
  OperatingPoints points;
  points.resize(speeds.size(), asked.outputs);
  WorkCounts work;
  solve(one.contact, speeds, asked.outputs, points, work);
  const std::uint64_t done = work[Work::root_step] + work[Work::share] + work[Work::moment];
  const std::uint64_t full = all_steps + 3 * count;  // a share and two moments a point
  const auto percent = [](std::uint64_t part, std::uint64_t whole) {
    return fmt::format("{:.0f} %", 100 * static_cast<double>(part) / static_cast<double>(whole));
  };
  return {one.source.stem(),
          asked.name,
          std::to_string(work[Work::root_step]),
          std::to_string(work[Work::root_is_film]),
          std::to_string(work[Work::root_is_floor]),
          std::to_string(work[Work::share_not_asked] + work[Work::share_is_nothing]),
          std::to_string(count - work[Work::starvation]),
          percent(full - std::min(full, done), full)};
}

TextTable skip_table(const std::vector<SolvedCase>& solved) {
  const std::vector<Asked> requests{
      {"all outputs", OutputSet::all()},
      {"`film`", set_of({Output::film})},
      {"`fluid_load_share`, `regime`", set_of({Output::fluid_load_share, Output::regime})},
      {"`real_area_ratio`", set_of({Output::real_area_ratio})}};
  TextTable table{
      "What a scene does not ask for is not computed",
      {"scene", "asked", "root steps", "roots skipped: λ = λ₀", "roots skipped: λ = λ_b",
       "load shares skipped", "starvation skipped", "moments saved"},
      {false, false, true, true, true, true, true, true},
      {},
      fmt::format("{} speeds over each scene's range, counted by the model itself. A root is λ₀ or "
                  "λ_b to half an ulp where a bound proves it. Starvation is skipped past a "
                  "collapse too. Saved are evaluations of F_n: of those that all outputs take with "
                  "every root iterated.",
                  count)};
  for (const SolvedCase& one : solved) {
    const std::vector<double> speeds = speeds_of(one);
    const std::uint64_t all_steps = steps_without_skips(one.contact, speeds);
    for (const Asked& asked : requests)
      table.rows.push_back(skip_row(one, speeds, all_steps, asked));
  }
  return table;
}

// The fastest row of each family and job that failed nowhere.
TextTable speed_table(const ReportPlaces& places) {
  TextTable table{"The fastest way of each family that fails nowhere, and its true error",
                  {"job", "family", "way", "time, ns", "worst error, ulp", "evaluations of F"},
                  {false, false, false, true, true, true},
                  {},
                  {}};
  const Baseline baseline = read_baseline(places, "work_precision.json");
  if (!baseline.missing.empty()) {
    table.note = baseline.missing + "; `make work-precision` writes it.";
    return table;
  }
  std::vector<std::pair<std::string, std::string>> order;
  std::map<std::pair<std::string, std::string>, const Json*> fastest;
  for (const Json& row : baseline.content.at("error_against_work")) {
    if (row.at("failures").get<double>() > 0) continue;
    const std::pair key(row.at("job").get<std::string>(), row.at("family").get<std::string>());
    const auto [place, is_new] = fastest.try_emplace(key, &row);
    if (is_new) order.push_back(key);
    if (row.at("ns").get<double>() < place->second->at("ns").get<double>()) place->second = &row;
  }
  const auto number = [](const Json& value) {
    return value.is_number() ? rounded(value.get<double>(), 3) : std::string("–");
  };
  for (const auto& key : order) {
    const Json& row = *fastest.at(key);
    table.rows.push_back({fmt::format("`{}`", key.first), key.second,
                          row.at("name").get<std::string>(), number(row.at("ns")),
                          number(row.at("max_ulp")), number(row.at("evaluations"))});
  }
  table.note = fmt::format(
      "A failure is no number, or an error above 1e-6. Diagrams of error against time: `make "
      "work-precision`. {}",
      provenance(baseline.content));
  return table;
}

}  // namespace

std::vector<TextTable> performance_tables(const ReportPlaces& places,
                                          const std::vector<SolvedCase>& solved) {
  return {made_or_excused("Skipped work", [&] { return skip_table(solved); }),
          made_or_excused("Speed", [&] { return speed_table(places); })};
}

}  // namespace tribo::report
