// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "page/number_text.hpp"
#include "page/work_precision.hpp"

namespace tribo::report {
namespace {

struct Column {
  std::string_view key;   // in the baseline
  std::string_view name;  // in the table, with its unit
};

std::string cell(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? exact(value.get<double>()) : "NaN";
}

std::string line(const Json& row, const std::vector<Column>& columns) {
  std::string text;
  for (const Column& column : columns)
    text += (text.empty() ? "" : "\t") + cell(row.at(column.key));
  return text + '\n';
}

std::string heads(const std::vector<Column>& columns) {
  std::string text;
  for (const Column& column : columns)
    text += fmt::format("{}{}", text.empty() ? "" : "\t", column.name);
  return "# " + text + '\n';
}

// A block for each value of `key`, in the order of the rows, two blank lines between blocks.
template <class IsWanted>
DataFile blocks(const Json& baseline, std::string_view table, std::string_view name,
                std::string_view key, const std::vector<Column>& columns, IsWanted&& is_wanted) {
  std::vector<std::pair<std::string, std::string>> titled;
  for (const Json& row : baseline.at(table)) {
    if (!is_wanted(row)) continue;
    const auto title = row.at(key).get<std::string>();
    auto block = std::find_if(titled.begin(), titled.end(),
                              [&](const auto& one) { return one.first == title; });
    if (block == titled.end()) block = titled.insert(titled.end(), {title, {}});
    block->second += line(row, columns);
  }
  std::string text =
      fmt::format("# reference/baselines/work_precision.json, {}\n{}", table, heads(columns));
  for (std::size_t i = 0; i < titled.size(); ++i)
    text += fmt::format("{}\"{}\"\n{}", i == 0 ? "" : "\n\n", titled[i].first, titled[i].second);
  return {fmt::format("data/work_precision/{}.blocks.tsv", name), std::move(text)};
}

}  // namespace

std::vector<DataFile> work_precision_data(const Json& baseline) {
  const auto every = [](const Json&) { return true; };
  std::vector<DataFile> files;
  for (const std::string& job : jobs(baseline))
    files.push_back(blocks(baseline, "error_against_work", job, "series",
                           {{"job", "job"},
                            {"family", "family"},
                            {"series", "series"},
                            {"name", "way"},
                            {"ns", "CPU time a point [ns]"},
                            {"evaluations", "evaluations a point"},
                            {"max_ulp", "greatest error [ulp]"},
                            {"p99_ulp", "99th percentile of the error [ulp]"},
                            {"mean_ulp", "mean error [ulp]"},
                            {"failures", "failures"},
                            {"no_numbers", "no numbers"},
                            {"judged", "cases judged"}},
                           [&](const Json& row) { return row.at("job") == job; }));
  files.push_back(blocks(
      baseline, "performance_profile", "profile", "solver",
      {{"solver", "solver"}, {"tau", "times the best time"}, {"fraction", "fraction solved"}},
      every));
  files.push_back(blocks(baseline, "throughput_by_size", "by_size", "kernel",
                         {{"kernel", "kernel"},
                          {"points", "points"},
                          {"ns", "time a point [ns]"},
                          {"points_per_second", "points a second [1/s]"},
                          {"bytes", "bytes a point"},
                          {"gigabytes_per_second", "read and written [GB/s]"},
                          {"share_of_copy", "share of a copy"}},
                         every));
  files.push_back(blocks(baseline, "throughput_by_threads", "by_threads", "kernel",
                         {{"kernel", "kernel"},
                          {"threads", "threads"},
                          {"points_per_second", "points a second [1/s]"},
                          {"gigabytes_per_second", "read and written [GB/s]"},
                          {"speedup", "speed-up"}},
                         every));
  return files;
}

}  // namespace tribo::report
