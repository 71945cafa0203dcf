// SPDX-License-Identifier: Apache-2.0
// The rows of `tribocheck bench`, from the measurements of tribocheck_bench, and their comparison
// with a baseline, a file of earlier numbers that users commit: a gate for their CI. Work and
// accuracy are compared on any machine. Times are divided by the control's time of the same run,
// and compared only if processor and compiler are the same as in the baseline.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "messages.hpp"

namespace tribo::cli {

// "g++ 12.2.0", of this program.
std::string compiler_name();

struct BenchRow {
  std::string job;
  std::string family;
  std::string name;
  double ns;                    // a point: CPU time, the median of the repetitions
  double least_ns;              // the least of the repetitions
  std::optional<double> ratio;  // to the fastest of tribocheck's in this job and run
  // Empty if nothing was judged. Failures are cases without a number or off by more than 1e-6 times
  // their condition; the ulp values are true errors of the cases that are numbers.
  std::optional<double> judged, failures, max_ulp, p99_ulp, mean_ulp;
  std::optional<double> evaluations;  // of integrand or moment, a point; empty: not counted

  std::string key() const { return job + '/' + family + '/' + name; }
};

struct BenchJob {
  std::string title;
  std::vector<BenchRow> rows;
};

struct BenchResults {
  std::vector<BenchJob> jobs;
  std::vector<std::string> left_out;  // contenders that could not run, with the reason
};

// From Google Benchmark's JSON with aggregates. Throws std::runtime_error.
BenchResults read_bench_results(const std::string& json);

void append_bench_table(Text& to, const BenchResults& results);
void append_bench_json(Text& to, const BenchResults& results);
void append_bench_tsv(Text& to, const BenchResults& results);

// Was the row "job/family/name" asked for?
using IsAsked = std::function<bool(const std::string& key)>;

struct BenchChanges {
  std::vector<std::string> worse;    // red; rows that are gone, too, or a run that compares no row
  std::vector<std::string> slower;   // red if a second run says so too
  std::vector<std::string> better;   // may be written into the baseline
  std::vector<std::string> remarks;  // why something is not compared
  std::size_t rows = 0, compared = 0, timed = 0;  // in this run; compared; times compared, too
};

// Throws std::runtime_error with one line where this is no baseline of this command and schema.
void check_bench_baseline(const nlohmann::json& baseline);

// Throws nlohmann::json::exception where a row of the baseline is malformed.
BenchChanges compare(const BenchResults& results, const nlohmann::json& baseline,
                     const IsAsked& is_asked);

// Writes what became better into the baseline, number by number, unless the row got worse in
// anything. Returns a line for each change, and for each row that is not written as it got worse.
std::vector<std::string> improve(nlohmann::json& baseline, const BenchResults& results);

// The rows of this run as a baseline. Rows that were not asked for are taken over from `before`,
// without their times where these are of another machine. `before` may be null.
nlohmann::json new_bench_baseline(const BenchResults& results, const nlohmann::json& before,
                                  const IsAsked& is_asked);

}  // namespace tribo::cli
