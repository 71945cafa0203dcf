// SPDX-License-Identifier: Apache-2.0
#include "page/work_precision_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "page/number_text.hpp"
#include "page/work_precision.hpp"

namespace tribo::report {
namespace {

constexpr const char* file = "work_precision.json";

std::string or_dash(double value) { return std::isnan(value) ? "–" : rounded(value, 3); }

TextTable speed_table(const Json& baseline) {
  TextTable table{
      "The fastest way of each family that fails nowhere, and its true error",
      {"job", "family", "way", "time a point, ns", "times ours", "worst error, ulp",
       "evaluations of F~n~"},
      {false, false, false, true, true, true, true},
      {},
      "What counts as a failure, and at which points a job is timed and judged, stands in "
      "`benchmarks/README.md`."};
  for (const std::string& job : jobs(baseline)) {
    const std::vector<Way> ways = fastest_ways(baseline, job);
    const Way* ours = contest(ways).ours;
    for (const Way& way : ways)
      table.rows.push_back({job_name(job), way.family, fmt::format("`{}`", way.name),
                            rounded(way.ns, 3),
                            ours == nullptr ? "–" : rounded(way.ns / ours->ns, 3),
                            rounded(way.max_ulp, 3), or_dash(way.evaluations)});
  }
  return table;
}

// How many times our time the fastest other way takes, over the jobs.
Verdict verdict(const Json& baseline) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  std::size_t compared = 0, less_exact = 0;
  for (const std::string& job : jobs(baseline)) {
    const std::vector<Way> ways = fastest_ways(baseline, job);
    const auto [ours, other] = contest(ways);
    if (ours == nullptr || other == nullptr) continue;
    ++compared;
    less_exact += other->max_ulp > ours->max_ulp ? 1 : 0;
    least = std::min(least, other->ns / ours->ns);
    greatest = std::max(greatest, other->ns / ours->ns);
  }
  if (compared == 0)
    return {Standing::absent, "Speed", "No job has both our way and another that fails nowhere."};
  return {
      Standing::measured, "Speed",
      fmt::format("The fastest other way that fails nowhere takes {} to {} times our time over {} "
                  "jobs, and is less exact in {}. {}",
                  rounded(least, 3), rounded(greatest, 3), compared, less_exact,
                  measured_when(baseline))};
}

void fill(Section& section, const Json& baseline) {
  section.paragraphs = {
      "Every way of doing a job was timed in one process and judged against certified values, from "
      "its coarsest setting to its finest. " +
      provenance(baseline)};
  section.tables = {speed_table(baseline)};
  section.data = work_precision_data(baseline);
  section.figures = work_precision_figures(baseline);
  section.verdicts = {verdict(baseline)};
}

}  // namespace

Section work_precision_section(const ReportPlaces& places) {
  return from_baseline({"work-precision", "Work and precision"}, places, file, fill);
}

}  // namespace tribo::report
