// SPDX-License-Identifier: Apache-2.0
#include "bench_baseline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "page/environment.hpp"

namespace tribo::cli {
namespace {

using nlohmann::json;

constexpr double accuracy_ratchet = 4;  // of the greatest error, or of 1 ulp
constexpr double time_ratio = 1.10;     // of the medians
constexpr int schema = 1;

std::string key_of(const BenchRow& row) { return row.job + '/' + row.family + '/' + row.name; }

// The control's median; none where it was filtered out.
std::optional<double> control_of(const BenchResults& results) {
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows)
      if (row.family == "control") return row.ns;
  return std::nullopt;
}

json optional_json(const std::optional<double>& x) { return x ? json(*x) : json(nullptr); }

json row_json(const BenchRow& row, const std::optional<double>& control) {
  json made{{"max_ulp", optional_json(row.max_ulp)},
            {"failures", optional_json(row.failures)},
            {"evaluations", optional_json(row.evaluations)},
            {"least_over_control", nullptr},
            {"median_over_control", nullptr}};
  if (control) {
    made["least_over_control"] = row.least_ns / *control;
    made["median_over_control"] = row.ns / *control;
  }
  return made;
}

json environment_json() {
  return {{"processor", report::processor_name()}, {"compiler", report::compiler_name()}};
}

// Whether the evaluations, failures and greatest error of a row became better or worse.
void compare_work(const BenchRow& row, const json& before, BenchChanges& changes) {
  const auto was = [&](const char* field) {
    const json& value = before.at(field);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
  };
  const std::string key = key_of(row);
  if (const auto base = was("evaluations"); base && row.evaluations && *base != *row.evaluations)
    (*row.evaluations > *base ? changes.worse : changes.better)
        .push_back(fmt::format("{}: evaluations were {}, are {}", key, *base, *row.evaluations));
  if (const auto base = was("failures"); base && row.failures && *base != *row.failures)
    (*row.failures > *base ? changes.worse : changes.better)
        .push_back(fmt::format("{}: failures were {}, are {}", key, *base, *row.failures));
  const auto base = was("max_ulp");
  if (!base || !row.max_ulp) return;
  if (*row.max_ulp > accuracy_ratchet * std::max(1.0, *base))
    changes.worse.push_back(
        fmt::format("{}: the greatest error was {:.3g} ulp, is {:.3g}", key, *base, *row.max_ulp));
  else if (*row.max_ulp < *base / accuracy_ratchet)
    changes.better.push_back(
        fmt::format("{}: the greatest error was {:.3g} ulp, is {:.3g}", key, *base, *row.max_ulp));
}

// Slower only where the intervals from minimum to median do not meet, and by more than a tenth.
void compare_time(const BenchRow& row, const json& before, double control, BenchChanges& changes) {
  const json& base_least = before.at("least_over_control");
  const json& base_median = before.at("median_over_control");
  if (!base_least.is_number() || !base_median.is_number() || row.family == "control") return;
  const double least = row.least_ns / control, median = row.ns / control;
  const double ratio = median / base_median.get<double>();
  const std::string line = fmt::format("{}: {:.3g} times the control, was {:.3g}", key_of(row),
                                       median, base_median.get<double>());
  if (least > base_median.get<double>() && ratio > time_ratio) changes.slower.push_back(line);
  if (median < base_least.get<double>() && ratio < 1 / time_ratio) changes.better.push_back(line);
}

}  // namespace

BenchChanges compare(const BenchResults& results, const json& baseline) {
  BenchChanges changes;
  const json& rows = baseline.at("rows");
  const std::optional<double> control = control_of(results);
  const bool is_comparable = baseline.at("environment") == environment_json();
  if (!is_comparable)
    changes.remarks.emplace_back("times are not comparable: another processor or compiler");
  else if (!control)
    changes.remarks.emplace_back("times are not compared: the filter leaves out the control");
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      if (!rows.contains(key_of(row))) {
        changes.better.push_back(key_of(row) + ": is new");
        continue;
      }
      const json& before = rows.at(key_of(row));
      compare_work(row, before, changes);
      if (is_comparable && control) compare_time(row, before, *control, changes);
    }
  return changes;
}

json bench_baseline(const BenchResults& results, const json& before) {
  const bool is_other_machine = before.is_null() || before.at("environment") != environment_json();
  json rows = is_other_machine ? json::object() : before.at("rows");
  const std::optional<double> control = control_of(results);
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      const json now = row_json(row, control);
      if (!rows.contains(key_of(row))) {
        rows[key_of(row)] = now;
        continue;
      }
      BenchChanges changes;
      compare_work(row, rows.at(key_of(row)), changes);
      if (control) compare_time(row, rows.at(key_of(row)), *control, changes);
      if (!changes.better.empty() && changes.worse.empty() && changes.slower.empty())
        rows[key_of(row)] = now;
    }
  return {{"schema", schema}, {"environment", environment_json()}, {"rows", std::move(rows)}};
}

}  // namespace tribo::cli
