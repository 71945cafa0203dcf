// SPDX-License-Identifier: Apache-2.0
#include "scene/entries.hpp"

#include <algorithm>

#include "scene/text.hpp"

namespace tribo {

std::string InputProblem::line() const {
  std::string text = source;
  if (row > 0) text += ':' + std::to_string(row) + ':' + std::to_string(column);
  if (!field.empty()) text += ": " + field;
  return text + ": " + message;
}

namespace scene_detail {
namespace {

constexpr std::size_t longest_source = 4096;
constexpr std::size_t longest_path = 160;
constexpr std::size_t longest_message = 600;

bool is_bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

}  // namespace

InputProblem Problems::problem(std::string_view field, std::string_view message) const {
  return {printable(source_, longest_source), printable(field, longest_path),
          printable(message, longest_message)};
}

void Problems::error(std::string_view field, std::string_view message) {
  if (reading_.errors.size() > max_problems) return;
  if (reading_.errors.size() == max_problems) {
    field = "";
    message = "and more, which are not listed";
  }
  reading_.errors.push_back(problem(field, message));
}

void Problems::error_at(std::size_t row, std::size_t column, std::string_view field,
                        std::string_view message) {
  error(field, message);
  reading_.errors.back().row = row;
  reading_.errors.back().column = column;
}

void Problems::warning(std::string_view field, std::string_view message) {
  reading_.warnings.push_back(problem(field, message));
}

std::string path_part(std::string_view key) {
  if (key.size() < 64 && is_bare(key)) return std::string(key);
  return '"' + printable(key) + '"';
}

std::string too_large_text(std::size_t bytes) {
  if (bytes <= max_scene_bytes) return {};
  return "too large; allowed: at most " + std::to_string(max_scene_bytes) + " bytes";
}

const std::string_view too_many_fields_text = "more than 1000 fields; a scene has far fewer";
const std::string_view too_deep_text = "lists and tables are nested more than 16 deep";

bool nests_too_deep(std::string_view json) {
  std::size_t depth = 0;
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '"') {
      while (++at < json.size() && json[at] != '"')
        if (json[at] == '\\') ++at;
    } else if (c == '[' || c == '{') {
      if (++depth > max_depth) return true;
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return false;
}

}  // namespace scene_detail
}  // namespace tribo
