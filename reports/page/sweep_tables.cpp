// SPDX-License-Identifier: Apache-2.0
#include "page/sweep_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "page/texts.hpp"

namespace tribo::report {
namespace {

using sweep::ColumnResult;
using sweep::SceneResult;
using sweep::SweepResult;

constexpr std::size_t most_speeds = 11;
constexpr int digits = 4;  // the relative error of a quantile is up to 5e-4

std::string number(double value, double factor = 1) {
  return std::isnan(value) ? "–" : rounded(factor * value, digits);
}

ReadableUnit unit_of(const ColumnResult& column) {
  double greatest = 0;
  for (const ColumnResult::Value& value : column.values)
    if (std::isfinite(value.greatest) && std::isfinite(value.least))
      greatest = std::max({greatest, std::abs(value.greatest), std::abs(value.least)});
  return readable_unit(column.unit, greatest);
}

// "0.712 ± 0.011"
std::string with_error(const sweep::Bounded& index) {
  if (!std::isfinite(index.value)) return "–";
  const auto fixed = [](double value) {
    const std::string text = fmt::format("{:.3f}", std::abs(value));
    return value < 0 && text != "0.000" ? "−" + text : text;
  };
  if (!std::isfinite(index.high)) return fixed(index.value);
  // The variable changes no value of the column: the index has no error.
  if (index.value == 0 && index.low == 0 && index.high == 0) return "not used";
  return fmt::format("{} ± {}", fixed(index.value), fixed(index.high - index.value));
}

// "onset.film_maximum.speed" as "onset.film_maximum" and "speed"; without a dot the first is empty.
std::pair<std::string_view, std::string_view> split_name(std::string_view column) {
  const std::size_t dot = column.rfind('.');
  if (dot == std::string_view::npos) return {"", column};
  return {column.substr(0, dot), column.substr(dot + 1)};
}

// The places of at most eleven values, the first and the last among them.
std::vector<std::size_t> chosen(std::size_t width) {
  std::vector<std::size_t> places(std::min(width, most_speeds));
  if (width <= most_speeds)
    std::iota(places.begin(), places.end(), std::size_t{0});
  else
    for (std::size_t i = 0; i < most_speeds; ++i)
      places[i] = (i * (width - 1) + (most_speeds - 1) / 2) / (most_speeds - 1);
  return places;
}

bool has_speeds(const SceneResult& scene) {
  return std::any_of(scene.columns.begin(), scene.columns.end(),
                     [](const ColumnResult& column) { return column.values.size() > 1; });
}

std::string speed_text(const SceneResult& scene, const ColumnResult& column, std::size_t i) {
  return column.values.size() > 1 && i < scene.speeds.size()
             ? fmt::format("{:.{}g}", scene.speeds[i], digits)
             : "–";
}

// A remark for a caption; empty if all speeds are shown.
std::string chosen_speeds(const SceneResult& scene, bool with_speed) {
  return with_speed && scene.speeds.size() > most_speeds
             ? fmt::format("; {} of {} speeds, evenly chosen", most_speeds, scene.speeds.size())
             : "";
}

// A grid has no mean: its values were chosen, not drawn.
TextTable number_table(const SceneResult& scene, const SweepCells& cells, bool all_are_shown) {
  const bool with_speed = has_speeds(scene);
  const bool is_grid = scene.design == "factorial";
  TextTable table{fmt::format("{}: {} cases, {} points{}", scene.id, grouped(scene.cases),
                              grouped(scene.points), chosen_speeds(scene, with_speed)),
                  {"column", "unit", "speed, m/s", "cases", "undefined"},
                  {false, false, true, true, true},
                  {},
                  ""};
  const std::vector<std::string> statistics =
      is_grid ? std::vector<std::string>{"least", "greatest"}
              : std::vector<std::string>{"mean", "sd", "2.5 %", "50 %", "97.5 %"};
  table.headings.insert(table.headings.end(), statistics.begin(), statistics.end());
  table.is_number.resize(table.headings.size(), true);
  const auto add_rows = [&](const std::string& where, const ColumnResult& column,
                            const ReadableUnit& unit) {
    for (const std::size_t i : chosen(column.values.size())) {
      const ColumnResult::Value& value = column.values[i];
      std::vector<std::string> row{column.name, unit.name.empty() ? "–" : unit.name,
                                   speed_text(scene, column, i), grouped(value.count),
                                   grouped(value.undefined)};
      const std::vector<double> numbers =
          is_grid ? std::vector<double>{value.least, value.greatest}
                  : std::vector<double>{value.mean, value.sd, quantile(value, 0.025).value,
                                        quantile(value, 0.5).value, quantile(value, 0.975).value};
      for (const double one : numbers) row.push_back(number(one, unit.factor));
      if (cells.count > 1) row.insert(row.begin() + 1, where);
      table.rows.push_back(std::move(row));
    }
  };
  for (std::size_t c = 0; c < scene.columns.size(); ++c) {
    const ColumnResult& column = scene.columns[c];
    if (!column.words.empty()) continue;
    const ReadableUnit unit = unit_of(column);
    for (const SweepCell& cell : cells.cells) add_rows(cell.where, cell.columns[c], unit);
    add_rows(fmt::format("all {}", cells.count), column, unit);
  }
  if (is_grid && scene.has_points && !all_are_shown)
    table.caption += "; sweep show --cases has each";
  if (cells.count > 1) {
    table.headings.insert(table.headings.begin() + 1, "grid values");
    table.is_number.insert(table.is_number.begin() + 1, false);
    if (cells.cells.empty())
      table.caption += fmt::format("; over all {} sets of grid values", grouped(cells.count));
  }
  if (!with_speed) {
    const std::ptrdiff_t at = cells.count > 1 ? 3 : 2;
    table.headings.erase(table.headings.begin() + at);
    table.is_number.erase(table.is_number.begin() + at);
    for (auto& row : table.rows) row.erase(row.begin() + at);
  }
  return table;
}

TextTable word_table(const SceneResult& scene, std::size_t column_place, const SweepCells& cells) {
  const ColumnResult& column = scene.columns[column_place];
  const bool with_speed = column.values.size() > 1;
  TextTable table{fmt::format("{}: {}, part of the cases in per cent{}", scene.id, column.name,
                              chosen_speeds(scene, with_speed)),
                  {},
                  {},
                  {},
                  ""};
  if (cells.count > 1) table.headings.emplace_back("grid values");
  if (with_speed) table.headings.emplace_back("speed, m/s");
  table.headings.emplace_back("cases");
  for (const std::string& word : column.words) table.headings.push_back(word + ", %");
  table.is_number.assign(table.headings.size(), true);
  if (cells.count > 1) table.is_number.front() = false;
  const auto add_rows = [&](const std::string& where, const ColumnResult& of_cases) {
    for (const std::size_t i : chosen(of_cases.values.size())) {
      const ColumnResult::Value& value = of_cases.values[i];
      std::vector<std::string> row;
      if (cells.count > 1) row.push_back(where);
      if (with_speed) row.push_back(speed_text(scene, of_cases, i));
      row.push_back(grouped(value.count));
      for (const std::uint64_t count : word_counts(value, column.words.size()))
        row.push_back(value.count == 0
                          ? "–"
                          : fmt::format("{:.2f}", 100 * static_cast<double>(count) /
                                                      static_cast<double>(value.count)));
      table.rows.push_back(std::move(row));
    }
  };
  for (const SweepCell& cell : cells.cells) add_rows(cell.where, cell.columns[column_place]);
  add_rows(fmt::format("all {}", cells.count), column);
  return table;
}

using Columns = std::vector<const ColumnResult*>;

// Puts columns into tables of at most three. Columns of one onset share a table, and so do columns
// that belong to no onset.
std::vector<Columns> in_tables(const SceneResult& scene) {
  constexpr std::size_t most_columns = 3;
  std::vector<Columns> tables;
  for (const ColumnResult& column : scene.columns) {
    if (column.values.size() != 1 || !column.words.empty() ||
        column.values.front().sensitivity.total.empty())
      continue;
    const bool is_next =
        !tables.empty() && tables.back().size() < most_columns &&
        split_name(tables.back().front()->name).first == split_name(column.name).first;
    if (!is_next) tables.emplace_back();
    tables.back().push_back(&column);
  }
  return tables;
}

// Would all of a variable's indices be shown as 0.000?
bool is_nothing(const Columns& columns, std::size_t variable) {
  constexpr double shown_from = 0.0005;
  return std::all_of(columns.begin(), columns.end(), [variable](const ColumnResult* column) {
    const sweep::SobolIndices& indices = column->values.front().sensitivity;
    return std::max(std::abs(indices.total[variable].high),
                    std::abs(indices.first_order[variable].high)) < shown_from;
  });
}

std::uint64_t groups_of(const ColumnResult* column) {
  return column->values.front().sensitivity.groups;
}

// A remark for a caption if a column is undefined in some groups; empty if it is defined in all.
std::string groups_text(const ColumnResult* column, std::uint64_t all, std::string_view name) {
  const std::uint64_t groups = groups_of(column);
  if (groups >= all) return {};
  if (sweep::has_enough_groups(groups, all))
    return fmt::format("; {} of {} groups have {}", grouped(groups), grouped(all), name);
  return fmt::format(
      "; no indices{}: {} of {} groups of cases have it, and these are no random choice of the "
      "draws (99 % are needed)",
      name == "it" ? "" : fmt::format(" of {}", name), grouped(groups), grouped(all));
}

// A row for each variable, the greatest total of the first column on top. Returns how many
// variables are left out.
std::size_t append_index_rows(TextTable& table, const SceneResult& scene, const Columns& columns) {
  const auto& totals = columns.front()->values.front().sensitivity.total;
  std::vector<std::size_t> order(scene.sensitivity_variables.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return totals[a].value > totals[b].value; });
  for (const std::size_t v : order) {
    if (is_nothing(columns, v)) continue;
    std::vector<std::string> row{scene.sensitivity_variables[v]};
    for (const ColumnResult* const column : columns) {
      const sweep::SobolIndices& indices = column->values.front().sensitivity;
      row.push_back(with_error(indices.first_order[v]));
      row.push_back(with_error(indices.total[v]));
    }
    table.rows.push_back(std::move(row));
  }
  return order.size() - table.rows.size();
}

TextTable index_table(const SceneResult& scene, const Columns& columns) {
  const std::string_view prefix = split_name(columns.front()->name).first;
  TextTable table{fmt::format("{}: Sobol indices{} ± 1.96 standard errors", scene.id,
                              prefix.empty() ? "" : fmt::format(" of {}", prefix)),
                  {"variable"},
                  {false},
                  {},
                  "The part of the variance that a variable brings, alone and with all others."};
  const std::uint64_t all = scene.cases / 2;
  Columns shown;
  for (const ColumnResult* const column : columns) {
    if (!sweep::has_enough_groups(groups_of(column), all)) continue;
    shown.push_back(column);
    for (const char* const kind : {"first order", "total"}) {
      table.headings.push_back(fmt::format("{}, {}", split_name(column->name).second, kind));
      table.is_number.push_back(true);
    }
  }
  const std::size_t left_out = shown.empty() ? 0 : append_index_rows(table, scene, shown);
  if (left_out > 0)
    table.caption +=
        fmt::format("; {} variable{} at 0.000 left out", left_out, left_out == 1 ? "" : "s");
  // Columns of one onset are defined in the same groups.
  const bool are_alike = std::ranges::all_of(columns, [&](const ColumnResult* column) {
    return groups_of(column) == groups_of(columns.front());
  });
  for (const ColumnResult* const column : are_alike ? Columns{columns.front()} : columns)
    table.caption += groups_text(column, all, are_alike ? "it" : split_name(column->name).second);
  return table;
}

}  // namespace

