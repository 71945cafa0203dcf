// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

#include "bench_rows.hpp"
#include "build_info.hpp"
#include "conformance/conformance_baseline.hpp"

namespace tribo::cli {
namespace {

using nlohmann::json;

constexpr double accuracy_ratchet = 4;  // times the greatest error before, or 1 ulp if that is more
constexpr double time_ratio = 1.10;     // ratio of the medians
constexpr double solver_ratio = 1.12;   // ratio of a solver's lower end to the median before
constexpr double told_ratio = 1.05;     // ratio of the medians
constexpr int oldest_schema = 2, schema = 3;
constexpr std::string_view schema_name = "bench-baseline/";

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
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

constexpr auto time_fields =
    std::to_array<const char*>({"least_over_control", "median_over_control"});

void forget_times(json& row) {
  for (const char* field : time_fields) row[field] = nullptr;
}

// A row of the baseline. Only rows of solvers have the members "cases" and "measured".
json row_json(const BenchRow& row, const std::optional<double>& control) {
  json made{
      {"max_ulp", optional_json(row.max_ulp)},   {"judged", optional_json(row.judged)},
      {"failures", optional_json(row.failures)}, {"evaluations", optional_json(row.evaluations)},
      {"least_over_control", nullptr},           {"median_over_control", nullptr}};
  if (control && row.family != "control") {
    made["least_over_control"] = row.least_ns / *control;
    made["median_over_control"] = row.ns / *control;
  }
  if (row.over_control) {
    made["least_over_control"] = row.over_control->low;
    made["median_over_control"] = row.over_control->median;
  }
  if (row.cases) made["cases"] = *row.cases;
  if (!row.measured.empty()) made["measured"] = row.measured;
  return made;
}

// "12 % slower".
std::string percent_slower(double ratio) {
  return fmt::format("{:.0f} % slower", 100 * (ratio - 1));
}

// The model name of the processor, as "AMD EPYC". AArch64 has numbers in its place: "CPU 0x41
// 0xd0c". "unknown" if /proc/cpuinfo has neither.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  std::string numbers;
  for (std::string line; std::getline(file, line) && !line.empty();) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    if (line.starts_with("CPU implementer") || line.starts_with("CPU part"))
      numbers += line.substr(line.find(':') + 1);
  }
  return numbers.empty() ? "unknown" : "CPU" + numbers;
}

json environment_json() { return {{"processor", processor_name()}, {"compiler", compiler_name()}}; }
bool is_of_this_machine(const json& baseline) {
  return baseline.at("environment") == environment_json();
}

// The comparison of a row with the baseline's row.
class RowComparison {
 public:
  // `compares_times` is false where the control did not run, or where the times of the baseline
  // were measured on another machine.
  RowComparison(const BenchRow& row, const json& before, const std::optional<double>& control,
                bool compares_times)
      : key(row.key()), before_(before), now_(row_json(row, control)) {
    compare_count("evaluations", "evaluations", 1);
    compare_count("failures", "failures", 1);
    compare_count("judged", "judged cases", -1);
    if (row.cases) compare_count("cases", "cases with an answer", -1);
    compare_error();
    // If another number of cases has an answer, the times cannot be compared. The new times are
    // then taken, if `compares_times`.
    const bool has_other_cases = row.cases && *row.cases != before.at("cases");
    if (!compares_times) return;
    if (has_other_cases)
      improved_fields_.insert(improved_fields_.end(), time_fields.begin(), time_fields.end());
    else if (is_measured_alike(row))
      compare_time(row);
  }

  // The baseline's row, updated with the numbers that became better.
  json improved() const {
    json row = before_;
    for (const char* field : improved_fields_) row[field] = now_.at(field);
    return row;
  }

  std::string key;
  std::vector<RowNote> worse, slower, told, better;
  bool any_compared = false, is_timed = false;

 private:
  void note(bool is_worse, const char* field, const std::string& text) {
    (is_worse ? worse : better).push_back({key, text});
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

  bool is_measured_alike(const BenchRow& row) {
    if (row.measured.empty()) return true;
    const std::string was = before_.value("measured", "");
    if (was == row.measured) return true;
    worse.push_back(
        {key, fmt::format("its time was measured as \"{}\", is as \"{}\"; the baseline is to be "
                          "made anew (--update-baseline --force)",
                          was, row.measured)});
    return false;
  }

  // A contender is slower if the intervals from minimum to median do not meet and the median grew
  // by more than a tenth. A solver is slower if its whole interval is above the limit.
  void compare_time(const BenchRow& row) {
    const auto least = optional_number(now_, time_fields[0]),
               median = optional_number(now_, time_fields[1]);
    if (!least || !median) return;  // the row is the control
    const auto was_least = optional_number(before_, time_fields[0]),
               was_median = optional_number(before_, time_fields[1]);
    if (!was_least || !was_median) {
      better.push_back({key, "its time is new"});
      improved_fields_.insert(improved_fields_.end(), time_fields.begin(), time_fields.end());
      return;
    }
    any_compared = is_timed = true;
    const double ratio = *median / *was_median;
    const bool is_of_solver = row.over_control.has_value();
    const bool is_slower = is_of_solver ? *least > solver_ratio * *was_median
                                        : *least > *was_median && ratio > time_ratio;
    const double greatest = is_of_solver ? row.over_control->high : *median;
    const std::string text =
        fmt::format("{:.3g} times the control, was {:.3g}", *median, *was_median);
    if (is_slower)
      slower.push_back({key, text});
    else if (ratio > told_ratio && *least > *was_median)
      told.push_back({key, fmt::format("{}, {}", percent_slower(ratio), text)});
    const double limit = is_of_solver ? *was_median / solver_ratio : *was_least;
    if (greatest < limit && ratio < 1 / time_ratio) {
      better.push_back({key, text});
      improved_fields_.insert(improved_fields_.end(), time_fields.begin(), time_fields.end());
    }
  }

  const json& before_;
  json now_;
  std::vector<const char*> improved_fields_;
};

void add_notes(std::vector<RowNote>& to, const std::vector<RowNote>& notes) {
  to.insert(to.end(), notes.begin(), notes.end());
}

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
    // The names of tribocheck's own rows contain instruction sets, which depend on the processor.
    const bool is_of_processor =
        !is_of_this_machine(baseline) && key.find("/tribocheck/") != std::string::npos;
    if (!is_asked(key))
      ++left_out;
    else if (is_of_processor)
      changes.remarks.push_back(key + ": another processor or compiler has no such row");
    else
      changes.gone.push_back({key, "is gone" + reason_of(key, results)});
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
  // Up to schema 2, "schema" was a number.
  const json& told = baseline.at("schema");
  const bool is_known = told == oldest_schema || told == fmt::format("{}{}", schema_name, schema);
  if (!is_known) throw std::runtime_error(conformance::other_schema_text(baseline, told, schema));
}

