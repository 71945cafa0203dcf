// SPDX-License-Identifier: Apache-2.0
#include "page/sweep_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "page/number_text.hpp"
#include "page/text_table.hpp"

namespace tribo::report {
namespace {

using sweep::SceneResult;

constexpr std::uint64_t most_numbers = 50'000'000;  // 400 MB
constexpr std::size_t rows_of_a_table = 100;

// A column of the rows: one value a case, or one a case and speed.
struct CaseColumn {
  std::string name, unit;
  std::vector<std::string> words;
  std::vector<double> values;
  std::size_t width;

  double at(std::size_t one_case, std::size_t speed) const {
    return values[one_case * width + (width == 1 ? 0 : speed)];
  }
};

struct CaseTable {
  std::vector<CaseColumn> columns;
  std::size_t cases, speeds;
};

CaseTable read_cases(const SceneResult& scene, const std::string& path) {
  if (!scene.has_points)
    throw std::invalid_argument(fmt::format(
        "{}: scene {} has no cases: the sweep was told keep = \"summaries\"", path, scene.id));
  std::uint64_t wide = scene.inputs.size();
  std::size_t speeds = 1;
  for (const sweep::ColumnResult& column : scene.columns) {
    wide += column.values.size();
    speeds = std::max(speeds, column.values.size());
  }
  if (wide * scene.cases > most_numbers)
    throw std::invalid_argument(
        fmt::format("{}: scene {} has {} numbers; allowed: up to {}. Read the file with h5py, "
                    "MATLAB or Octave",
                    path, scene.id, grouped(wide * scene.cases), grouped(most_numbers)));
  CaseTable table{{}, static_cast<std::size_t>(scene.cases), speeds};
  for (const sweep::InputResult& input : scene.inputs)
    table.columns.push_back(
        {input.path, input.unit, input.words, sweep::read_input(path, scene.id, input.path), 1});
  // The speed stands between what varies and the outputs.
  if (speeds > 1) {
    CaseColumn speed{"speed", "m/s", {}, {}, speeds};
    for (std::size_t i = 0; i < table.cases; ++i)
      speed.values.insert(speed.values.end(), scene.speeds.begin(), scene.speeds.end());
    table.columns.push_back(std::move(speed));
  }
  for (const sweep::ColumnResult& column : scene.columns)
    table.columns.push_back({column.name, column.unit, column.words,
                             sweep::read_column(path, scene.id, column.name),
                             column.values.size()});
  return table;
}

std::string word_of(const CaseColumn& column, double value) {
  const auto place = static_cast<std::size_t>(value);
  return std::isnan(value) || place >= column.words.size() ? "" : column.words[place];
}

std::string heading(const CaseColumn& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

// Unrounded; what is undefined is empty.
std::string csv_cell(const CaseColumn& column, double value) {
  if (!column.words.empty()) return word_of(column, value);
  return std::isnan(value) ? "" : exact(value);
}

std::string plain_cell(const CaseColumn& column, double value) {
  if (!column.words.empty()) return word_of(column, value);
  return std::isnan(value) ? "–" : rounded(value, 5);
}

nlohmann::ordered_json json_cell(const CaseColumn& column, double value) {
  if (std::isnan(value)) return nullptr;
  if (!column.words.empty()) return word_of(column, value);
  return value;
}

using Told = std::function<void(std::string_view)>;

void write_csv(const SceneResult& scene, const CaseTable& table, bool with_head, const Told& told) {
  std::string line = "scene,case";
  for (const CaseColumn& column : table.columns) line += ',' + csv_text(heading(column));
  if (with_head) told(line + '\n');
  for (std::size_t i = 0; i < table.cases; ++i)
    for (std::size_t s = 0; s < table.speeds; ++s) {
      line = fmt::format("{},{}", csv_text(scene.id), i);
      for (const CaseColumn& column : table.columns)
        line += ',' + csv_cell(column, column.at(i, s));
      told(line + '\n');
    }
}

void write_json(const SceneResult& scene, const CaseTable& table, const Told& told) {
  for (std::size_t i = 0; i < table.cases; ++i)
    for (std::size_t s = 0; s < table.speeds; ++s) {
      nlohmann::ordered_json object{{"scene", scene.id}, {"case", i}};
      for (const CaseColumn& column : table.columns)
        object[column.name] = json_cell(column, column.at(i, s));
      told(object.dump() + '\n');
    }
}

void write_table(const SceneResult& scene, const CaseTable& table, const Told& told) {
  const std::size_t all = table.cases * table.speeds, shown = std::min(all, rows_of_a_table);
  TextTable text{shown == all ? fmt::format("{}: {} points", scene.id, grouped(all))
                              : fmt::format("{}: the first {} of {} points; --format csv has all",
                                            scene.id, shown, grouped(all)),
                 {"case"},
                 {true},
                 {},
                 ""};
  for (const CaseColumn& column : table.columns) {
    text.headings.push_back(fmt::format(
        "{}{}", column.name, column.unit.empty() ? "" : fmt::format(", {}", column.unit)));
    text.is_number.push_back(column.words.empty());
  }
  for (std::size_t row = 0; row < shown; ++row) {
    const std::size_t i = row / table.speeds, s = row % table.speeds;
    std::vector<std::string> cells{std::to_string(i)};
    for (const CaseColumn& column : table.columns)
      cells.push_back(plain_cell(column, column.at(i, s)));
    text.rows.push_back(std::move(cells));
  }
  told(plain_table(text));
}

}  // namespace

void write_sweep_cases(const sweep::SweepResult& result, const std::string& path, CaseFormat format,
                       const Told& told) {
  bool is_first = true;
  std::string heads;
  for (const SceneResult& scene : result.scenes) {
    const CaseTable table = read_cases(scene, path);
    if (format == CaseFormat::json) {
      write_json(scene, table, told);
    } else if (format == CaseFormat::csv) {
      // Scenes that vary in other fields get heads of their own.
      std::string own;
      for (const CaseColumn& column : table.columns) own += heading(column) + ',';
      if (!is_first && own != heads) told("\n");
      write_csv(scene, table, own != heads, told);
      heads = own;
    } else {
      if (!is_first) told("\n");
      write_table(scene, table, told);
    }
    is_first = false;
  }
}

}  // namespace tribo::report
