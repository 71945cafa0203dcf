// SPDX-License-Identifier: Apache-2.0
// Checks TOML text before toml++ 3.3 parses it, for what toml++ cannot take:
// - non-ASCII bytes outside strings and comments are undefined behaviour in it;
// - tables nested by the thousand (a.b.c.d…) overflow the stack when they are destroyed;
// - tables by the ten thousand take it quadratic time;
// - it stops at a number that fits neither double nor int64, and does not name the field.
// Such numbers are replaced by `inf` and blanks, of equal length, and remembered by their place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/entries.hpp"

namespace tribo::scene_detail {

struct WideNumber {
  std::size_t row, column;
  Value value;
};

struct TableHeader {
  std::size_t row;
  std::string_view name;  // as written between the brackets
};

struct TomlScreen {
  std::string complaint;  // empty: toml++ may have the text
  std::size_t row = 0, column = 0;
  std::vector<WideNumber> wide_numbers;  // by rising place
  std::vector<TableHeader> headers;      // by rising row
};

// Mends `text` without a change of its size. The result has views of `text`. More fields than
// `most_fields` are refused.
TomlScreen screen_toml(std::string& text, std::size_t most_fields);

}  // namespace tribo::scene_detail
