// SPDX-License-Identifier: Apache-2.0
// A table of texts, for a terminal and as Markdown.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::report {

struct TextTable {
  std::string caption;
  std::vector<std::string> headings;
  std::vector<bool> is_number;  // columns of numbers are set to the right
  std::vector<std::vector<std::string>> rows;
  std::string note;
};

// How many signs a text of UTF-8 takes on the screen; the program's own texts have none that are
// wide or combining.
std::size_t width_of(std::string_view text);

inline constexpr std::size_t any_width = 1'000'000;
// The table in lines of at most `most` signs, if its words are short enough: texts and headings are
// wrapped, or the cells of a row are set below each other. The note is left out.
std::string plain_table(const TextTable& table, std::size_t most = any_width);
// A text in lines of at most `most` signs.
std::vector<std::string> wrapped(const std::string& text, std::size_t most);
std::string markdown_table(const TextTable& table);

}  // namespace tribo::report
