// SPDX-License-Identifier: Apache-2.0
// tribocheck_work_precision: true error against work, as tables for gnuplot and as a baseline.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
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
  bool quick = false;
  bool only_line_film = false;
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

// Writes the tables of gnuplot. Returns parts of the baseline with a commit of their own, because
// they can be measured alone.
Json line_film_parts(const Arguments& arguments, const Effort& effort) {
  step("films of line contacts: error against work");
  const Rows errors = line_film_errors(line_film_ways(), judged_contacts(), effort);
  step("films of line contacts: growth");
  const Rows growth = line_film_growth(effort);
  const Rows exponents = line_film_exponents(growth);
  const std::string folder = arguments.out + "/";
  write_text(folder + "line_film.blocks.tsv", tsv_blocks(errors, "series"));
  write_text(folder + "line_film_growth.blocks.tsv", tsv_blocks(growth, "solver"));
  write_text(folder + "line_film_exponents.blocks.tsv", tsv_blocks(exponents, "solver"));
  return {
      {"line_film_run",
       {{"commit", arguments.commit}, {"date", arguments.date}, {"environment", environment()}}},
      {"line_film", errors},
      {"line_film_growth", growth},
      {"line_film_exponents", exponents}};
}

// Writes the baseline with a row a line, so that a change can be read.
void write_baseline(const std::string& path, const Json& baseline) {
  std::string text = "{";
  for (const auto& [key, value] : baseline.items()) {
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

void write_line_film(const Arguments& arguments, const Effort& effort) {
  const Json parts = line_film_parts(arguments, effort);
  if (arguments.baseline.empty()) return;
  std::ifstream file(arguments.baseline);
  Json baseline = protocol::read_bounded_json<Json>(file);
  baseline.update(parts);
  write_baseline(arguments.baseline, baseline);
}

void write_all(const Arguments& arguments, const Effort& effort) {
  std::vector<Measured> jobs = all_jobs(Settings::swept);
  if (!arguments.plugin.empty())
    for (Measured& other : plugin_jobs(conformance::load_plugin(arguments.plugin)))
      jobs.push_back(std::move(other));
  step("error against work");
  const Rows work = errors_against_work(std::move(jobs), effort);
  step("error by range");
  const Rows ranges = errors_by_range();
  const Json line_film = line_film_parts(arguments, effort);

  const std::string folder = arguments.out + "/";
  std::map<std::string, Rows> by_job;
  for (const auto& row : work) by_job[row.at("job")].push_back(row);
  for (const auto& [job, rows] : by_job)
    write_text(folder + job + ".blocks.tsv", tsv_blocks(rows, "series"));
  write_text(folder + "work_precision.tsv", tsv(work));
  write_text(folder + "ranges.tsv", tsv(ranges));
  if (arguments.baseline.empty()) return;
  Json baseline{{"commit", arguments.commit},
                {"date", arguments.date},
                {"environment", environment()},
                {"error_against_work", work},
                {"error_by_range", ranges}};
  baseline.update(line_film);
  write_baseline(arguments.baseline, baseline);
}

}  // namespace
}  // namespace tribo::benchmarks

int main(int count, char** argv) {
  tribo::benchmarks::Arguments arguments;
  CLI::App program("True error against work: tables for gnuplot, and a baseline");
  program.add_option("--out", arguments.out, "folder for the tables")->required();
  program.add_option("--baseline", arguments.baseline, "also write everything to this JSON file");
  program.add_option("--commit", arguments.commit, "what was measured");
  program.add_option("--date", arguments.date, "when");
  program.add_option("--plugin", arguments.plugin, "a shared library with a solver of yours");
  program.add_flag("--quick", arguments.quick, "fewer and shorter repetitions");
  program.add_flag("--only-line-film", arguments.only_line_film,
                   "only films of line contacts; the baseline's other parts stay");
  CLI11_PARSE(program, count, argv);
  try {
    std::filesystem::create_directories(arguments.out);
    const tribo::benchmarks::Effort effort =
        arguments.quick ? tribo::benchmarks::Effort{3, 0.002} : tribo::benchmarks::Effort{};
    if (arguments.only_line_film)
      tribo::benchmarks::write_line_film(arguments, effort);
    else
      tribo::benchmarks::write_all(arguments, effort);
  } catch (const std::exception& error) {
    fmt::print(stderr, "tribocheck_work_precision: {}\n", error.what());
    return 1;
  }
  return 0;
}
