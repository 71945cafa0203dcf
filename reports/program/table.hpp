// SPDX-License-Identifier: Apache-2.0
// Tables with aligned columns. The columns are as wide as their widest cell can be, so rows can be
// written as they come.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "messages.hpp"

namespace tribo::cli {

// Whatever the text holds, it becomes one line, with its line end. Cells and titles are made so,
// too.
void append_line(Text& to, std::string_view text);

// Spaces and the text, `width` wide; two spaces before it keep the columns apart.
void append_cell(Text& to, std::string_view cell, std::size_t width);

// Five significant digits: "0.76541", "3.8884e-10". Only exponents of three digits take more width.
inline constexpr std::size_t number_width = 10;
std::string readable(double number);

// The width of the longest of some words.
constexpr std::size_t width_of_words(std::span<const std::string_view> words) {
  std::size_t width = 0;
  for (const std::string_view word : words) width = std::max(width, word.size());
  return width;
}

// One column: "real_area_ratio" is written over several lines, its unit last: "[m]", "[-]" for a
// number without one, "" for words.
class ColumnHead {
 public:
  ColumnHead(std::string_view name, std::string_view unit, std::size_t least_width);

  std::size_t width() const { return width_; }
  std::size_t line_count() const { return lines_.size(); }
  // The line-th of `of` lines, with the blank ones on top.
  std::string_view line(std::size_t line, std::size_t of) const;

 private:
  std::vector<std::string> lines_;
  std::size_t width_;
};

void append_heads(Text& to, const std::vector<ColumnHead>& heads);
// A cell under each head.
void append_row(Text& to, const std::vector<ColumnHead>& heads,
                const std::vector<std::string>& cells);

// A title, underlined.
void append_title(Text& to, std::string_view title);

}  // namespace tribo::cli
