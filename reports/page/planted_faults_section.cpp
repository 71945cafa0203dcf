// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <vector>

#include "page/baselines.hpp"
#include "page/number_text.hpp"
#include "page/verification_sections.hpp"

namespace tribo::report {
namespace {

constexpr const char* file = "planted_faults.json";

std::vector<std::string> row(const Json& fault) {
  const bool is_caught = fault.at("caught").get<bool>();
  return {fmt::format("`{}`", fault.at("id").get<std::string>()),
          fault.at("fault").get<std::string>(),
          is_caught ? "caught" : fmt::format("SURVIVED: {}", fault.at("said").get<std::string>()),
          fmt::format("`{}`", fault.at("check").get<std::string>()),
          fmt::format("`{}`", fault.at("file").get<std::string>()),
          rounded(fault.at("seconds").get<double>(), 3)};
}

void fill(Section& section, const Json& baseline) {
  TextTable table{"Faults planted in the tree, and the check that caught each",
                  {"id", "fault", "verdict", "check", "in", "time, s"},
                  {false, false, false, false, false, true},
                  {},
                  "The time is that of building and running the check."};
  std::size_t caught = 0;
  for (const bool is_caught : {false, true})  // survivors on top
    for (const Json& fault : baseline.at("faults"))
      if (fault.at("caught").get<bool>() == is_caught) {
        table.rows.push_back(row(fault));
        caught += is_caught ? 1 : 0;
      }
  const std::size_t all = table.rows.size();
  section.verdicts = {{all > 0 && caught == all ? Standing::holds : Standing::fails, section.title,
                       fmt::format("{} of {} faults planted in the formulas and in the checks "
                                   "themselves turned a check red. The oldest of these runs: {}",
                                   caught, all, measured_when(baseline))}};
  section.paragraphs = {fmt::format(
      "Each fault is a patch on a scratch copy of the tree, and names the check that has to turn "
      "red: {} of {} were caught. Each has the verdict of its last run; of the oldest: {}",
      caught, all, provenance(baseline))};
  if (baseline.at("catalogue").get<std::size_t>() > all)
    section.not_run.push_back({"planted faults",
                               fmt::format("{} of the {} in the catalogue were planted", all,
                                           baseline.at("catalogue").get<std::size_t>()),
                               target_of(file)});
  section.tables = {std::move(table)};
}

}  // namespace

Section planted_faults_section(const ReportPlaces& places) {
  return from_baseline({"planted-faults", "Planted faults"}, places, file, fill);
}

}  // namespace tribo::report
