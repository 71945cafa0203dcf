// SPDX-License-Identifier: Apache-2.0
#include "bench_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "protocol/bounded_json.hpp"

namespace tribo::cli {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> optional_number(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::nullopt : std::optional(found->get<double>());
}

// The row of "job/family/name". The name ends in /manual_time if another process was timed.
BenchRow row_of(const Json& run) {
  const std::string whole = run.at("run_name");
  const std::size_t job_end = whole.find('/');
  const std::size_t family_end = whole.find('/', job_end + 1);
  if (job_end == std::string::npos || family_end == std::string::npos)
    throw std::runtime_error("tribocheck_bench: unexpected name " + whole);
  std::string name = whole.substr(family_end + 1);
  constexpr std::string_view elsewhere = "/manual_time";
  const bool is_elsewhere = name.ends_with(elsewhere);
  if (is_elsewhere) name.resize(name.size() - elsewhere.size());
  const double time = run.at(is_elsewhere ? "real_time" : "cpu_time");
  const double time_a_point = time / run.at("points").get<double>();
  return {whole.substr(0, job_end),
          whole.substr(job_end + 1, family_end - job_end - 1),
          name,
          time_a_point,
          time_a_point,
          std::nullopt,
          optional_number(run, "judged"),
          optional_number(run, "failures"),
          optional_number(run, "max_ulp"),
          optional_number(run, "p99_ulp"),
          optional_number(run, "mean_ulp"),
          optional_number(run, "evaluations")};
}

void add_ratios(BenchJob& job) {
  std::optional<double> ours;
  for (const BenchRow& row : job.rows)
    if (row.family == "tribocheck") ours = std::min(ours.value_or(row.ns), row.ns);
  if (!ours) return;
  for (BenchRow& row : job.rows) row.ratio = row.ns / *ours;
}

}  // namespace

// The interval reaches from rank n/2 − 0.98 √n to n/2 + 0.98 √n of the sorted ratios.
Ratio ratio_of(std::vector<double> ratios) {
  std::sort(ratios.begin(), ratios.end());
  const auto count = static_cast<double>(ratios.size());
  const auto below = static_cast<std::size_t>(std::max(0.0, (count - 1.96 * std::sqrt(count)) / 2));
  const std::size_t middle = ratios.size() / 2;
  const double median =
      ratios.size() % 2 == 1 ? ratios[middle] : (ratios[middle - 1] + ratios[middle]) / 2;
  return {median, ratios[below], ratios[ratios.size() - 1 - below]};
}

BenchResults read_bench_results(const std::string& json) {
  // If all values are 0, their coefficient of variation is undefined, and Google Benchmark writes
  // NaN.
  const Json all = protocol::parse_bounded_json<Json>(
      std::regex_replace(json, std::regex(R"(: -?(NaN|Infinity))"), ": null"));
  if (all.is_discarded()) throw std::runtime_error("tribocheck_bench printed no JSON");
  BenchResults results;
  std::vector<Json> runs = all.at("benchmarks");
  // Runs come interleaved. They are put into the order in which they were registered.
  std::stable_sort(runs.begin(), runs.end(), [](const Json& a, const Json& b) {
    return a.at("family_index").get<int>() < b.at("family_index").get<int>();
  });
  std::map<std::string, double> least;  // of the repetitions, by key
  for (const Json& run : runs) {
    if (run.value("error_occurred", false)) {
      const std::string line =
          run.at("run_name").get<std::string>() + ": " + run.at("error_message").get<std::string>();
      if (std::find(results.left_out.begin(), results.left_out.end(), line) ==
          results.left_out.end())
        results.left_out.push_back(line);
      continue;
    }
    const bool is_repetition = run.value("run_type", "") == "iteration";
    if (!is_repetition && run.value("aggregate_name", "") != "median") continue;
    BenchRow row = row_of(run);
    if (is_repetition) {
      double& least_ns = least.try_emplace(row.key(), row.ns).first->second;
      least_ns = std::min(least_ns, row.ns);
      continue;
    }
    const auto same_job = std::find_if(results.jobs.begin(), results.jobs.end(),
                                       [&](const BenchJob& j) { return j.rows[0].job == row.job; });
    if (same_job != results.jobs.end())
      same_job->rows.push_back(std::move(row));
    else
      results.jobs.push_back({all.at("context").value(row.job, row.job), {std::move(row)}});
  }
  for (BenchJob& job : results.jobs) {
    add_ratios(job);
    for (BenchRow& row : job.rows)
      if (const auto found = least.find(row.key()); found != least.end())
        row.least_ns = found->second;
  }
  return results;
}

}  // namespace tribo::cli
