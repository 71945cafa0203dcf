// SPDX-License-Identifier: Apache-2.0
// Tables with aligned columns, and the same rows as CSV or JSON for machines. A column is as wide
// as its widest cell can be, so that each row can be written at once, and memory does not grow with
// the number of rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "messages.hpp"
#include "protocol/answers.hpp"

namespace tribo::cli {

// Appends any text as one line with its line end. Cells and titles become one line, too.
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

// The head of one column. A name such as "real_area_ratio" takes several lines. The unit stands
// below it: "[m]", "[-]" for a number without a unit, "" for words.
class ColumnHead {
 public:
  ColumnHead(std::string_view name, std::string_view unit, std::size_t least_width);

  std::size_t width() const { return width_; }
  std::size_t line_count() const { return lines_.size(); }
  // Line number `line` of `of` lines; the blank lines are on top.
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

// A column of rows. Tables, CSV and JSON have the same name for it.
struct Column {
  std::string_view name;
  std::string_view unit = {};  // empty: dimensionless
  std::size_t least_width = number_width;
  bool is_word = false;
};

// Rows of typed cells about one scene after the other.
class RowWriter {
 public:
  // Where the reason of an undefined cell is told. `below`: below a table, and not in CSV.
  // `in_rows`: at the end of the row in a table, and in a column of its own in CSV. JSON tells the
  // reason in each row.
  enum class Reasons : std::uint8_t { below, in_rows };

  // The schema of the JSON, and its member that holds the rows.
  struct Document {
    std::string_view schema, rows;
  };

  // format: "table", "csv" or "json". `columns`: those of all scenes, as CSV has one header.
  RowWriter(std::string_view format, OutputStream& output, std::vector<Column> columns,
            Document document, Reasons reasons = Reasons::below);

  // The next rows are about this scene, which has only these columns.
  void begin(std::string_view id, std::string_view title, std::vector<Column> columns);
  // Says below the table of this scene why it has no such column.
  void note(std::string_view name, std::string_view reason) {
    if (is_table_) notes_.emplace_back(name, reason);
  }
  // Adds a row, with a cell for each column of the scene. The texts of the cells must stay valid
  // until the call returns; with Reasons::below until the next begin() or finish().
  void add(std::span<const protocol::OutputValue> cells);
  // `members` stand at the end of the JSON document, after its rows.
  void finish(const nlohmann::ordered_json& members);

 private:
  void add_csv(std::span<const protocol::OutputValue> cells);
  void add_line(std::span<const protocol::OutputValue> cells);
  void end_table();

  bool is_csv_, is_table_;
  OutputStream& output_;
  std::vector<Column> all_, columns_;
  Reasons reasons_;
  std::string id_;           // in CSV quoted
  std::string_view before_;  // the text in front of the next row
  std::vector<ColumnHead> heads_;
  std::vector<std::pair<std::string_view, std::string_view>> notes_;  // name and reason
};

}  // namespace tribo::cli
