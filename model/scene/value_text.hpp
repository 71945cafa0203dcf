// SPDX-License-Identifier: Apache-2.0
// Words for an input's value in messages.
#pragma once

#include <string>

#include "scene/entries.hpp"

namespace tribo::scene_detail {

// "0.5", "\"abc\"", "true"; empty for lists, tables and the like.
std::string value_text(const Value& value);

// "\"abc\" is a text", "this is a list"
std::string what_came(const Value& value);

}  // namespace tribo::scene_detail
