// SPDX-License-Identifier: Apache-2.0
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "build_info.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {

using report::width_of;

namespace {

// "real_area_ratio" → "real_area_", "ratio": broken after "_" where the line would be too wide.
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

using protocol::OutputValue;

RowWriter::RowWriter(std::string_view format, OutputStream& output, std::vector<Column> columns,
                     Document document, Reasons reasons)
    : is_csv_(format == "csv"),
      is_table_(format == "table"),
      output_(output),
      all_(std::move(columns)),
      reasons_(reasons),
      before_("") {
  if (!is_csv_ && !is_table_) append(output_.text(), list_start(document.schema, document.rows));
  if (!is_csv_) return;
  append(output_.text(), "id");
  for (const Column& column : all_) append(output_.text(), fmt::format(",{}", column.name));
  append(output_.text(), reasons == Reasons::in_rows ? ",reason\n" : "\n");
  output_.end_row();
}

void RowWriter::begin(std::string_view id, std::string_view title, std::vector<Column> columns) {
  columns_ = std::move(columns);
  id_ = is_csv_ ? report::csv_text(id) : std::string(id);
  if (!is_table_) return;
  end_table();
  append(output_.text(), std::exchange(before_, "\n"));
  append_title(output_.text(), title);
  heads_.clear();
  for (const Column& column : columns_)
    heads_.emplace_back(column.name,
                        column.is_word        ? ""
                        : column.unit.empty() ? "[-]"
                                              : fmt::format("[{}]", column.unit),
                        column.least_width);
  append_heads(output_.text(), heads_);
}

void RowWriter::add(std::span<const OutputValue> cells) {
  if (is_csv_) {
    add_csv(cells);
  } else if (is_table_) {
    add_line(cells);
  } else {
    append(output_.text(), std::exchange(before_, list_comma));
    protocol::AnswerObject answer(output_.text(), {id_});
    for (std::size_t i = 0; i < cells.size(); ++i) answer.value(columns_[i].name, cells[i]);
    answer.close();
  }
  output_.end_row();
}

void RowWriter::add_csv(std::span<const OutputValue> cells) {
  Text& text = output_.text();
  append(text, id_);
  std::size_t next = 0;  // columns_ has the same order as all_
  std::string_view reason;
  for (const Column& column : all_) {
    text.push_back(',');
    if (next == columns_.size() || columns_[next].name != column.name) continue;
    const OutputValue& cell = cells[next++];
    if (!cell.undefined.empty())
      reason = cell.undefined;
    else if (!cell.word.empty())
      append(text, cell.word);
    else
      protocol::append_number(text, cell.number);
  }
  if (reasons_ == Reasons::in_rows) append(text, ',' + report::csv_text(reason));
  text.push_back('\n');
}

void RowWriter::add_line(std::span<const OutputValue> cells) {
  Text& text = output_.text();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const OutputValue& cell = cells[i];
    if (!cell.undefined.empty() && reasons_ == Reasons::in_rows) {
      append(text, fmt::format("  none: {}", cell.undefined));
      break;
    }
    const std::size_t width = heads_[i].width();
    if (!cell.undefined.empty()) {
      append_cell(text, "-", width);
      const std::pair note(columns_[i].name, cell.undefined);
      if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
    } else if (!cell.word.empty()) {
      append_cell(text, cell.word, width);
    } else {
      append_cell(text, readable(cell.number), width);
    }
  }
  text.push_back('\n');
}

void RowWriter::end_table() {
  while (!notes_.empty()) {
    const std::string_view reason = notes_.front().second;
    std::string names;
    for (const auto& note : notes_)
      if (note.second == reason) names += (names.empty() ? "" : ", ") + std::string(note.first);
    append(output_.text(), fmt::format("  - {}: {}\n", names, reason));
    std::erase_if(notes_, [&](const auto& note) { return note.second == reason; });
  }
}

void RowWriter::finish(const nlohmann::ordered_json& members) {
  end_table();
  if (!is_csv_ && !is_table_) append(output_.text(), list_end_with(members));
}

}  // namespace tribo::cli