ReadableUnit readable_unit(const std::string& unit, double greatest) {
  if (unit == "Pa" && greatest >= 1e5)
    return greatest >= 1e8 ? ReadableUnit{"GPa", 1e-9} : ReadableUnit{"MPa", 1e-6};
  if (unit != "m" || greatest == 0 || greatest >= 1e-2) return {unit, 1};
  return greatest < 1e-5 ? ReadableUnit{"nm", 1e9} : ReadableUnit{"µm", 1e6};
}

bool is_small_grid(const SweepResult& result) {
  constexpr std::uint64_t most_shown = 40;
  std::uint64_t points = 0;
  for (const SceneResult& scene : result.scenes) {
    if (scene.design != "factorial" || !scene.has_points) return false;
    points += scene.points;
  }
  return points <= most_shown;
}

std::vector<TextTable> sweep_tables(const SweepResult& result,
                                    const std::vector<SweepCells>& cells) {
  std::vector<TextTable> tables;
  for (std::size_t s = 0; s < result.scenes.size(); ++s) {
    const SceneResult& scene = result.scenes[s];
    if (TextTable numbers = number_table(scene, cells[s], is_small_grid(result));
        !numbers.rows.empty())
      tables.push_back(std::move(numbers));
    for (std::size_t c = 0; c < scene.columns.size(); ++c)
      if (!scene.columns[c].words.empty()) tables.push_back(word_table(scene, c, cells[s]));
    for (const Columns& columns : in_tables(scene)) tables.push_back(index_table(scene, columns));
  }
  return tables;
}

}  // namespace tribo::report
