// SPDX-License-Identifier: Apache-2.0
#include "page/paper_tables.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "page/number_text.hpp"

namespace tribo::report {
namespace {

constexpr std::string_view no_entry = "–";

std::vector<std::string> comparison_cells(const ComparisonTable& table, const ComparisonRow& row) {
  std::vector<std::string> cells{std::string(row.surface), std::string(row.model)};
  if (table.has_criteria) cells.push_back(fmt::format("`{}`", row.criterion));
  cells.push_back(row.computed ? rounded(*row.computed, table.digits) : std::string(no_entry));
  cells.push_back(row.reported ? unrounded(row.reported->value) : std::string(no_entry));
  cells.push_back(row.factor() ? rounded(*row.factor(), 3) : std::string(no_entry));
  cells.push_back(row.in_words);
  return cells;
}

struct InputRow {
  std::string_view heading;
  double (*value)(const Scene&);
};

}  // namespace

TextTable text_table(const ComparisonTable& comparison) {
  TextTable table{comparison.title, {"surface", "model"}, {false, false}, {}, comparison.note};
  if (comparison.has_criteria) {
    table.headings.emplace_back("criterion");
    table.is_number.push_back(false);
  }
  for (const auto& heading :
       {comparison.computed_heading, std::string("reported"), std::string("computed/reported")}) {
    table.headings.push_back(heading);
    table.is_number.push_back(true);
  }
  table.headings.emplace_back("in words");
  table.is_number.push_back(false);
  for (const ComparisonRow& row : comparison.rows)
    table.rows.push_back(comparison_cells(comparison, row));
  return table;
}

TextTable inputs_table(const std::vector<SolvedCase>& solved) {
  constexpr InputRow inputs[] = {
      {"summit density n, 1/m²", [](const Scene& s) { return s.surface.summit_density; }},
      {"summit radius β, m", [](const Scene& s) { return s.surface.summit_radius; }},
      {"summit height deviation σ~s~, m",
       [](const Scene& s) { return s.surface.summit_height_sd; }},
      {"summit plane offset D~d~/σ~s~",
       [](const Scene& s) { return s.surface.summit_plane_offset; }},
      {"faces with that offset",
       [](const Scene& s) { return static_cast<double>(s.surface.offset_planes); }},
      {"effective modulus E*, Pa", [](const Scene& s) { return s.bodies.effective_modulus; }},
      {"reduced radius R, m", [](const Scene& s) { return s.bodies.reduced_radius; }},
      {"viscosity η~0~, Pa·s", [](const Scene& s) { return s.lubricant.viscosity; }},
      {"pressure–viscosity coefficient α, 1/Pa",
       [](const Scene& s) { return s.lubricant.pressure_viscosity; }},
      {"Eyring stress τ~0~, Pa",
       [](const Scene& s) { return s.lubricant.eyring_stress.value_or(0); }},
      {"load F, N", [](const Scene& s) { return s.load; }},
      {"boundary friction coefficient",
       [](const Scene& s) { return s.friction.boundary_coefficient.value_or(0); }},
  };
  TextTable table{"Inputs, from the scene files (GT)", {"input"}, {false}, {}, {}};
  for (const SolvedCase& one : solved) {
    if (one.source.model != AsperityModel::greenwood_tripp) continue;
    table.headings.emplace_back(one.source.surface);
    table.is_number.push_back(true);
  }
  for (const InputRow& input : inputs) {
    std::vector<std::string> cells{std::string(input.heading)};
    for (const SolvedCase& one : solved)
      if (one.source.model == AsperityModel::greenwood_tripp)
        cells.push_back(unrounded(input.value(one.source.scene)));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace tribo::report
