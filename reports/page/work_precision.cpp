// SPDX-License-Identifier: Apache-2.0
// Ways of doing a job, timed and judged: which is the fastest, and the tables for gnuplot.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "page/baselines.hpp"
#include "page/groups.hpp"
#include "page/number_text.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

constexpr std::string_view our_family = "tribocheck";

// Files and figures are named after jobs.
void check_name(const std::string& job) {
  const bool is_plain = !job.empty() && std::all_of(job.begin(), job.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (is_plain) return;
  throw std::runtime_error(
      fmt::format("work_precision.json: the job \"{}\" is not named by letters, digits and _ alone",
                  printable(job)));
}

std::vector<std::string> jobs_of(const Json& baseline) {
  std::vector<std::string> found;
  for (const Json& row : baseline.at("error_against_work")) {
    const auto job = row.at("job").get<std::string>();
    if (std::find(found.begin(), found.end(), job) != found.end()) continue;
    check_name(job);
    found.push_back(job);
  }
  return found;
}

// The element of an array with this value under `key`; null: there is none.
Json* find(Json& array, const char* key, const Json& value) {
  const auto found = std::find_if(array.begin(), array.end(),
                                  [&](const Json& one) { return one.at(key) == value; });
  return found == array.end() ? nullptr : &*found;
}

// The fastest of each family's ways that were judged and failed nowhere, as the file orders them.
Json fastest_ways(const Json& baseline, const std::string& job) {
  Json ways = Json::array();
  for (const Json& row : baseline.at("error_against_work")) {
    if (row.at("job") != job || row.at("failures").get<double>() > 0 ||
        !row.at("max_ulp").is_number())
      continue;
    Json way;
    copy<std::string>(row, {"family", "name"}, way);
    copy<double>(row, {"ns", "max_ulp"}, way);
    way["evaluations"] = number_or_null(row.at("evaluations"));
    Json* const same = find(ways, "family", way["family"]);
    if (same == nullptr)
      ways.push_back(std::move(way));
    else if (way["ns"] < (*same)["ns"])
      *same = std::move(way);
  }
  return ways;
}

// Are evaluations counted in this job for any family but ours?
bool is_counted(const Json& baseline, const std::string& job) {
  const Json& rows = baseline.at("error_against_work");
  return std::any_of(rows.begin(), rows.end(), [&](const Json& row) {
    return row.at("job") == job && row.at("family") != our_family &&
           row.at("evaluations").is_number();
  });
}

// The fastest ways beside ours, and the fastest alternative.
Json job_json(const Json& baseline, const std::string& job) {
  Json ways = fastest_ways(baseline, job);
  const Json* const ours = find(ways, "family", our_family);
  const Json best = ours == nullptr ? Json() : *ours;
  Json alternative;
  for (Json& way : ways) {
    way["times_ours"] =
        best.is_null() ? Json() : Json(way["ns"].get<double>() / best["ns"].get<double>());
    if (way["family"] != our_family && (alternative.is_null() || way["ns"] < alternative["ns"]))
      alternative = way;
  }
  return {{"job", job},
          {"ours", best},
          {"fastest_alternative", std::move(alternative)},
          {"is_counted", is_counted(baseline, job)},
          {"ways", std::move(ways)}};
}

// How many times as long as ours the fastest alternative takes, over the jobs that have both.
Json contest(const Json& jobs) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  std::size_t compared = 0, less_exact = 0;
  for (const Json& job : jobs) {
    const Json& ours = job["ours"];
    const Json& other = job["fastest_alternative"];
    if (ours.is_null() || other.is_null()) continue;
    ++compared;
    less_exact += other["max_ulp"] > ours["max_ulp"] ? 1 : 0;
    least = std::min(least, other["times_ours"].get<double>());
    greatest = std::max(greatest, other["times_ours"].get<double>());
  }
  return {{"jobs", compared},
          {"less_exact", less_exact},
          {"least_times_ours", compared > 0 ? Json(least) : Json()},
          {"greatest_times_ours", compared > 0 ? Json(greatest) : Json()}};
}

struct Column {
  std::string_view key;   // in the baseline
  std::string_view name;  // in the table, with its unit
};

// A text of the baseline as a cell, or within quotes.
std::string word(const Json& value) {
  std::string text = printable(value.get<std::string>(), std::string::npos);
  std::replace(text.begin(), text.end(), '"', '\'');
  return text;
}

std::string cell(const Json& value) {
  if (value.is_string()) return word(value);
  return value.is_number() ? exact(value.get<double>()) : "NaN";
}

