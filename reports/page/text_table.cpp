// SPDX-License-Identifier: Apache-2.0
#include "page/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "page/texts.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

// The words of a text. Parts that belong together are one word: "5 × 10⁻⁶", "± 2 %", "m = 2".
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  bool joins = false;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, end - from);
    from = end + 1;
    if (!words.empty() && (joins || word == "×" || word == "%" || word == "="))
      words.back() += ' ' + word;
    else
      words.push_back(word);
    joins = word == "×" || word == "=" || word == "±" || word == "≥" || word == "<";
  }
  return words;
}

std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& word : words_of(text)) longest = std::max(longest, width_of(word));
  return longest;
}

constexpr std::size_t gap = 2;

std::size_t total_of(const std::vector<std::size_t>& widths) {
  return std::accumulate(widths.begin(), widths.end(), gap * (widths.size() - 1));
}

// Each column is as wide as its widest cell. If the table would be wider than `most`, the widest
// columns are narrowed: first headings are wrapped at words, then texts. Numbers are never wrapped.
std::vector<std::size_t> column_widths(const TextTable& table,
                                       const std::vector<std::vector<std::string>>& cells,
                                       std::size_t most) {
  const std::size_t columns = table.headings.size();
  std::vector<std::size_t> widths(columns), with_whole_cells(columns), least(columns);
  for (std::size_t r = 0; r < cells.size(); ++r)
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t whole = width_of(cells[r][i]), word = longest_word(cells[r][i]);
      widths[i] = std::max(widths[i], whole);
      with_whole_cells[i] = std::max(with_whole_cells[i], r == 0 ? word : whole);
      least[i] = std::max(least[i], r == 0 || !table.is_number[i] ? word : whole);
    }
  for (const auto& floor : {with_whole_cells, least})
    while (total_of(widths) > most) {
      std::size_t widest = columns;
      for (std::size_t i = 0; i < columns; ++i)
        if (widths[i] > floor[i] && (widest == columns || widths[i] > widths[widest])) widest = i;
      if (widest == columns) break;
      --widths[widest];
    }
  return widths;
}

std::string plain_row(const std::vector<std::string>& cells, const TextTable& table,
                      const std::vector<std::size_t>& widths) {
  std::vector<std::vector<std::string>> lines;  // the lines of each cell
  std::size_t height = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    lines.push_back(wrapped(cells[i], widths[i]));
    height = std::max(height, lines.back().size());
  }
  std::string text;
  for (std::size_t at = 0; at < height; ++at) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
      line += std::string(i == 0 ? 0 : gap, ' ') +
              padded(at < lines[i].size() ? lines[i][at] : "", widths[i], table.is_number[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

// A row whose cells do not fit on a line: they stand below each other, each behind its heading.
std::string stacked_row(const std::vector<std::string>& headings,
                        const std::vector<std::string>& cells, std::size_t most) {
  const TextTable line{{}, {}, {false, false}, {}, {}};
  std::size_t widest = 0;
  for (const std::string& heading : headings) widest = std::max(widest, width_of(heading));
  std::string text = cells[0] + '\n';
  for (std::size_t i = 1; i < cells.size(); ++i)
    text += plain_row({"  " + headings[i], cells[i]}, line,
                      {gap + widest, most - std::min(most, widest + 2 * gap)});
  return text;
}

// The table with line ends and control signs escaped, so that each text is one line.
TextTable in_lines(TextTable table) {
  const auto make = [](std::string& text) { text = printable(text, std::string::npos); };
  make(table.caption);
  std::for_each(table.headings.begin(), table.headings.end(), make);
  for (auto& row : table.rows) std::for_each(row.begin(), row.end(), make);
  return table;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + escape_markdown(cell) + " |";
  return line + '\n';
}

}  // namespace

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return right ? blanks + text : text + blanks;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t most) {
  if (width_of(text) <= most) return {text};
  std::vector<std::string> lines;
  for (const std::string& word : words_of(text))
    if (lines.empty() || width_of(lines.back()) + 1 + width_of(word) > most)
      lines.push_back(word);
    else
      lines.back() += ' ' + word;
  return lines;
}

std::string plain_table(const TextTable& raw, std::size_t most) {
  const TextTable table = in_lines(raw);
  std::string text;
  for (const std::string& line : wrapped(table.caption, most)) text += line + '\n';
  if (table.rows.empty()) return text;
  std::vector<std::vector<std::string>> cells{table.headings};
  cells.insert(cells.end(), table.rows.begin(), table.rows.end());
  const std::vector<std::size_t> widths = column_widths(table, cells, most);
  const bool fits = total_of(widths) <= most;
  for (std::size_t r = fits ? 0 : 1; r < cells.size(); ++r)
    text += fits ? plain_row(cells[r], table, widths) : stacked_row(cells[0], cells[r], most);
  return text;
}

std::string markdown_table(const TextTable& table) {
  if (table.rows.empty())
    return fmt::format("**{}.** {}\n", escape_markdown(table.caption), escape_markdown(table.note));
  std::string rule = "|";
  for (const bool is_number : table.is_number) rule += is_number ? " ---: |" : " --- |";
  std::string text = fmt::format("**{}**\n\n{}{}\n", escape_markdown(table.caption),
                                 markdown_row(table.headings), rule);
  for (const auto& row : table.rows) text += markdown_row(row);
  if (!table.note.empty()) text += fmt::format("\n{}\n", escape_markdown(table.note));
  return text;
}

}  // namespace tribo::report
