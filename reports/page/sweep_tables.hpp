// SPDX-License-Identifier: Apache-2.0
// The summaries of a sweep: for people, as tables; for machines, unrounded.
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

// The unit in which a table for people has numbers of an SI unit that are at most `greatest`: one
// that leaves few zeros, nm where all values are films.
struct ReadableUnit {
  std::string name;
  double factor;  // multiplies a number in the SI unit
};
ReadableUnit readable_unit(const std::string& unit, double greatest);

// The numbers, the words and the Sobol indices of each scene. Where grids are crossed with
// distributions, there is a row for each set of grid values, and below them a row for all sets
// together. `cells` has an element for each scene.
std::vector<TextTable> sweep_tables(const sweep::SweepResult& result,
                                    const std::vector<SweepCells>& cells);

// A row for each scene, column and speed, and below these the rows of each set of grid values. A
// cell is empty where its number is undefined.
std::string sweep_csv(const sweep::SweepResult& result, const std::vector<SweepCells>& cells);

// All there is but the cases themselves; what is undefined, and an unbounded end, is null.
nlohmann::ordered_json sweep_json(const sweep::SweepResult& result,
                                  const std::vector<SweepCells>& cells);

// The p-quantile, of one of sweep::quantile_levels.
const sweep::Bounded& quantile(const sweep::ColumnResult::Value& value, double level);
// In how many cases a column of words had each of its words.
std::vector<std::uint64_t> word_counts(const sweep::ColumnResult::Value& value, std::size_t words);

// Are all scenes grids alone, of so few points that a screen has room for each of them?
bool is_small_grid(const sweep::SweepResult& result);

// The kept points of a sweep's result, a row each: what varies, the speed, and each output.
enum class CaseFormat : std::uint8_t { table, csv, json };

// Calls told(text) with the next lines: a table for each scene, one CSV for all scenes, or an
// object of JSON a line. Numbers are unrounded, but in a table, which has the first hundred points.
// `file`: the result. Throws std::invalid_argument where a scene has no points, or more numbers
// than fit into memory comfortably.
void write_sweep_cases(const sweep::SweepResult& result, const sweep::ResultFile& file,
                       CaseFormat format, const std::function<void(std::string_view)>& told);

// Draws the summaries as SVG and PNG into a folder, with their data beside them; makes the folder
// if it is missing. `cells`: of each scene, which are drawn apart where they are few. `source`: the
// result, from which kept points are read where a picture needs them.
Rendering draw_sweep_pictures(const sweep::SweepResult& result,
                              const std::vector<SweepCells>& cells, const sweep::ResultFile& source,
                              const std::string& folder);

}  // namespace tribo::report
