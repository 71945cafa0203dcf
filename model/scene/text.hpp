// SPDX-License-Identifier: Apache-2.0
// Texts for messages: whatever an input holds, they are one line of valid UTF-8, and short.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tribo::scene_detail {

// Bytes of the well-formed UTF-8 sequence that starts at text[at]; 0 if there is none.
std::size_t utf8_length(std::string_view text, std::size_t at);

// The shortest decimal that reads back to the same double.
std::string number_text(double number);
// The number with three digits.
std::string rounded_text(double number);

// The number of edits (a sign added, removed or changed, or two swapped) between two words.
// Words over 64 bytes count as far from everything.
std::size_t edit_distance(std::string_view left, std::string_view right);

}  // namespace tribo::scene_detail
