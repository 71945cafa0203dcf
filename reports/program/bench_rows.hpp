// SPDX-License-Identifier: Apache-2.0
// The rows of `tribocheck bench`, from tribocheck_bench or from the timing of solvers, and their
// comparison with a baseline. A baseline is a file of earlier numbers that users commit as a gate
// for their CI. Work and accuracy are compared on any machine. Times are divided by the control's
// time of the same run, and compared only if processor and compiler are those of the baseline. The
// times of two solvers in one run are compared on any machine.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "messages.hpp"

namespace tribo::cli {

// "g++ 12.2.0", of this program.
std::string compiler_name();

// The median of measured ratios, and an interval that holds the true median in 95 of 100 samples.
struct Ratio {
  double median, low, high;
};

// The interval comes from ranks, so that no distribution of the numbers is assumed. `ratios` must
// not be empty.
Ratio ratio_of(std::vector<double> ratios);

struct BenchRow {
  std::string job;
  std::string family;
  std::string name;
  double ns;                         // CPU time per point, the median of the repetitions
  double least_ns;                   // the least of the repetitions
  std::optional<double> ratio = {};  // ns over that of the job's fastest tribocheck row
  // Empty if nothing was judged. Failures are cases without a number or off by more than 1e-6 times
  // their condition; the ulp values are true errors of the cases that are numbers.
  std::optional<double> judged = {}, failures = {}, max_ulp = {}, p99_ulp = {}, mean_ulp = {};
  std::optional<double> evaluations = {};  // of integrand or moment, a point; empty: not counted
  // Only rows of solvers have the members below.
  std::optional<Ratio> over_control = {};  // each lap's time over the control's beside it
  std::optional<Ratio> over_base = {};     // each lap's time over the second solver's
  std::optional<double> wall_ns = {};      // wall time of a case; shown, not compared
  std::optional<double> cases = {};        // that have an answer
  std::string measured = {};               // how the time is known, over which control

  std::string key() const { return job + '/' + family + '/' + name; }
};

struct BenchJob {
  std::string title;
  std::vector<BenchRow> rows;
};

struct BenchResults {
  std::vector<BenchJob> jobs;
  std::vector<std::string> left_out = {};  // contenders that could not run, with the reason
  std::vector<std::string> kept = {};      // a sentence for each row whose solver keeps answers
  bool is_of_solvers = false;              // rows of solvers, not of contenders
  std::string base = {};                   // the second solver; empty: there is only one
};

// The family of the second solver's rows.
inline constexpr const char* base_family = "base";

// From Google Benchmark's JSON with aggregates. Throws std::runtime_error.
BenchResults read_bench_results(const std::string& json);

// Was the row "job/family/name" asked for?
using IsAsked = std::function<bool(const std::string& key)>;

// One line about a row.
struct RowNote {
  std::string key, text;

  std::string line() const { return key.empty() ? text : key + ": " + text; }
};

struct BenchChanges {
  std::vector<RowNote> worse;        // red; without a key: why rows or times are not compared
  std::vector<RowNote> gone;         // red, too: only the baseline or the second solver has them
  std::vector<RowNote> slower;       // red if a second run says so too
  std::vector<RowNote> told;         // slower by more than 5 %, but not enough to be red
  std::vector<RowNote> better;       // may be written into the baseline
  std::vector<RowNote> fresh;        // rows that the baseline or the second solver lacks
  std::vector<std::string> remarks;  // why something is not compared
  std::size_t rows = 0, compared = 0, timed = 0;  // in this run; compared; times compared, too

  bool holds() const { return worse.empty() && gone.empty() && slower.empty(); }
};

// Throws std::runtime_error with one line where this is no baseline of this command and schema.
void check_bench_baseline(const nlohmann::json& baseline);

// Throws nlohmann::json::exception where a row of the baseline is malformed.
BenchChanges compare(const BenchResults& results, const nlohmann::json& baseline,
                     const IsAsked& is_asked);

// Adds the changes from the second solver to the first.
void compare_with_base(const BenchResults& results, BenchChanges& changes);

// Writes new rows, and each number that became better, into `baseline`. A row in which anything got
// worse or slower is left as it is. Returns a line for each change, and for each row that is left
// because it got worse.
std::vector<std::string> improve(nlohmann::json& baseline, const BenchResults& results);

// The rows of this run as a baseline. Rows that were not asked for are taken over from `before`,
// but without their times if these were measured on another machine. `before` may be null.
nlohmann::json new_bench_baseline(const BenchResults& results, const nlohmann::json& before,
                                  const IsAsked& is_asked);

// Writes the rows with the head of a baseline: schema, version, commit, date and environment. If
// `content` has an environment, it stays, because the times of an earlier run stay.
void write_bench_baseline(const std::string& file, const nlohmann::json& content);

// All that a run of `bench` writes.
struct BenchReport {
  BenchResults results;
  std::optional<BenchChanges> changes = {};  // from the baseline, or from the second solver
  std::string baseline = {};                 // the file; empty: none

  // "PASSED, no worse than speed.json: 3 of 4 rows compared, the times of 3". Needs `changes`.
  std::string verdict() const;
};

// format: "table", "json", "tsv" or "markdown".
void append_bench(Text& to, const BenchReport& report, const std::string& format);
std::string bench_junit(const BenchReport& report);

}  // namespace tribo::cli
