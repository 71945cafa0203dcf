// SPDX-License-Identifier: Apache-2.0
#include "bench_rows.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "protocol/bounded_json.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> optional_number(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::nullopt : std::optional(found->get<double>());
}

// "job/family/name"; /manual_time where the time comes from another process.
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

// Five digits at most, without an exponent below a million.
std::string short_number(double x) {
  if (x >= 1e6) return fmt::format("{:.1e}", x);
  return x >= 1000 ? fmt::format("{:.0f}", x) : fmt::format("{:.3g}", x);
}
std::string cell(const std::optional<double>& x) { return x ? short_number(*x) : "-"; }

struct Field {
  const char* name;
  std::optional<double> (*value)(const BenchRow&);
  bool is_count = false;
};
constexpr Field fields[] = {
    {"ns", [](const BenchRow& r) { return std::optional(r.ns); }},
    {"ratio", [](const BenchRow& r) { return r.ratio; }},
    {"max_ulp", [](const BenchRow& r) { return r.max_ulp; }},
    {"p99_ulp", [](const BenchRow& r) { return r.p99_ulp; }},
    {"mean_ulp", [](const BenchRow& r) { return r.mean_ulp; }},
    {"evaluations", [](const BenchRow& r) { return r.evaluations; }},
    {"failures", [](const BenchRow& r) { return r.failures; }, true},
    {"judged", [](const BenchRow& r) { return r.judged; }, true},
};

}  // namespace

BenchResults read_bench_results(const std::string& json) {
  // A spread of nothing but zeros has no coefficient of variation: Google Benchmark writes it as
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

void append_bench_table(Text& to, const BenchResults& results) {
  bool is_first = true;
  for (const BenchJob& job : results.jobs) {
    if (!is_first) append(to, "\n");
    is_first = false;
    append_title(to, job.title);
    const auto add = [&](const auto&... cells) {
      append(to, fmt::format("{:<14}{:<38}{:>10}{:>9}{:>10}{:>13}{:>11}\n", cells...));
    };
    add("family", "contender", "ns", "ratio", "max ulp", "evaluations", "failures");
    for (const BenchRow& row : job.rows)
      add(row.family, row.name, short_number(row.ns), cell(row.ratio), cell(row.max_ulp),
          cell(row.evaluations),
          row.judged ? fmt::format("{} of {}", *row.failures, *row.judged) : "-");
  }
}

void append_bench_json(Text& to, const BenchResults& results) {
  Json rows = Json::array();
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      Json object{{"job", row.job}, {"family", row.family}, {"name", row.name}};
      for (const Field& field : fields) {
        const std::optional<double> value = field.value(row);
        object[field.name] = !value           ? Json()
                             : field.is_count ? Json(static_cast<long>(*value))
                                              : Json(*value);
      }
      rows.push_back(std::move(object));
    }
  append(to, rows.dump(1));
  append(to, "\n");
}

void append_bench_tsv(Text& to, const BenchResults& results) {
  append(to, "job\tfamily\tname");
  for (const Field& field : fields) append(to, fmt::format("\t{}", field.name));
  append(to, "\n");
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      append(to, fmt::format("{}\t{}\t{}", row.job, row.family, row.name));
      for (const Field& field : fields) {
        const std::optional<double> value = field.value(row);
        append(to, value ? fmt::format("\t{}", *value) : "\t");
      }
      append(to, "\n");
    }
}

}  // namespace tribo::cli
