// SPDX-License-Identifier: Apache-2.0
#include "work_precision/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace tribo::benchmarks {
namespace {

std::string cell(const nlohmann::ordered_json& value, const char* nothing) {
  if (value.is_null()) return nothing;
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string line(const nlohmann::ordered_json& row, const char* nothing) {
  std::string text;
  for (const auto& value : row) text += (text.empty() ? "" : "\t") + cell(value, nothing);
  return text + "\n";
}

std::string heads(const nlohmann::ordered_json& row) {
  std::string text;
  for (const auto& item : row.items()) text += (text.empty() ? "" : "\t") + item.key();
  return text;
}

}  // namespace

double four_digits(double x) { return std::stod(fmt::format("{:.4g}", x)); }

std::string tsv(const Rows& rows) {
  if (rows.empty()) return "";
  std::string text = heads(rows.front()) + "\n";
  for (const auto& row : rows) text += line(row, "");
  return text;
}

std::string tsv_blocks(const Rows& rows, std::string_view key) {
  std::vector<std::string> titles;
  for (const auto& row : rows) {
    const std::string title = row.at(std::string(key));
    if (std::find(titles.begin(), titles.end(), title) == titles.end()) titles.push_back(title);
  }
  std::string text;
  for (const std::string& title : titles) {
    text += (text.empty() ? "" : "\n\n") + ("\"" + title + "\"\n");
    for (const auto& row : rows)
      if (row.at(std::string(key)) == title) text += line(row, "NaN");
  }
  return text;
}

void write_text(const std::string& path, std::string_view text) {
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace tribo::benchmarks
