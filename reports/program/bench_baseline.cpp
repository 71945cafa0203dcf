// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

#include "bench_rows.hpp"

namespace tribo::cli {
namespace {

using nlohmann::json;

constexpr double accuracy_ratchet = 4;  // times the greatest error, or 1 ulp
constexpr double time_ratio = 1.10;     // ratio of the medians
constexpr int schema = 2;

// The control's median; empty where it did not run.
std::optional<double> control_of(const BenchResults& results) {
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows)
      if (row.family == "control") return row.ns;
  return std::nullopt;
}

json optional_json(const std::optional<double>& x) { return x ? json(*x) : json(nullptr); }
std::optional<double> optional_number(const json& row, const char* field) {
  const json& value = row.at(field);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

constexpr auto time_fields =
    std::to_array<const char*>({"least_over_control", "median_over_control"});

json row_json(const BenchRow& row, const std::optional<double>& control) {
  json made{
      {"max_ulp", optional_json(row.max_ulp)},   {"judged", optional_json(row.judged)},
      {"failures", optional_json(row.failures)}, {"evaluations", optional_json(row.evaluations)},
      {"least_over_control", nullptr},           {"median_over_control", nullptr}};
  if (control && row.family != "control") {
    made["least_over_control"] = row.least_ns / *control;
    made["median_over_control"] = row.ns / *control;
  }
  return made;
}

// "AMD EPYC"; "unknown" where the machine does not tell.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

json environment_json() { return {{"processor", processor_name()}, {"compiler", compiler_name()}}; }
bool is_of_this_machine(const json& baseline) {
  return baseline.at("environment") == environment_json();
}

// The comparison of a row with the baseline's row.
class RowComparison {
 public:
  // Without a control times are not compared.
  RowComparison(const BenchRow& row, const json& before, const std::optional<double>& control)
      : key(row.key()), before_(before), now_(row_json(row, control)) {
    compare_count("evaluations", "evaluations", 1);
    compare_count("failures", "failures", 1);
    compare_count("judged", "judged cases", -1);
    compare_error();
    if (control) compare_time();
  }

  // The baseline's row, updated with the numbers that became better.
  json improved() const {
    json row = before_;
    for (const char* field : improved_fields_) row[field] = now_.at(field);
    return row;
  }

  std::string key;
  std::vector<std::string> worse, slower, better;
  bool any_compared = false, is_timed = false;

 private:
  void note(bool is_worse, const char* field, const std::string& text) {
    (is_worse ? worse : better).push_back(key + ": " + text);
    if (!is_worse) improved_fields_.push_back(field);
  }

  // `sign`: 1 where more is worse, −1 where fewer is worse.
  void compare_count(const char* field, const char* words, int sign) {
    const auto was = optional_number(before_, field), is = optional_number(now_, field);
    if (was && !is) return note(true, field, fmt::format("{} were {}, are not told", words, *was));
    if (!was && is) return note(false, field, fmt::format("{} are new: {}", words, *is));
    if (!was) return;
    any_compared = true;
    if (*is != *was)
      note((*is > *was) == (sign > 0), field, fmt::format("{} were {}, are {}", words, *was, *is));
  }

  void compare_error() {
    const auto was = optional_number(before_, "max_ulp"), is = optional_number(now_, "max_ulp");
    if (was && !is)
      return note(true, "max_ulp",
                  fmt::format("the greatest error was {:.3g} ulp, is not known", *was));
    if (!was && is)
      return note(false, "max_ulp", fmt::format("the greatest error is new: {:.3g} ulp", *is));
    if (!was) return;
    any_compared = true;
    const std::string text = fmt::format("the greatest error was {:.3g} ulp, is {:.3g}", *was, *is);
    if (*is > accuracy_ratchet * std::max(1.0, *was))
      note(true, "max_ulp", text);
    else if (*is < *was / accuracy_ratchet)
      note(false, "max_ulp", text);
  }

  // Slower: the intervals from minimum to median do not meet, and the median grew by over a tenth.
  void compare_time() {
    const auto least = optional_number(now_, time_fields[0]),
               median = optional_number(now_, time_fields[1]);
    if (!least || !median) return;  // the row is the control
    const auto was_least = optional_number(before_, time_fields[0]),
               was_median = optional_number(before_, time_fields[1]);
    if (!was_least || !was_median) {
      better.push_back(key + ": its time is new");
      improved_fields_.insert(improved_fields_.end(), time_fields.begin(), time_fields.end());
      return;
    }
    any_compared = is_timed = true;
    const double ratio = *median / *was_median;
    const std::string line =
        fmt::format("{}: {:.3g} times the control, was {:.3g}", key, *median, *was_median);
    if (*least > *was_median && ratio > time_ratio) slower.push_back(line);
    if (*median < *was_least && ratio < 1 / time_ratio) {
      better.push_back(line);
      improved_fields_.insert(improved_fields_.end(), time_fields.begin(), time_fields.end());
    }
  }

  const json& before_;
  json now_;
  std::vector<const char*> improved_fields_;
};

// Why a row of the baseline has no row in this run; empty where the reason is not known.
std::string reason_of(const std::string& key, const BenchResults& results) {
  for (const std::string& line : results.left_out)
    if (line.starts_with(key + ":") || line.starts_with(key + "/"))
      return " (" + line.substr(line.find(": ") + 2) + ")";
  return {};
}

void note_gone(const BenchResults& results, const json& baseline, const IsAsked& is_asked,
               BenchChanges& changes) {
  std::vector<std::string> here;
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) here.push_back(row.key());
  std::size_t left_out = 0;
  for (const auto& [key, row] : baseline.at("rows").items()) {
    if (std::find(here.begin(), here.end(), key) != here.end()) continue;
    // Rows of our own name instruction sets, which depend on the processor.
    const bool is_of_processor =
        !is_of_this_machine(baseline) && key.find("/tribocheck/") != std::string::npos;
    if (!is_asked(key))
      ++left_out;
    else if (is_of_processor)
      changes.remarks.push_back(key + ": another processor or compiler has no such row");
    else
      changes.worse.push_back(key + ": is gone" + reason_of(key, results));
  }
  if (left_out > 0)
    changes.remarks.push_back(
        fmt::format("rows of the baseline that the filter leaves out: {}", left_out));
}

}  // namespace

