// SPDX-License-Identifier: Apache-2.0
// The question in a line of JSON: a function of the model, or an operating point, a scene with one
// speed.
#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

#include "protocol/function_call.hpp"
#include "protocol/output_stream.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {

// Either may hold mistakes instead of a question. A line that is no JSON is a scene with a mistake.
using Question = std::variant<SceneReading, FunctionCall>;

// `number` is the line's, for messages.
Question read_question(std::string_view line, std::size_t number);

// The answer to a line that the reader did not keep.
inline constexpr std::string_view line_too_long = "the line is over 1 MiB";

// Is there nothing in the line? Such lines get no answer.
bool is_blank(std::string_view line);

// The answer to a scene with errors. It names the first error only; if the text is not JSON, it
// also gives the column.
void append_first_error(Text& to, const SceneReading& reading);

}  // namespace tribo::protocol