BenchChanges compare(const BenchResults& results, const json& baseline, const IsAsked& is_asked) {
  BenchChanges changes;
  const json& rows = baseline.at("rows");
  const std::optional<double> control = control_of(results);
  if (std::string newer = conformance::newer_version_text(baseline); !newer.empty())
    changes.remarks.push_back(std::move(newer));
  const bool is_here = is_of_this_machine(baseline);
  if (!is_here)
    changes.remarks.emplace_back("times are not comparable: another processor or compiler");
  else if (!control && !results.is_of_solvers)
    changes.worse.push_back({"", "the control did not run, so that no times are compared"});
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      ++changes.rows;
      if (!rows.contains(row.key())) {
        changes.fresh.push_back({row.key(), "is new"});
        continue;
      }
      const bool has_control = row.over_control || control;
      const RowComparison one(row, rows.at(row.key()), control, is_here && has_control);
      changes.compared += one.any_compared ? 1 : 0;
      changes.timed += one.is_timed ? 1 : 0;
      add_notes(changes.worse, one.worse);
      add_notes(changes.slower, one.slower);
      add_notes(changes.told, one.told);
      add_notes(changes.better, one.better);
    }
  note_gone(results, baseline, is_asked, changes);
  if (changes.compared == 0)
    changes.worse.push_back({"", "nothing of this run is in the baseline"});
  return changes;
}

void compare_with_base(const BenchResults& results, BenchChanges& changes) {
  for (const BenchJob& job : results.jobs) {
    const BenchRow *mine = nullptr, *base = nullptr;
    ++changes.rows;
    for (const BenchRow& row : job.rows) (row.family == base_family ? base : mine) = &row;
    if (base == nullptr) {
      changes.fresh.push_back({mine->key(), "the second solver does not offer it"});
      continue;
    }
    if (mine == nullptr) {
      changes.gone.push_back({base->key(), "the first solver does not offer it"});
      continue;
    }
    ++changes.compared;
    if (mine->measured != base->measured) {
      changes.worse.push_back(
          {mine->key(), fmt::format("its time is measured as \"{}\", of the second solver as "
                                    "\"{}\": they cannot be compared",
                                    mine->measured, base->measured)});
      continue;
    }
    if (*mine->cases != *base->cases) {
      (*mine->cases < *base->cases ? changes.worse : changes.better)
          .push_back({mine->key(), fmt::format("cases with an answer are {}, of the second solver "
                                               "{}, so that their times are not compared",
                                               *mine->cases, *base->cases)});
      continue;
    }
    ++changes.timed;
    const Ratio& ratio = *mine->over_base;
    const std::string text = fmt::format("{:.3g} times the second solver's time ({:.3g} to {:.3g})",
                                         ratio.median, ratio.low, ratio.high);
    if (ratio.low > solver_ratio)
      changes.slower.push_back({mine->key(), text});
    else if (ratio.median > told_ratio && ratio.low > 1)
      changes.told.push_back(
          {mine->key(), fmt::format("{}, {}", percent_slower(ratio.median), text)});
    else if (ratio.high < 1 / time_ratio)
      changes.better.push_back({mine->key(), text});
  }
}

std::vector<std::string> improve(json& baseline, const BenchResults& results) {
  std::vector<std::string> said;
  const bool is_here = is_of_this_machine(baseline);
  const std::optional<double> control = is_here ? control_of(results) : std::nullopt;
  json& rows = baseline.at("rows");
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      const std::string key = row.key();
      if (!rows.contains(key)) {
        rows[key] = row_json(row, control);
        if (!is_here) forget_times(rows[key]);
        said.push_back("baseline improved: " + key + ": is new");
        continue;
      }
      const json before = rows.at(key);
      const RowComparison one(row, before, control, is_here && (row.over_control || control));
      if (one.worse.empty() && one.slower.empty()) {
        rows[key] = one.improved();
        if (!is_here && row.cases && *row.cases != before.at("cases")) forget_times(rows[key]);
        for (const RowNote& note : one.better) said.push_back("baseline improved: " + note.line());
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
      if (!keeps_times) forget_times(rows[key]);
    }
  }
  const std::optional<double> control = control_of(results);
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) rows[row.key()] = row_json(row, control);
  return {{"rows", std::move(rows)}};
}

void write_bench_baseline(const std::string& file, const json& content) {
  const nlohmann::ordered_json all =
      document(fmt::format("{}{}", schema_name, schema),
               {{"commit", program_commit()},
                {"date", today()},
                {"environment",
                 content.contains("environment") ? content.at("environment") : environment_json()},
                {"rows", content.at("rows")}});
  report::write_file(file, all.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace tribo::cli
