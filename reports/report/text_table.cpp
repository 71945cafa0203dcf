// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/markup.hpp"

namespace tribo::report {
namespace {

// Signs of UTF-8 text; the report's own texts have none that are wide or combining.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
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

// Numbers are set to the right; texts get a column that is wide enough to read.
std::string column_class(const TextTable& table, std::size_t column) {
  if (table.is_number[column]) return " class=\"number\"";
  std::size_t longest = 0;
  for (const auto& row : table.rows) longest = std::max(longest, width(to_plain(row[column])));
  constexpr std::size_t word = 24, line = 60, paragraph = 200;
  return longest <= word        ? " class=\"word\""
         : longest <= line      ? " class=\"line\""
         : longest <= paragraph ? " class=\"prose\""
                                : " class=\"list\"";
}

std::string html_row(const std::vector<std::string>& cells, const std::vector<std::string>& classes,
                     bool is_heading) {
  std::string line = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_header = is_heading || i == 0;
    line += fmt::format("<{0}{1}{2}>{3}</{0}>", is_header ? "th" : "td",
                        is_heading  ? " scope=\"col\""
                        : is_header ? " scope=\"row\""
                                    : "",
                        classes[i], to_html(cells[i]));
  }
  return line + "</tr>\n";
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + to_markdown(cell) + " |";
  return line + '\n';
}

}  // namespace

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
  constexpr std::size_t many_rows = 25;  // scrolled under their headings
  std::vector<std::string> classes;
  for (std::size_t i = 0; i < table.headings.size(); ++i) classes.push_back(column_class(table, i));
  const bool is_long = table.rows.size() > many_rows;
  std::string text = fmt::format(
      "<div class=\"scroll{3}\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n<table>\n"
      "<caption><span>{1}{4}</span></caption>\n<thead>\n{2}</thead>\n<tbody>\n",
      escape_html(to_plain(table.caption)), to_html(table.caption),
      html_row(table.headings, classes, true), is_long ? " long" : "",
      is_long ? fmt::format(" ({} rows)", table.rows.size()) : "");
  for (const auto& row : table.rows) text += html_row(row, classes, false);
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
