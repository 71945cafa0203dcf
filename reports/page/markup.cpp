// SPDX-License-Identifier: Apache-2.0
#include "page/markup.hpp"

#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

std::string html_sign(char sign) {
  switch (sign) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return {sign};
  }
}

}  // namespace

std::string escape_markdown(std::string_view text) {
  constexpr std::string_view special = "\\*_[]|#`~^";
  std::string escaped;
  for (const char sign : printable(text, std::string::npos)) {
    if (special.find(sign) != std::string_view::npos) escaped += '\\';
    escaped += sign == '"' ? "\"" : html_sign(sign);
  }
  return escaped;
}

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char sign : without_controls(text)) escaped += html_sign(sign);
  return escaped;
}

}  // namespace tribo::report
