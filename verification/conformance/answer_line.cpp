// SPDX-License-Identifier: Apache-2.0
#include "conformance/answer_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "scene/entries.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

// NaN, -inf, 1e999 … outside of texts.
std::string with_quoted_non_numbers(const std::string& line) {
  std::string made;
  for (std::size_t i = 0; i < line.size();) {
    const auto is_of_word = [&](std::size_t k) {
      const char c = line[k];
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
    };
    std::size_t end = i + 1;
    if (line[i] == '"') {
      while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, line.size());
      made.append(line, i, end - i);
    } else if (is_of_word(i)) {
      while (end < line.size() && is_of_word(end)) ++end;
      const std::string word = line.substr(i, end - i);
      char* rest = nullptr;
      const double number = std::strtod(word.c_str(), &rest);
      const bool is_non_number = *rest == '\0' && !std::isfinite(number);
      made += is_non_number ? '"' + word + '"' : word;
    } else {
      made += line[i];
    }
    i = end;
  }
  return made;
}

}  // namespace

json read_answer_line(const std::string& line) {
  if (scene_detail::nests_too_deep(line)) return json(json::value_t::discarded);
  const json answer = json::parse(line, nullptr, false);
  return answer.is_discarded() ? json::parse(with_quoted_non_numbers(line), nullptr, false)
                               : answer;
}

std::string why_no_json(const std::string& line) {
  if (scene_detail::nests_too_deep(line))
    return fmt::format("{}: {}", scene_detail::too_deep_text, start_of(line));
  try {
    const json whole = json::parse(line);
    return fmt::format("a JSON {}, no object: {}", whole.type_name(), start_of(line));
  } catch (const json::parse_error& error) {
    constexpr std::size_t around = 40;
    const std::size_t at = std::min(error.byte - std::min<std::size_t>(error.byte, 1), line.size());
    const std::size_t from = at - std::min(at, around);
    const std::string before = (from > 0 ? "…" : "") + printable(line.substr(from, at - from));
    if (at == line.size())
      return fmt::format("no JSON: the line ends too early, after `{}`", before);
    return fmt::format("no JSON at character {}, between `{}` and `{}`", at + 1, before,
                       printable(std::string_view(line).substr(at), around));
  } catch (const json::exception&) {
  }
  return "no JSON object: " + start_of(line);
}

std::string start_of(const std::string& text) { return printable(text, 80); }

}  // namespace tribo::conformance
