// SPDX-License-Identifier: Apache-2.0
// tribocheck_work_precision: true error against work, as tables for gnuplot and as a baseline.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "contenders/plugin_way.hpp"
#include "protocol/bounded_json.hpp"
#include "tribo/batch.hpp"
#include "work_precision/measures.hpp"

namespace tribo::benchmarks {
namespace {

struct Arguments {
  std::string out;
  std::string baseline;  // empty: none
  std::string commit = "unknown";
  std::string date = "unknown";
  std::string plugin;  // empty: none
  std::string jobs;    // a regular expression; empty: all
  bool quick = false;
};

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

void step(const char* what) { fmt::print(stderr, "{}\n", what); }

using Json = nlohmann::ordered_json;

Json environment() {
  return {{"compiler", "g++ " __VERSION__},
          {"cpu", processor()},
          {"instruction_set", instruction_set()}};
}

// Writes the tables for gnuplot. Returns the parts of the baseline that are about these films; they
// have a commit of their own, because they can be measured alone. `films`: line_film or point_film.
Json film_parts(const Arguments& arguments, const std::string& films, const Rows& errors,
                const Rows& growth) {
  Json parts{
      {films + "_run",
       {{"commit", arguments.commit}, {"date", arguments.date}, {"environment", environment()}}}};
  for (const auto& [name, rows, series] :
       {std::tuple{films, errors, "series"},
        {films + "_growth", growth, "solver"},
        {films + "_exponents", film_exponents(growth), "solver"}}) {
    write_text(arguments.out + '/' + name + ".blocks.tsv", tsv_blocks(rows, series));
    parts[name] = rows;
  }
  return parts;
}

Json line_film_parts(const Arguments& arguments, const Effort& effort) {
  step("films of line contacts");
  return film_parts(arguments, "line_film",
                    film_errors("line_film", line_film_ways(), judged_contacts(), effort),
                    line_film_growth(effort));
}

Json point_film_parts(const Arguments& arguments, const Effort& effort) {
  step("films of point contacts");
  Json parts = film_parts(arguments, "point_film", point_film_errors(judged_points(), effort),
                          point_film_growth());
  parts["point_film_threads"] = point_films_on_threads();
  return parts;
}

// Writes each row on a line of its own, so that a diff shows which rows have changed.
void write_json(const std::string& path, const Json& parts) {
  std::string text = "{";
  for (const auto& [key, value] : parts.items()) {
    text += text.size() == 1 ? "\n" : ",\n";
    text += fmt::format("\"{}\": ", key);
    if (!value.is_array()) {
      text += value.dump();
      continue;
    }
    text += "[";
    for (std::size_t i = 0; i < value.size(); ++i)
      text += (i == 0 ? "\n" : ",\n") + value[i].dump();
    text += "]";
  }
  write_text(path, text + "\n}\n");
}

// The jobs to measure.
struct Chosen {
  std::vector<Measured> jobs;
  bool are_all_jobs, ranges, line_film, point_film;
  Json baseline = Json::object();  // the old one, if parts of it are kept; else empty
};

std::regex expression(const std::string& text) {
  try {
    return std::regex(text);
  } catch (const std::regex_error&) {
    throw std::runtime_error("--jobs: \"" + text + "\" is no regular expression");
  }
}

// Throws std::runtime_error where an argument is wrong.
Chosen chosen_by(const Arguments& arguments) {
  const std::regex wanted = expression(arguments.jobs);
  const auto is_wanted = [&](const std::string& job) { return std::regex_search(job, wanted); };
  Chosen chosen{all_jobs(Settings::swept), true, is_wanted("moment_5_2"), is_wanted("line_film"),
                is_wanted("point_film")};
  if (!arguments.plugin.empty())
    for (Measured& other : plugin_jobs(conformance::load_plugin(arguments.plugin)))
      chosen.jobs.push_back(std::move(other));
  chosen.are_all_jobs =
      std::erase_if(chosen.jobs, [&](const Measured& one) { return !is_wanted(one.job); }) == 0;
  if (chosen.jobs.empty() && !chosen.line_film && !chosen.point_film) {
    std::string names;
    for (const auto& [job, title] : job_titles()) names += job + ", ";
    throw std::runtime_error("--jobs: no job is called \"" + arguments.jobs + "\"; the jobs are " +
                             names + "line_film, point_film");
  }
  if (arguments.baseline.empty() || (chosen.are_all_jobs && chosen.line_film && chosen.point_film))
    return chosen;
  std::ifstream file(arguments.baseline);
  if (file) chosen.baseline = protocol::read_bounded_json<Json>(file);
  if (!file || !chosen.baseline.is_object())
    throw std::runtime_error(arguments.baseline +
                             ": this is no baseline, from which the parts that "
                             "are not measured could be kept");
  return chosen;
}

// Measures the chosen jobs, writes the tables for gnuplot, and returns the parts of the baseline.
Json work_parts(const Arguments& arguments, Chosen& chosen, const Effort& effort) {
  step("error against work");
  const Rows work = errors_against_work(std::move(chosen.jobs), effort);
  const std::string folder = arguments.out + "/";
  std::map<std::string, Rows> by_job;
  for (const auto& row : work) by_job[row.at("job")].push_back(row);
  for (const auto& [job, rows] : by_job)
    write_text(folder + job + ".blocks.tsv", tsv_blocks(rows, "series"));
  write_text(folder + "work_precision.tsv", tsv(work));
  Json parts{{"commit", arguments.commit},
             {"date", arguments.date},
             {"environment", environment()},
             {"error_against_work", work}};
  if (!chosen.ranges) return parts;
  step("error by range");
  const Rows ranges = errors_by_range();
  write_text(folder + "ranges.tsv", tsv(ranges));
  parts["error_by_range"] = ranges;
  return parts;
}

// Writes all that was measured. A part of the baseline is left unchanged where not all of its jobs
// were measured.
void write_all(const Arguments& arguments, Chosen chosen, const Effort& effort) {
  Json& baseline = chosen.baseline;
  Json parts = Json::object();
  if (!chosen.jobs.empty()) parts = work_parts(arguments, chosen, effort);
  if (chosen.are_all_jobs) baseline.update(parts);
  const auto add = [&](const Json& films) {
    parts.update(films);
    baseline.update(films);
  };
  if (chosen.line_film) add(line_film_parts(arguments, effort));
  if (chosen.point_film) add(point_film_parts(arguments, effort));
  write_json(arguments.out + "/work_precision.json", parts);
  if (!arguments.baseline.empty()) write_json(arguments.baseline, baseline);
}

}  // namespace
}  // namespace tribo::benchmarks

