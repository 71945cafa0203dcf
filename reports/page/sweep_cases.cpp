// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "page/sweep_tables.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"

namespace tribo::report {
namespace {

using sweep::SceneResult;

constexpr std::uint64_t most_numbers = 50'000'000;  // 400 MB
constexpr std::size_t rows_of_a_table = 100;

// One column. It has a value for each case, for each speed, or for each case and speed.
struct CaseColumn {
  std::string name, unit;
  std::vector<std::string> words;
  std::vector<double> values;
  std::size_t case_step, speed_step;  // distance in `values` to the next

  double at(std::size_t one_case, std::size_t speed) const {
    return values[one_case * case_step + speed * speed_step];
  }
  // "film [m]"
  std::string heading() const { return unit.empty() ? name : fmt::format("{} [{}]", name, unit); }
};

struct CaseTable {
  std::string scene;
  std::vector<CaseColumn> columns;
  std::size_t cases, speeds;
};

CaseTable read_cases(const SceneResult& scene, const sweep::ResultFile& file) {
  const std::string& path = file.path();
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
  CaseTable table{scene.id, {}, static_cast<std::size_t>(scene.cases), speeds};
  for (const sweep::InputResult& input : scene.inputs)
    table.columns.push_back(
        {input.path, input.unit, input.words, file.input(scene.id, input.path), 1, 0});
  // The speed stands between what varies and the outputs.
  if (speeds > 1) table.columns.push_back({"speed", "m/s", {}, scene.speeds, 0, 1});
  for (const sweep::ColumnResult& column : scene.columns) {
    const std::size_t width = column.values.size();
    table.columns.push_back({column.name, column.unit, column.words,
                             file.column(scene.id, column.name), width,
                             width > 1 ? std::size_t{1} : 0});
  }
  return table;
}

std::string word_of(const CaseColumn& column, double value) {
  const bool is_word = value >= 0 && value < static_cast<double>(column.words.size());
  return is_word ? column.words[static_cast<std::size_t>(value)] : "";
}

// The unrounded value; empty if it is undefined.
std::string csv_cell(const CaseColumn& column, double value) {
  if (!column.words.empty()) return word_of(column, value);
  return std::isnan(value) ? "" : exact(value);
}

std::string plain_cell(const CaseColumn& column, double value, double factor) {
  if (!column.words.empty()) return word_of(column, value);
  return std::isnan(value) ? "–" : rounded(factor * value, 5);
}

ReadableUnit unit_of(const CaseColumn& column) {
  double greatest = 0;
  for (const double value : column.values)
    if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
  return readable_unit(column.unit, greatest);
}

nlohmann::ordered_json json_cell(const CaseColumn& column, double value) {
  if (std::isnan(value)) return nullptr;
  if (!column.words.empty()) return word_of(column, value);
  // The radius of a flat face, as a scene file has it: JSON has no number for it.
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

using Told = std::function<void(std::string_view)>;

// All columns of all scenes, each once.
std::vector<std::string> headings_of(const std::vector<CaseTable>& tables) {
  std::vector<std::string> all;
  for (const CaseTable& table : tables)
    for (const CaseColumn& column : table.columns)
      if (std::find(all.begin(), all.end(), column.heading()) == all.end())
        all.push_back(column.heading());
  return all;
}

// A cell of a column that the scene does not have is empty.
void write_csv(const CaseTable& table, const std::vector<std::string>& headings, const Told& told) {
  std::vector<const CaseColumn*> columns;
  for (const std::string& heading : headings) {
    const auto found =
        std::find_if(table.columns.begin(), table.columns.end(),
                     [&](const CaseColumn& column) { return column.heading() == heading; });
    columns.push_back(found == table.columns.end() ? nullptr : &*found);
  }
  const std::string scene = csv_text(table.scene);
  for (std::size_t i = 0; i < table.cases; ++i)
    for (std::size_t s = 0; s < table.speeds; ++s) {
      std::string line = fmt::format("{},{}", scene, i);
      for (const CaseColumn* const column : columns)
        line += ',' + (column == nullptr ? "" : csv_cell(*column, column->at(i, s)));
      told(line + '\n');
    }
}

void write_json(const CaseTable& table, const Told& told) {
  for (std::size_t i = 0; i < table.cases; ++i)
    for (std::size_t s = 0; s < table.speeds; ++s) {
      nlohmann::ordered_json object{{"scene", table.scene}, {"case", i}};
      for (const CaseColumn& column : table.columns)
        object[column.name] = json_cell(column, column.at(i, s));
      told(object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
    }
}

void write_table(const CaseTable& table, const Told& told) {
  const std::size_t all = table.cases * table.speeds, shown = std::min(all, rows_of_a_table);
  TextTable text{shown == all ? fmt::format("{}: {} points", table.scene, grouped(all))
                              : fmt::format("{}: the first {} of {} points; --format csv has all",
                                            table.scene, shown, grouped(all)),
                 {"case"},
                 {true},
                 {},
                 ""};
  std::vector<double> factors;
  for (const CaseColumn& column : table.columns) {
    const ReadableUnit unit = unit_of(column);
    factors.push_back(unit.factor);
    text.headings.push_back(
        fmt::format("{}{}", column.name, unit.name.empty() ? "" : fmt::format(", {}", unit.name)));
    text.is_number.push_back(column.words.empty());
  }
  for (std::size_t row = 0; row < shown; ++row) {
    const std::size_t i = row / table.speeds, s = row % table.speeds;
    std::vector<std::string> cells{std::to_string(i)};
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      cells.push_back(plain_cell(table.columns[c], table.columns[c].at(i, s), factors[c]));
    text.rows.push_back(std::move(cells));
  }
  told(plain_table(text));
}

}  // namespace

void write_sweep_cases(const sweep::SweepResult& result, const sweep::ResultFile& file,
                       CaseFormat format, const Told& told) {
  std::vector<CaseTable> tables;
  for (const SceneResult& scene : result.scenes) tables.push_back(read_cases(scene, file));
  const std::vector<std::string> headings = headings_of(tables);
  if (format == CaseFormat::csv) {
    std::string head = "scene,case";
    for (const std::string& heading : headings) head += ',' + csv_text(heading);
    told(head + '\n');
  }
  for (const CaseTable& table : tables) {
    if (format == CaseFormat::json) {
      write_json(table, told);
    } else if (format == CaseFormat::csv) {
      write_csv(table, headings, told);
    } else {
      if (&table != &tables.front()) told("\n");
      write_table(table, told);
    }
  }
}

}  // namespace tribo::report
