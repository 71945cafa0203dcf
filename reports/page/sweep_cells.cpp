// SPDX-License-Identifier: Apache-2.0
#include "page/sweep_cells.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "sweep/plan_reader.hpp"
#include "sweep/summary.hpp"

namespace tribo::report {
namespace {

using sweep::ColumnResult;

constexpr std::uint64_t most_numbers_of_a_column = 5'000'000;  // 40 MB

// The summary of value `place` of a column that has `width` values for each case.
ColumnResult::Value value_of(const std::vector<double>& numbers, std::size_t width,
                             std::size_t place) {
  std::vector<double> values;
  for (std::size_t i = place; i < numbers.size(); i += width) values.push_back(numbers[i]);
  sweep::ValueSummary summary;
  summary.add(values);
  const sweep::Moments& moments = summary.moments;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const bool is_empty = moments.count == 0;
  ColumnResult::Value value{.count = moments.count,
                            .undefined = summary.undefined,
                            .mean = is_empty ? none : moments.mean,
                            .sd = moments.sd(),
                            .least = is_empty ? none : moments.least,
                            .greatest = is_empty ? none : moments.greatest,
                            .quantiles = {},
                            .histogram = histogram_of(summary.sketch, sweep::histogram_bins),
                            .sensitivity = {}};
  for (const double level : sweep::quantile_levels)
    value.quantiles.push_back(quantile_of(summary, level));
  return value;
}

// The grid values of a cell. From cell to cell the last grid varies first.
std::string where_text(const sweep::SceneSweep& sweep, std::uint64_t cell) {
  std::string text;
  for (std::size_t v = sweep.variables.size() - sweep.drawn(); v-- > 0;) {
    const sweep::Variable& variable = sweep.variables[v];
    const double value = variable.grid[cell % variable.grid.size()];
    cell /= variable.grid.size();
    const std::string number =
        variable.words.empty()
            ? fmt::format("{:.4g}{}{}", value, variable.unit.empty() ? "" : " ", variable.unit)
            : variable.words[static_cast<std::size_t>(value)];
    text = fmt::format("{} {}{}{}", variable.path, number, text.empty() ? "" : ", ", text);
  }
  return text;
}

}  // namespace

SweepCells cells_of(const sweep::SceneResult& scene, const sweep::ResultFile& file) {
  const sweep::SweepReading reading = sweep::parse_sweep(scene.text, scene.file);
  if (!reading.sweep || reading.sweep->drawn() == 0) return {};
  const sweep::SceneSweep& sweep = *reading.sweep;
  SweepCells result{sweep.grid_cells, {}};
  const bool are_too_many =
      sweep.grid_cells > most_sweep_cells || sweep.draws * sweep.width() > most_numbers_of_a_column;
  if (sweep.grid_cells == 1 || !scene.has_points || are_too_many) return result;
  for (std::uint64_t cell = 0; cell < sweep.grid_cells; ++cell) {
    SweepCell one{where_text(sweep, cell), {}};
    for (const ColumnResult& column : scene.columns) {
      const std::vector<double> numbers =
          file.column(scene.id, column.name, sweep::CaseRange{cell * sweep.draws, sweep.draws});
      ColumnResult& own = one.columns.emplace_back(column);
      for (std::size_t i = 0; i < own.values.size(); ++i)
        own.values[i] = value_of(numbers, own.values.size(), i);
    }
    result.cells.push_back(std::move(one));
  }
  return result;
}

}  // namespace tribo::report