int main(int count, char** argv) {
  tribo::benchmarks::Arguments arguments;
  CLI::App program("True error against work: tables for gnuplot, and a baseline");
  program.add_option("--out", arguments.out, "folder for the tables")->required();
  program.add_option("--baseline", arguments.baseline,
                     "also write each part that was measured whole to this JSON file");
  program.add_option("--commit", arguments.commit, "what was measured");
  program.add_option("--date", arguments.date, "when");
  program.add_option("--plugin", arguments.plugin, "a shared library with a solver of yours");
  program.add_flag("--quick", arguments.quick, "fewer and shorter repetitions");
  program.add_option("--jobs", arguments.jobs,
                     "only the jobs that this regular expression finds, as line_film does");
  try {
    program.parse(count, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  int exit_code = 2;
  try {
    tribo::benchmarks::Chosen chosen = tribo::benchmarks::chosen_by(arguments);
    exit_code = 1;
    std::filesystem::create_directories(arguments.out);
    tribo::benchmarks::write_all(
        arguments, std::move(chosen),
        arguments.quick ? tribo::benchmarks::Effort{3, 0.002} : tribo::benchmarks::Effort{});
  } catch (const std::exception& error) {
    fmt::print(stderr, "tribocheck_work_precision: {}\n", error.what());
    return exit_code;
  }
  return 0;
}
