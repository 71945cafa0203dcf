// SPDX-License-Identifier: Apache-2.0
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "page/text_table.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {

using report::width_of;

namespace {

// "real_area_ratio" → "real_area_", "ratio": broken after "_" where more would be too wide.
std::vector<std::string> broken(std::string_view name, std::size_t width) {
  std::vector<std::string> lines;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find('_'), name.size() - 1) + 1;
    const std::string_view word = name.substr(0, end);
    if (lines.empty() || lines.back().size() + word.size() > width)
      lines.emplace_back(word);
    else
      lines.back() += word;
    name.remove_prefix(end);
  }
  return lines;
}

}  // namespace

void append_line(Text& to, std::string_view text) {
  append(to, printable(text, std::string::npos));
  to.push_back('\n');
}

void append_cell(Text& to, std::string_view cell, std::size_t width) {
  const std::string text = printable(cell, std::string::npos);
  const std::size_t taken = width_of(text);
  for (std::size_t blanks = 2 + (taken < width ? width - taken : 0); blanks > 0; --blanks)
    to.push_back(' ');
  append(to, text);
}

std::string readable(double number) { return fmt::format("{:.5g}", number); }

ColumnHead::ColumnHead(std::string_view name, std::string_view unit, std::size_t least_width)
    : lines_(broken(name, least_width)), width_(least_width) {
  lines_.emplace_back(unit);
  for (const std::string& line : lines_) width_ = std::max(width_, width_of(line));
}

std::string_view ColumnHead::line(std::size_t line, std::size_t of) const {
  const std::size_t blank = of - lines_.size();
  return line < blank ? std::string_view() : std::string_view(lines_[line - blank]);
}

void append_heads(Text& to, const std::vector<ColumnHead>& heads) {
  std::size_t most = 0;
  for (const ColumnHead& head : heads) most = std::max(most, head.line_count());
  for (std::size_t line = 0; line < most; ++line) {
    for (const ColumnHead& head : heads) append_cell(to, head.line(line, most), head.width());
    while (to[to.size() - 1] == ' ') to.resize(to.size() - 1);
    to.push_back('\n');
  }
}

void append_row(Text& to, const std::vector<ColumnHead>& heads,
                const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < heads.size(); ++i) append_cell(to, cells[i], heads[i].width());
  to.push_back('\n');
}

void append_title(Text& to, std::string_view title) {
  const std::string text = printable(title, std::string::npos);
  append_line(to, text);
  for (std::size_t i = width_of(text); i > 0; --i) to.push_back('-');
  to.push_back('\n');
}

}  // namespace tribo::cli
