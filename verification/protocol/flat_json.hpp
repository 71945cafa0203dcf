// SPDX-License-Identifier: Apache-2.0
// The members of a JSON object that holds no further objects or lists, with what a plain parse
// would hide: keys given twice, and numbers beyond the range of double.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::protocol {

struct FlatMember {
  enum class Kind : std::uint8_t { number, text, other };
  std::string name;
  Kind kind = Kind::other;
  double number = 0;
  std::string text;   // of a text
  std::string fault;  // why a number is none that can be used
};

struct FlatObject {
  std::vector<FlatMember> members;  // in their order; of objects and lists within, nothing
  const FlatMember* find(std::string_view name) const;
};

// Nothing where the text is not JSON, or no object.
std::optional<FlatObject> parse_flat_json(std::string_view text);

}  // namespace tribo::protocol
