// SPDX-License-Identifier: Apache-2.0
// The question in a line of JSON: an operating point, which is a scene with one speed, or a single
// function of the model (catalogue.hpp):
//
//   {"id": "f1", "function": "gaussian_moment", "order": 2.5, "argument": -1.146}
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "catalogue/catalogue.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {

struct CallFault {
  std::string field, message;
};

struct FunctionCall {
  std::optional<std::string> id;  // empty: not given, or neither text nor number
  bool id_is_number = false;
  const catalogue::Function* function = nullptr;  // set if there is no fault
  catalogue::Arguments arguments{};  // if there is no fault: in range, with defaults filled in
  std::optional<CallFault> fault;    // the first one found
};

// Both may hold faults in place of a question. A line that is no JSON gives a scene with a fault.
using Question = std::variant<SceneReading, FunctionCall>;

// `number` is the number of the line, for messages.
Question read_question(std::string_view line, std::size_t number);

// The message of the answer to a line that was too long to keep.
inline constexpr std::string_view line_too_long = "the line is over 1 MiB";

// Is the line blank? Blank lines get no answer.
bool is_blank(std::string_view line);

}  // namespace tribo::protocol
