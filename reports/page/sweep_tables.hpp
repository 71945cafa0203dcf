// SPDX-License-Identifier: Apache-2.0
// Writes a sweep's summaries as rounded tables for people and as unrounded CSV and JSON, writes its
// kept points, and draws its pictures.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "page/rendering.hpp"
#include "page/sweep_cells.hpp"
#include "page/text_table.hpp"
#include "sweep/result_file.hpp"

namespace tribo::report {

// The unit in which a table shows numbers that are stored in the SI unit `unit`. `greatest` is the
// greatest of them. The unit leaves few zeros: films, for example, are shown in nm.
struct ReadableUnit {
  std::string name;
  double factor;  // multiplies a number in the SI unit
};
ReadableUnit readable_unit(const std::string& unit, double greatest);

// The tables of the numbers, of the words and of the Sobol indices of each scene. If a sweep
// crosses grids with distributions, its tables have a row for each set of grid values, and below
// them a row for all sets together. `cells` has an element for each scene.
std::vector<TextTable> sweep_tables(const sweep::SweepResult& result,
                                    const std::vector<SweepCells>& cells);

// A row for each scene, column and speed, over all sets of grid values. Below the rows of a scene
// are those of each single set. The cell of an undefined number is empty.
std::string sweep_csv(const sweep::SweepResult& result, const std::vector<SweepCells>& cells);

// The result without its cases. Undefined numbers and unbounded ends are null.
nlohmann::ordered_json sweep_json(const sweep::SweepResult& result,
                                  const std::vector<SweepCells>& cells);

// The quantile at `level`, one of sweep::quantile_levels. NaN if no quantiles are known.
const sweep::Bounded& quantile(const sweep::ColumnResult::Value& value, double level);
// The number of cases that had each word of a column. `words` is the number of these words.
std::vector<std::uint64_t> word_counts(const sweep::ColumnResult::Value& value, std::size_t words);

// Whether every scene is a grid alone and has kept points, at most 40 in all scenes together.
bool is_small_grid(const sweep::SweepResult& result);

// The formats of a sweep's kept points. Each point is a row: what varies, the speed, the outputs.
enum class CaseFormat : std::uint8_t { table, csv, json };

// Writes the points by calls of told(text), each with the next lines: a table for each scene, one
// CSV for all scenes, or a JSON object on each line. Only tables have rounded numbers, and only the
// first hundred points. `file` is the file of the result. Throws std::invalid_argument if a scene
// has no kept points, or more than 50 million numbers.
void write_sweep_cases(const sweep::SweepResult& result, const sweep::ResultFile& file,
                       CaseFormat format, const std::function<void(std::string_view)>& told);

// Draws the summaries as SVG and PNG into a folder, with their data beside them. Makes the folder
// if it is missing. `cells` has the sets of grid values of each scene; few sets are drawn
// separately. `source` is the file of the result; some pictures need its kept points.
Rendering draw_sweep_pictures(const sweep::SweepResult& result,
                              const std::vector<SweepCells>& cells, const sweep::ResultFile& source,
                              const std::string& folder);

}  // namespace tribo::report
