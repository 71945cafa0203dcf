// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page/number_text.hpp"
#include "page/sweep_picture_parts.hpp"

namespace tribo::report {
namespace {

using namespace sweep_picture;
using sweep::SobolIndex;
using sweep::SobolIndices;

constexpr double drawn_from = 0.005;
constexpr double points_a_bar = 18, points_between = 14;

struct Subject {
  const sweep::SceneResult* scene;
  const SobolIndices* indices;
  std::uint32_t colour;
};

struct Row {
  std::string variable;
  double greatest = 0;  // total
};

std::vector<Subject> subjects_of(const sweep::SweepResult& result, std::string_view column) {
  const std::vector<std::uint32_t> colour = colours(result);
  std::vector<Subject> subjects;
  for (std::size_t i = 0; i < result.scenes.size(); ++i) {
    const sweep::ColumnResult* const found = result.scenes[i].column(column);
    if (found == nullptr || found->values.size() != 1) continue;
    const SobolIndices& indices = found->values.front().sensitivity;
    if (std::any_of(indices.total.begin(), indices.total.end(),
                    [](const SobolIndex& one) { return std::isfinite(one.value); }))
      subjects.push_back({&result.scenes[i], &indices, colour[i]});
  }
  return subjects;
}

std::vector<Row> rows_of(const std::vector<Subject>& subjects) {
  std::vector<Row> rows;
  for (const Subject& subject : subjects)
    for (std::size_t v = 0; v < subject.indices->total.size(); ++v) {
      const std::string& variable = subject.scene->sensitivity_variables[v];
      auto row = std::find_if(rows.begin(), rows.end(),
                              [&](const Row& one) { return one.variable == variable; });
      if (row == rows.end()) row = rows.insert(row, {variable});
      row->greatest = std::max(row->greatest, subject.indices->total[v].value);
    }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.greatest > b.greatest; });
  return rows;
}

// "lubricant.pressure_viscosity" as "pressure viscosity".
std::string field_words(std::string_view path) {
  return in_words(path.substr(path.rfind('.') + 1));
}

std::string index_cells(const SobolIndex& index) {
  return fmt::format("{}\t{}\t{}", exact(index.value), exact(index.low), exact(index.high));
}

int height(double top, std::size_t subjects) {
  constexpr double around = 78 + 92, key_row = 22, least = 480;
  const auto entries = static_cast<double>(subjects > 1 ? subjects + 2 : 2);
  const double key_rows = std::ceil(entries / 3);
  return static_cast<int>(
      std::lround(std::max(around + key_row * key_rows + points_a_bar * top, least)));
}

}  // namespace

std::optional<SweepPicture> sensitivity(const sweep::SweepResult& result, std::string_view column) {
  const std::vector<Subject> subjects = subjects_of(result, column);
  if (subjects.empty()) return std::nullopt;
  std::vector<Row> rows = rows_of(subjects);
  const auto end = std::find_if(rows.begin(), rows.end(),
                                [](const Row& row) { return row.greatest < drawn_from; });
  const auto left_out = static_cast<std::size_t>(rows.end() - end);
  rows.erase(end, rows.end());
  if (rows.empty()) return std::nullopt;

  // In units of a bar.
  const double row_height = static_cast<double>(subjects.size()) + points_between / points_a_bar;
  const double top = row_height * static_cast<double>(rows.size());
  double y = top - points_between / points_a_bar / 2, right = 1;
  std::string variables, bars, scenes;
  for (const Subject& subject : subjects)
    scenes += fmt::format("{}\t{}\t{}\n", cell(subject.scene->id, 24), subject.colour,
                          pale(subject.colour));
  for (const Row& row : rows) {
    variables += fmt::format("{}\t{}\n", y - static_cast<double>(subjects.size()) / 2,
                             cell(field_words(row.variable), 30));
    for (const Subject& subject : subjects) {
      const auto& own = subject.scene->sensitivity_variables;
      const auto place =
          static_cast<std::size_t>(std::find(own.begin(), own.end(), row.variable) - own.begin());
      y -= 1;
      if (place == own.size()) continue;
      const SobolIndex& total = subject.indices->total[place];
      if (std::isfinite(total.high)) right = std::max(right, total.high);
      bars +=
          fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", y + 0.5, 0.42,
                      index_cells(subject.indices->first_order[place]), index_cells(total),
                      subject.colour, pale(subject.colour), cell(subject.scene->id), row.variable);
    }
    y -= points_between / points_a_bar;
  }
  right *= 1.02;
  const std::string blocks = fmt::format(
      "# right\ttop\n{}\t{}\n\n\n# y\tvariable\n{}\n\n"
      "# y\thalf_height\tfirst_order\tfirst_order_low\tfirst_order_high\ttotal\ttotal_low\t"
      "total_high\tcolour\tpale\tscene\tvariable\n{}\n\n"
      "# scene\tcolour\tpale\n{}",
      right, top, variables, bars, scenes);
  std::string stem = fmt::format("sensitivity_{}", column);
  std::replace(stem.begin(), stem.end(), '.', '_');
  return make(
      stem, "sweep_sensitivity.gp",
      fmt::format("What carries the variance: {}", column_words(column)),
      "Sobol indices: the part of the variance that each input brings with all others (pale) and, "
      "of it, alone (full); the lines are the intervals of the former.",
      "Bars of total and first-order Sobol indices, an input a row, the greatest on top.",
      left_out == 0
          ? "Sobol indices, with 95 % intervals of the totals"
          : fmt::format(
                "Sobol indices, with 95 % intervals of the totals; below {} and left out: {} {}",
                drawn_from, left_out, left_out == 1 ? "input" : "inputs"),
      height(top, subjects.size()), blocks);
}

}  // namespace tribo::report
