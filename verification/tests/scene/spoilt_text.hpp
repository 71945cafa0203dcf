// SPDX-License-Identifier: Apache-2.0
// Random changes of a text in TOML or JSON, with the words and signs that parsers trip over.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::scene_test {

// The parts of a text between its signs |.
inline std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char sign : text)
    if (sign == '|')
      parts.emplace_back();
    else
      parts.back() += sign;
  return parts;
}

// Makes at most one change: adds, takes away, repeats or replaces signs, or cuts the end off.
inline void spoil(std::string& text, std::mt19937_64& random) {
  constexpr std::string_view signs =
      "\"'{}[]=:,.#+-_0123456789eE \t\n\r\\xinfalsetruenull\xc3\xa9\xff\x01";
  static const std::vector<std::string> words = parts_of(
      "1e400|1e-400|-0|-0.0|0.0|01|1.|.5|nan|NaN|-inf|Infinity|null|true|"
      "99999999999999999999|\\u0000|\\ud800|\\n|18446744073709551616|\"\"\"|'''|1979-05-27|"
      "07:32:00|\xed\xa0\x80|é|\xEF\xBB\xBF|surface|\"load\"|{}|[1]|[[|]]|[\"film\"]|"
      "\"a\": 1|, \"load\": 5|\"surface\": {|\"function\": \"hertz_point\", ");
  const auto any_sign = [&] { return signs[random() % signs.size()]; };
  const std::size_t at = random() % (text.size() + 1), length = random() % 12;
  switch (random() % 6) {
    case 0:
      text.insert(at, words[random() % words.size()]);
      break;
    case 1:
      text.insert(at, 1, any_sign());
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(random() % (text.size() + 1), text.substr(at, 4 * length));
      break;
    case 4:
      text.replace(at, std::min<std::size_t>(1, text.size() - at), 1, any_sign());
      break;
    default:
      if (random() % 8 == 0) text.resize(at);
  }
}

}  // namespace tribo::scene_test
