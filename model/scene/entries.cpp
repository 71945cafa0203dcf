// SPDX-License-Identifier: Apache-2.0
#include "scene/entries.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace tribo::scene_detail {
namespace {

constexpr std::size_t longest_source = 4096;
constexpr std::size_t longest_path = 160;

bool is_bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

}  // namespace

std::optional<std::string> line_id(const Value& value) {
  if (value.kind == ValueKind::text) return value.text;
  const double number = value.number;
  if (value.kind != ValueKind::number || value.fault != NumberFault::none ||
      !(std::abs(number) < 0x1p53))
    return std::nullopt;
  std::array<char, 32> text{};
  char* const begin = text.data();
  char* const end = begin + text.size();
  // Whole numbers are written without an exponent, because some readers accept digits only.
  const auto whole = static_cast<std::int64_t>(number);
  const auto written = static_cast<double>(whole) == number ? std::to_chars(begin, end, whole)
                                                            : std::to_chars(begin, end, number);
  return std::string(begin, written.ptr);
}

InputProblem Problems::problem(std::string_view field, Fault fault) const {
  return {printable(source_, longest_source), printable(field, longest_path), std::move(fault)};
}

void Problems::error(std::string_view field, Fault fault) {
  if (reading_.errors.size() > max_problems) return;
  if (reading_.errors.size() == max_problems) {
    field = "";
    fault = {.what = "and more, which are not listed"};
  }
  reading_.errors.push_back(problem(field, std::move(fault)));
}

void Problems::error_at(std::size_t row, std::size_t column, std::string_view field, Fault fault) {
  error(field, std::move(fault));
  reading_.errors.back().row = row;
  reading_.errors.back().column = column;
}

void Problems::warning(std::string_view field, Fault fault) {
  reading_.warnings.push_back(problem(field, std::move(fault)));
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

}  // namespace tribo::scene_detail
