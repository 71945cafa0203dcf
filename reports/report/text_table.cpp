// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/markup.hpp"
#include "report/number_text.hpp"

namespace tribo::report {
namespace {

constexpr std::string_view no_entry = "–";

// Signs of UTF-8 text; the report's own texts have none that are wide or combining.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

std::vector<std::string> comparison_cells(const ComparisonTable& table, const ComparisonRow& row) {
  std::vector<std::string> cells{std::string(row.surface), std::string(row.model)};
  if (table.has_criteria) cells.push_back(fmt::format("`{}`", row.criterion));
  cells.push_back(row.computed ? rounded(*row.computed, table.digits) : std::string(no_entry));
  cells.push_back(row.reported ? unrounded(row.reported->value) : std::string(no_entry));
  cells.push_back(row.factor() ? rounded(*row.factor(), 3) : std::string(no_entry));
  cells.push_back(row.in_words);
  return cells;
}

std::string padded(const std::string& text, std::size_t to, bool right) {
  const std::string blanks(to - std::min(to, width(text)), ' ');
  return right ? blanks + text : text + blanks;
}

std::string plain_row(const std::vector<std::string>& cells, const TextTable& table,
                      const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i == 0 ? "" : "  ") + padded(to_plain(cells[i]), widths[i], table.is_number[i]);
  return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

std::string html_row(const std::vector<std::string>& cells, const TextTable& table,
                     bool is_heading) {
  std::string line = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_header = is_heading || i == 0;
    line += fmt::format("<{0}{1}{2}>{3}</{0}>", is_header ? "th" : "td",
                        is_heading  ? " scope=\"col\""
                        : is_header ? " scope=\"row\""
                                    : "",
                        table.is_number[i] ? " class=\"number\"" : "", to_html(cells[i]));
  }
  return line + "</tr>\n";
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + to_markdown(cell) + " |";
  return line + '\n';
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

std::string plain_table(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& heading : table.headings) widths.push_back(width(to_plain(heading)));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], width(to_plain(row[i])));
  std::string text = to_plain(table.caption) + '\n' + plain_row(table.headings, table, widths);
  for (const auto& row : table.rows) text += plain_row(row, table, widths);
  return text;
}

std::string html_table(const TextTable& table) {
  if (table.rows.empty())
    return fmt::format("<p class=\"note\"><strong>{}.</strong> {}</p>\n", to_html(table.caption),
                       to_html(table.note));
  std::string text = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n<table>\n"
      "<caption>{1}</caption>\n<thead>\n{2}</thead>\n<tbody>\n",
      escape_html(to_plain(table.caption)), to_html(table.caption),
      html_row(table.headings, table, true));
  for (const auto& row : table.rows) text += html_row(row, table, false);
  text += "</tbody>\n</table>\n</div>\n";
  if (!table.note.empty()) text += fmt::format("<p class=\"note\">{}</p>\n", to_html(table.note));
  return text;
}

std::string markdown_table(const TextTable& table) {
  if (table.rows.empty())
    return fmt::format("**{}.** {}\n", to_markdown(table.caption), to_markdown(table.note));
  std::string rule = "|";
  for (const bool is_number : table.is_number) rule += is_number ? " ---: |" : " --- |";
  std::string text = fmt::format("**{}**\n\n{}{}\n", to_markdown(table.caption),
                                 markdown_row(table.headings), rule);
  for (const auto& row : table.rows) text += markdown_row(row);
  if (!table.note.empty()) text += fmt::format("\n{}\n", to_markdown(table.note));
  return text;
}

}  // namespace tribo::report
