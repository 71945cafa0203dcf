// SPDX-License-Identifier: Apache-2.0
// Single functions of the model (catalogue.hpp), as a line of JSON calls them:
//
//   {"id": "f1", "function": "gaussian_moment", "order": 2.5, "argument": -1.146}
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "catalogue/catalogue.hpp"

namespace tribo::protocol {

struct Mistake {
  std::string field, message;
};

struct FunctionCall {
  std::optional<std::string> id;                  // not set: not given, or no text
  const catalogue::Function* function = nullptr;  // these two where there is no mistake,
  catalogue::Arguments arguments{};               // all in range, defaults filled in
  std::optional<Mistake> mistake;                 // the first one in the line
};

// Nothing where the line is no JSON object with a member "function".
std::optional<FunctionCall> read_function_call(std::string_view line);

}  // namespace tribo::protocol