// A table of blocks, one for each value of `key` in the order of the rows, two blank lines between.
template <class IsWanted>
DataFile blocks(const Json& baseline, std::string_view table, std::string_view name,
                std::string_view key, const std::vector<Column>& columns, IsWanted&& is_wanted) {
  std::vector<std::pair<std::string, std::string>> titled;
  for (const Json& row : baseline.at(table)) {
    if (!is_wanted(row)) continue;
    const std::string title = word(row.at(key));
    auto block = std::find_if(titled.begin(), titled.end(),
                              [&](const auto& one) { return one.first == title; });
    if (block == titled.end()) block = titled.insert(titled.end(), {title, {}});
    for (const Column& column : columns) {
      const char separator = column.key == columns.back().key ? '\n' : '\t';
      block->second += cell(row.at(column.key)) + separator;
    }
  }
  std::string text = fmt::format("# reference/baselines/work_precision.json, {}\n#", table);
  for (const Column& column : columns)
    text += fmt::format("{}{}", column.key == columns.front().key ? " " : "\t", column.name);
  text += '\n';
  for (std::size_t i = 0; i < titled.size(); ++i)
    text += fmt::format("{}\"{}\"\n{}", i == 0 ? "" : "\n\n", titled[i].first, titled[i].second);
  return {fmt::format("data/work_precision/{}.blocks.tsv", name), std::move(text)};
}

std::vector<DataFile> data_files(const Json& baseline) {
  const std::vector<Column> of_ways{{"job", "job"},
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
                                    {"judged", "cases judged"}};
  std::vector<DataFile> files;
  for (const std::string& job : jobs_of(baseline))
    files.push_back(blocks(baseline, "error_against_work", job, "series", of_ways,
                           [&](const Json& row) { return row.at("job") == job; }));
  return files;
}

// Films of line contacts: every way, and how ours and a dense matrix grow.
Json line_film(const Json& baseline) {
  Json found = run_of(baseline.at("line_film_run"));
  found["ways"] = Json::array();
  for (const Json& row : baseline.at("line_film")) {
    Json way;
    copy<std::string>(row, {"family", "name"}, way);
    copy<double>(row, {"ns"}, way);
    for (const char* const key : {"steps", "max_relative", "mean_relative"})
      way[key] = number_or_null(row.at(key));
    copy<int>(row, {"no_numbers", "judged"}, way);
    found["ways"].push_back(std::move(way));
  }
  found["exponents"] = Json::array();
  for (const Json& row : baseline.at("line_film_exponents")) {
    Json one;
    copy<std::string>(row, {"solver", "quantity"}, one);
    copy<double>(row, {"exponent", "uncertainty"}, one);
    copy<int>(row, {"from_cells", "to_cells"}, one);
    found["exponents"].push_back(std::move(one));
  }
  found["largest"] = Json::array();  // grid of each solver
  for (const Json& row : baseline.at("line_film_growth")) {
    Json one;
    copy<std::string>(row, {"solver"}, one);
    copy<double>(row, {"cells", "kernel_ns", "step_ns", "bytes"}, one);
    if (Json* const known = find(found["largest"], "solver", one["solver"]))
      *known = std::move(one);
    else
      found["largest"].push_back(std::move(one));
  }
  return found;
}

std::vector<DataFile> line_film_files(const Json& baseline) {
  const auto every = [](const Json&) { return true; };
  return {blocks(baseline, "line_film", "line_film", "series",
                 {{"job", "job"},
                  {"family", "family"},
                  {"series", "series"},
                  {"name", "way"},
                  {"ns", "CPU time a contact [ns]"},
                  {"steps", "steps of Newton's method a contact"},
                  {"max_relative", "greatest relative error"},
                  {"mean_relative", "mean relative error"},
                  {"no_numbers", "no numbers"},
                  {"judged", "numbers judged"}},
                 every),
          blocks(baseline, "line_film_growth", "line_film_growth", "solver",
                 {{"solver", "solver"},
                  {"cells", "cells"},
                  {"kernel_ns", "CPU time for the matrix of influences [ns]"},
                  {"step_ns", "CPU time of a step of Newton's method [ns]"},
                  {"bytes", "bytes"}},
                 every),
          blocks(baseline, "line_film_exponents", "line_film_exponents", "solver",
                 {{"solver", "solver"},
                  {"quantity", "quantity"},
                  {"exponent", "exponent of the cells"},
                  {"uncertainty", "its standard error"},
                  {"from_cells", "fitted from cells"},
                  {"to_cells", "fitted to cells"}},
                 every)};
}

Group work_precision(const Json& baseline) {
  Group group{run_of(baseline)};
  copy<std::string>(baseline.at("environment"), {"instruction_set"}, group.data["environment"]);
  Json jobs = Json::array();
  for (const std::string& job : jobs_of(baseline)) jobs.push_back(job_json(baseline, job));
  Json found = contest(jobs);
  const bool is_compared = found["jobs"] > 0;
  group.data.update({{"alternatives", std::move(found)},
                     {"jobs", std::move(jobs)},
                     {"line_film", line_film(baseline)}});
  group.files = data_files(baseline);
  for (DataFile& file : line_film_files(baseline)) group.files.push_back(std::move(file));
  group.findings = {{"work_precision", "work-precision", About::software, Standing::measured}};
  if (!is_compared)
    group.findings = {{"work_precision", "work-precision", About::software, Standing::absent,
                       "No job has both our way and an alternative without failures."}};
  return group;
}

}  // namespace

Group work_precision_group(const ReportPlaces& places) {
  return from_baseline(places, "work_precision.json", work_precision);
}

}  // namespace tribo::report
