// SPDX-License-Identifier: Apache-2.0
// A line of JSON in, the model's answer to it out: operating points and single functions of the
// model. `stream` speaks this, and so does whatever compares the model with another program.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/function_call.hpp"
#include "protocol/output_stream.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {

// Appends the answer, always one whole line with its line end, whatever the input is. `number` is
// the line's, for warnings, which are added to the list.
void append_answer(Text& to, std::string_view line, std::size_t number,
                   std::vector<InputProblem>& warnings);

// {"id": …, "error": {"field": …, "message": …}}
void append_error(Text& to, std::optional<std::string_view> id, std::string_view field,
                  std::string_view message);

// {"id": …, "film": …} for a scene with one speed.
void append_point(Text& to, const Scene& scene, std::optional<std::string_view> id);

// The model's {"id": …, "value": …} to a call, or what is wrong with the call.
void append_function_answer(Text& to, const FunctionCall& call);

}  // namespace tribo::protocol
