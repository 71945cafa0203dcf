// SPDX-License-Identifier: Apache-2.0
#include "scene/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "tribo/scene_reader.hpp"

namespace tribo {
namespace scene_detail {
namespace {

struct Utf8Form {
  std::size_t length;
  unsigned char second_least, second_most;  // Unicode 15, table 3-7
};

Utf8Form form_of(unsigned char lead) {
  if (lead < 0x80) return {1, 0, 0};
  if (lead >= 0xC2 && lead <= 0xDF) return {2, 0x80, 0xBF};
  if (lead == 0xE0) return {3, 0xA0, 0xBF};
  if (lead == 0xED) return {3, 0x80, 0x9F};
  if (lead >= 0xE1 && lead <= 0xEF) return {3, 0x80, 0xBF};
  if (lead == 0xF0) return {4, 0x90, 0xBF};
  if (lead >= 0xF1 && lead <= 0xF3) return {4, 0x80, 0xBF};
  if (lead == 0xF4) return {4, 0x80, 0x8F};
  return {0, 0, 0};
}

std::uint32_t code_point(std::string_view sequence) {
  const auto lead = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return lead;
  std::uint32_t code = lead & (0x7Fu >> sequence.size());
  for (const char next : sequence.substr(1))
    code = code << 6 | (static_cast<unsigned char>(next) & 0x3Fu);
  return code;
}

// Signs that would move the cursor, hide, or turn the direction of the text around them.
bool must_be_escaped(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x200B && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
}

void append_hex(std::string& text, std::uint32_t value, int digits) {
  for (int place = digits - 1; place >= 0; --place)
    text += "0123456789abcdef"[value >> (4 * place) & 0xF];
}

void append_escape(std::string& text, std::uint32_t code) {
  if (code == '\n') {
    text += "\\n";
  } else if (code == '\t') {
    text += "\\t";
  } else {
    text += "\\u";
    append_hex(text, code, 4);
  }
}

// Appends the sign at text[at], escaped where it must be. Returns its length in bytes.
std::size_t append_sign(std::string& result, std::string_view text, std::size_t at) {
  const std::size_t length = utf8_length(text, at);
  if (length == 0) {
    result += "\\x";
    append_hex(result, static_cast<unsigned char>(text[at]), 2);
    return 1;
  }
  const std::string_view sequence = text.substr(at, length);
  const std::uint32_t code = code_point(sequence);
  if (must_be_escaped(code))
    append_escape(result, code);
  else
    result += sequence;
  return length;
}

bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F; });
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t at) {
  const Utf8Form form = form_of(static_cast<unsigned char>(text[at]));
  if (form.length < 2) return form.length;
  if (form.length > text.size() - at) return 0;
  const auto second = static_cast<unsigned char>(text[at + 1]);
  if (second < form.second_least || second > form.second_most) return 0;
  for (std::size_t i = 2; i < form.length; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80) return 0;
  return form.length;
}

std::string number_text(double number) {
  std::array<char, 32> buffer{};
  char* const begin = buffer.data();
  std::string text(begin, std::to_chars(begin, begin + buffer.size(), number).ptr);
  const std::size_t exponent = text.find('e');  // 1e-06 becomes 1e-6
  if (exponent != std::string::npos && text[exponent + 2] == '0') text.erase(exponent + 2, 1);
  return text;
}

std::string rounded_text(double number) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 3)
          .ptr;
  return {text.data(), end};
}

std::size_t edit_distance(std::string_view left, std::string_view right) {
  constexpr std::size_t longest = 64;
  if (left.size() > longest || right.size() > longest) return std::max(left.size(), right.size());
  using Row = std::array<std::size_t, longest + 1>;
  Row before_last{}, last{}, now{};
  for (std::size_t j = 0; j <= right.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= left.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t change = left[i - 1] == right[j - 1] ? 0 : 1;
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + change});
      if (i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1])
        now[j] = std::min(now[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = now;
  }
  return last[right.size()];
}

}  // namespace scene_detail

std::string without_controls(std::string_view text) {
  using namespace scene_detail;
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();)
    if (text[at] == '\n' || text[at] == '\t')
      result += text[at++];
    else
      at += append_sign(result, text, at);
  return result;
}

std::string printable(std::string_view text, std::size_t most) {
  using namespace scene_detail;
  if (text.size() <= most && is_plain(text)) return std::string(text);
  std::string result;
  std::size_t at = 0;
  for (std::size_t shown = 0; at < text.size() && shown < most; ++shown)
    at += append_sign(result, text, at);
  return at < text.size() ? result + "…" : result;
}

}  // namespace tribo
