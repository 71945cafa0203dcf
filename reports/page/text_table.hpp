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

// The signs that a UTF-8 text takes on the screen. Counts code points, because the program's own
// texts have no wide and no combining signs.
std::size_t width_of(std::string_view text);
// With blanks, before it if it stands to the right.
std::string padded(const std::string& text, std::size_t width, bool right = false);

inline constexpr std::size_t any_width = 1'000'000;
// The table in lines of at most `most` signs, or longer ones if a word needs them. Texts and
// headings are wrapped, or the cells of a row are set below each other. The note is left out.
std::string plain_table(const TextTable& table, std::size_t most = any_width);
// A text in lines of at most `most` signs.
std::vector<std::string> wrapped(const std::string& text, std::size_t most);
std::string markdown_table(const TextTable& table);

}  // namespace tribo::report
