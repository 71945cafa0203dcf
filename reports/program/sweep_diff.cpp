// SPDX-License-Identifier: Apache-2.0
#include "sweep_diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "build_info.hpp"
#include "options.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "sweep/compare_results.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {
namespace {

using nlohmann::ordered_json;
using sweep::ComparedColumn;
using sweep::ComparedKind;
using sweep::ComparedResults;
using sweep::Difference;

bool is_of_a_case(const ComparedColumn& column) {
  return column.kind == ComparedKind::input || column.kind == ComparedKind::output;
}

std::string text_of(const ComparedColumn& column, double value) {
  if (std::isnan(value)) return {};
  if (column.words.empty()) return report::exact(value);
  const auto place = static_cast<std::size_t>(value);
  return place < column.words.size() ? column.words[place] : std::string();
}

std::string case_text(const ComparedColumn& column, const Difference& one) {
  return is_of_a_case(column) ? std::to_string(one.one_case) : std::string();
}

std::string speed_text(const Difference& one) {
  return std::isnan(one.speed) ? std::string() : report::exact(one.speed);
}

// "EQUAL: all 300 numbers, to the bit."
std::string verdict(const ComparedResults& results, double tolerance) {
  const std::uint64_t compared = results.compared(), differing = results.differing();
  if (differing == 0)
    return fmt::format("EQUAL: all {} numbers, {}.", compared,
                       tolerance == 0 ? "to the bit" : fmt::format("within {}", tolerance));
  std::size_t columns = 0;
  double worst = 0;
  for (const ComparedColumn& column : results.columns) {
    columns += column.differing > 0 ? 1 : 0;
    worst = std::max(worst, column.worst);
  }
  return fmt::format("DIFFERENT: {} of {} numbers, in {} of {} columns{}; {}.", differing, compared,
                     columns, results.columns.size(),
                     tolerance == 0 ? "" : fmt::format(", by more than {}", tolerance),
                     std::isfinite(worst) ? fmt::format("the greatest difference is {:.3g}", worst)
                                          : "some are no numbers, or other words");
}

// --- Tables.

std::string shown(const std::string& text) { return text.empty() ? "–" : text; }

std::string shown_size(double size) { return report::rounded(size, 3); }

report::TextTable worst_table(const ComparedResults& results, const SweepDiffArguments& asked) {
  const std::uint64_t all = results.differing();
  report::TextTable table{
      results.worst.size() == all
          ? fmt::format("{} and {}: what differs, the worst first", asked.files[0], asked.files[1])
          : fmt::format("{} and {}: the worst {} of {} differences", asked.files[0], asked.files[1],
                        results.worst.size(), all),
      {"scene", "of", "name", "unit", "case", "speed, m/s", "first", "second", "difference"},
      {false, false, false, false, true, true, true, true, true},
      {},
      ""};
  for (const Difference& one : results.worst) {
    const ComparedColumn& column = results.columns[one.column];
    table.rows.push_back({column.scene, std::string(name(column.kind)),
                          one.statistic.empty() ? column.name : column.name + ", " + one.statistic,
                          shown(column.unit), shown(case_text(column, one)), shown(speed_text(one)),
                          shown(text_of(column, one.first)), shown(text_of(column, one.second)),
                          shown_size(one.size)});
  }
  return table;
}

report::TextTable count_table(const ComparedResults& results) {
  report::TextTable table{"How many numbers differ",
                          {"scene", "of", "name", "compared", "differing", "worst"},
                          {false, false, false, true, true, true},
                          {},
                          ""};
  for (const ComparedColumn& column : results.columns)
    table.rows.push_back({column.scene, std::string(name(column.kind)), column.name,
                          std::to_string(column.compared), std::to_string(column.differing),
                          column.differing == 0 ? "–" : shown_size(column.worst)});
  return table;
}

void append_tables(Text& to, const ComparedResults& results, const SweepDiffArguments& asked) {
  if (!results.worst.empty()) append(to, report::plain_table(worst_table(results, asked)) + '\n');
  append(to, report::plain_table(count_table(results)) + '\n');
  for (const std::string& note : results.notes)
    append(to, "  - " + printable(note, std::string::npos) + '\n');
  append(to, verdict(results, asked.tolerance) + '\n');
}

// --- CSV and JSON.

void append_csv(Text& to, const ComparedResults& results) {
  append(to, "scene,of,name,unit,statistic,case,speed,first,second,difference\n");
  for (const Difference& one : results.worst) {
    const ComparedColumn& column = results.columns[one.column];
    append(to, report::csv_text(column.scene));
    for (const std::string& cell :
         {std::string(name(column.kind)), column.name, column.unit, one.statistic,
          case_text(column, one), speed_text(one), text_of(column, one.first),
          text_of(column, one.second), report::exact(one.size)})
      append(to, ',' + report::csv_text(cell));
    append(to, "\n");
  }
}

ordered_json json_value(const ComparedColumn& column, double value) {
  if (std::isnan(value)) return nullptr;
  if (!column.words.empty() || std::isinf(value)) return text_of(column, value);
  return value;
}

// JSON has no infinity: a difference that is no number is written as null.
ordered_json json_size(double size) {
  return std::isfinite(size) ? ordered_json(size) : ordered_json(nullptr);
}

ordered_json difference_json(const ComparedColumn& column, const Difference& one) {
  ordered_json object{{"scene", column.scene}, {"of", name(column.kind)}, {"name", column.name}};
  if (!one.statistic.empty()) object["statistic"] = one.statistic;
  if (is_of_a_case(column)) object["case"] = one.one_case;
  if (!std::isnan(one.speed)) object["speed"] = one.speed;
  object["first"] = json_value(column, one.first);
  object["second"] = json_value(column, one.second);
  object["difference"] = json_size(one.size);
  return object;
}

void append_json(Text& to, const ComparedResults& results, const SweepDiffArguments& asked) {
  ordered_json object{{"first", asked.files[0]},
                      {"second", asked.files[1]},
                      {"tolerance", asked.tolerance},
                      {"equal", results.differing() == 0},
                      {"compared", results.compared()},
                      {"differing", results.differing()},
                      {"notes", results.notes},
                      {"columns", ordered_json::array()},
                      {"differences", ordered_json::array()}};
  for (const ComparedColumn& column : results.columns) {
    ordered_json one{{"scene", column.scene},       {"of", name(column.kind)},
                     {"name", column.name},         {"unit", column.unit},
                     {"compared", column.compared}, {"differing", column.differing}};
    if (column.differing > 0) one["worst"] = json_size(column.worst);
    object["columns"].push_back(std::move(one));
  }
  for (const Difference& one : results.worst)
    object["differences"].push_back(difference_json(results.columns[one.column], one));
  append(
      to,
      document("sweep-diff/1", object).dump(1, ' ', false, ordered_json::error_handler_t::replace) +
          "\n");
}

}  // namespace

