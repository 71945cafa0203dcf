// SPDX-License-Identifier: Apache-2.0
#include "page/texts.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char sign : fmt::format("{}", number)) {
    if (sign == '-')
      text += "⁻";
    else
      text += digits[static_cast<std::size_t>(sign - '0')];
  }
  return text;
}

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

std::string exact(double value) { return std::isnan(value) ? "NaN" : fmt::format("{}", value); }

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  if (value < 0) return "−" + rounded(-value, digits);
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t split = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(split + 1));
  if (exponent >= -4 && exponent < 6)
    return fmt::format("{:.{}f}", value, exponent < digits ? digits - 1 - exponent : 0);
  return fmt::format("{} × 10{}", scientific.substr(0, split), superscript(exponent));
}

std::string unrounded(double value) {
  int digits = 1;
  while (digits < 17 && std::stod(fmt::format("{:.{}e}", value, digits - 1)) != value) ++digits;
  return rounded(value, digits);
}

std::string grouped(std::uint64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && digits.size() > 4 && (digits.size() - i) % 3 == 0) text += "\u202F";
    text += digits[i];
  }
  return text;
}

std::string csv_text(std::string_view text) {
  // A spreadsheet takes a text that starts with =, +, -, @ or a tab for a formula, but not -1e-5.
  char* end = nullptr;
  const std::string whole(text);
  const bool is_formula = text.find_first_of("=+-@\t") == 0 &&
                          (std::strtod(whole.c_str(), &end), end != whole.c_str() + whole.size());
  if (!is_formula && text.find_first_of(",\"\r\n\t") == std::string_view::npos) return whole;
  std::string quoted = "\"";
  for (const char sign : text) {
    if (sign == '"') quoted += '"';
    quoted += sign;
  }
  return quoted + '"';
}

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
