// SPDX-License-Identifier: Apache-2.0
// The rows of `tribocheck bench`, from what tribocheck_bench measured.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output.hpp"

namespace tribo::cli {

struct BenchRow {
  std::string job;
  std::string family;
  std::string name;
  double ns;                    // a point: CPU time, the median of the repetitions
  double least_ns;              // and the least of them
  std::optional<double> ratio;  // to the fastest of tribocheck's in this job and run
  // Empty if nothing was judged. Failures are cases without a number or off by more than 1e-6 times
  // their condition; the ulp values are true errors of the cases that are numbers.
  std::optional<double> judged, failures, max_ulp, p99_ulp, mean_ulp;
  std::optional<double> evaluations;  // evaluations of integrand or moment, a point; or empty
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

}  // namespace tribo::cli
