// SPDX-License-Identifier: Apache-2.0
#include "page/typeset.hpp"

namespace tribo::report {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_letter(char c) { return is_lower(c) || (c >= 'A' && c <= 'Z'); }
// A byte of a sign beyond ASCII, such as those of Greek letters.
bool is_beyond_ascii(char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }

// "film_departure_0.05": two small letters or more, then an underscore.
std::size_t identifier_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size() && is_lower(text[length])) ++length;
  if (length < 2 || length == text.size() || text[length] != '_') return 0;
  const auto belongs = [](char c) { return is_lower(c) || is_digit(c) || c == '_' || c == '.'; };
  while (length < text.size() && belongs(text[length])) ++length;
  while (text[length - 1] == '.') --length;
  return length;
}

// Letters and digits; a slash between digits too: F_5/2.
std::size_t subscript_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size() &&
         (is_letter(text[length]) || is_digit(text[length]) ||
          (text[length] == '/' && length > 0 && is_digit(text[length - 1]) &&
           length + 1 < text.size() && is_digit(text[length + 1]))))
    ++length;
  return length;
}

// A number with its sign, 3/2, −0.73, or one letter.
std::size_t exponent_length(std::string_view text) {
  constexpr std::string_view minus = "−";
  std::size_t length = text.starts_with(minus) ? minus.size() : 0;
  const std::size_t first = length;
  while (length < text.size() &&
         (is_digit(text[length]) || ((text[length] == '.' || text[length] == '/') &&
                                     length + 1 < text.size() && is_digit(text[length + 1]))))
    ++length;
  if (length == first) return !text.empty() && is_letter(text[0]) ? 1 : 0;
  return length;
}

}  // namespace

std::string typeset(std::string_view text) {
  std::string made;
  char before = ' ';
  while (!text.empty()) {
    const auto take = [&](std::size_t skip, std::size_t length, char mark) {
      made += mark;
      made += text.substr(skip, length);
      made += mark;
      before = text[skip + length - 1];
      text.remove_prefix(skip + length);
    };
    const char c = text[0];
    const bool in_word = is_letter(before) || is_digit(before) || before == '_';
    if (const std::size_t length = in_word ? 0 : identifier_length(text); length > 0) {
      take(0, length, '`');
    } else if (const std::size_t sub = c == '_' ? subscript_length(text.substr(1)) : 0;
               sub > 0 && (is_letter(before) || is_beyond_ascii(before))) {
      take(1, sub, '~');
    } else if (const std::size_t super = c == '^' ? exponent_length(text.substr(1)) : 0;
               super > 0) {
      take(1, super, '^');
    } else {
      made += c;
      before = c;
      text.remove_prefix(1);
    }
  }
  return made;
}

}  // namespace tribo::report
