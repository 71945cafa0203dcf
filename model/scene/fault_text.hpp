// SPDX-License-Identifier: Apache-2.0
// Words for an input's value in messages, and the sentence of a fault.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/entries.hpp"

namespace tribo::scene_detail {

// "0.5", "\"abc\"", "true"; empty for lists, tables and the like.
std::string value_text(const Value& value);

// The fault of a value of the wrong kind.
Fault wrong_kind(const Value& value, std::string allowed);

// The fault of a text that is none of the words.
Fault unknown_word(const Value& value, std::span<const std::string_view> words,
                   std::string allowed);

// The fault of a value that the list has already.
Fault repeated(const Value& value);

// "-1 is not allowed; allowed: a number above 0, in m". `field`: the dotted path.
std::string sentence(std::string_view field, const Fault& fault);

}  // namespace tribo::scene_detail