CLI::App* add_sweep_diff(CLI::App& sweep, SweepDiffArguments& arguments) {
  CLI::App* app = sweep.add_subcommand("diff", "tell in which numbers two results differ");
  app->add_option("RESULT", arguments.files, "two results, HDF5 files")->required()->expected(2);
  add_number_option(
      *app, "--tolerance", [&arguments](double value) { arguments.tolerance = value; },
      [](double value) { return std::isfinite(value) && value >= 0; }, "numbers from 0",
      "the relative difference that is allowed (default: 0, any bit tells)");
  app->add_option("--most", arguments.most, "list so many differences, the worst (default: 20)")
      ->check(CLI::Range(0, 100'000));
  app->add_option("--format", arguments.format, "how to write them (default: table)")
      ->check(CLI::IsMember({"table", "csv", "json"}));
  return app;
}

int diff_sweeps(const SweepDiffArguments& arguments, OutputStream& output) {
  const sweep::ResultFile first(arguments.files[0]), second(arguments.files[1]);
  const ComparedResults results =
      sweep::compare_results(first, second, arguments.tolerance, arguments.most);
  if (arguments.format == "csv") {
    append_csv(output.text(), results);
    complain(verdict(results, arguments.tolerance));
  } else if (arguments.format == "json") {
    append_json(output.text(), results, arguments);
  } else {
    append_tables(output.text(), results, arguments);
  }
  output.flush();
  return results.differing() == 0 ? exit_done : exit_failed;
}

}  // namespace tribo::cli