std::string compiler_name() {
#ifdef __clang__
  return __VERSION__;
#else
  return "g++ " __VERSION__;
#endif
}

void check_bench_baseline(const json& baseline) {
  if (!baseline.is_object() || !baseline.contains("schema") || !baseline.contains("rows") ||
      !baseline.contains("environment"))
    throw std::runtime_error("it is no baseline of `tribocheck bench`");
  if (baseline.at("schema") != schema)
    throw std::runtime_error(fmt::format("it is a baseline of schema {}, and this program has {}",
                                         baseline.at("schema").dump(), schema));
}

BenchChanges compare(const BenchResults& results, const json& baseline, const IsAsked& is_asked) {
  BenchChanges changes;
  const json& rows = baseline.at("rows");
  std::optional<double> control = control_of(results);
  if (!is_of_this_machine(baseline)) {
    control.reset();
    changes.remarks.emplace_back("times are not comparable: another processor or compiler");
  } else if (!control) {
    changes.worse.emplace_back("the control did not run, so that no times are compared");
  }
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      ++changes.rows;
      if (!rows.contains(row.key())) {
        changes.better.push_back(row.key() + ": is new");
        continue;
      }
      const RowComparison one(row, rows.at(row.key()), control);
      changes.compared += one.any_compared ? 1 : 0;
      changes.timed += one.is_timed ? 1 : 0;
      const auto add = [](std::vector<std::string>& to, const std::vector<std::string>& lines) {
        to.insert(to.end(), lines.begin(), lines.end());
      };
      add(changes.worse, one.worse);
      add(changes.slower, one.slower);
      add(changes.better, one.better);
    }
  note_gone(results, baseline, is_asked, changes);
  if (changes.compared == 0) changes.worse.emplace_back("nothing of this run is in the baseline");
  return changes;
}

std::vector<std::string> improve(json& baseline, const BenchResults& results) {
  std::vector<std::string> said;
  const std::optional<double> control =
      is_of_this_machine(baseline) ? control_of(results) : std::nullopt;
  json& rows = baseline.at("rows");
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      const std::string key = row.key();
      if (!rows.contains(key)) {
        rows[key] = row_json(row, control);
        said.push_back("baseline improved: " + key + ": is new");
        continue;
      }
      const json before = rows.at(key);
      const RowComparison one(row, before, control);
      if (one.worse.empty() && one.slower.empty()) {
        rows[key] = one.improved();
        for (const std::string& line : one.better) said.push_back("baseline improved: " + line);
      } else {
        said.push_back("baseline kept: " + key + ": it got worse");
      }
    }
  return said;
}

json new_bench_baseline(const BenchResults& results, const json& before, const IsAsked& is_asked) {
  json rows = json::object();
  if (!before.is_null()) {
    const bool keeps_times = is_of_this_machine(before);
    for (const auto& [key, row] : before.at("rows").items()) {
      if (is_asked(key)) continue;
      rows[key] = row;
      for (const char* field : time_fields)
        if (!keeps_times) rows[key][field] = nullptr;
    }
  }
  const std::optional<double> control = control_of(results);
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) rows[row.key()] = row_json(row, control);
  return {{"schema", schema}, {"environment", environment_json()}, {"rows", std::move(rows)}};
}

}  // namespace tribo::cli
