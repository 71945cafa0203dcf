// SPDX-License-Identifier: Apache-2.0
// A solver's answer as one line of JSON.
#pragma once

#include <optional>
#include <string_view>

#include "conformance/serve.hpp"
#include "protocol/output_stream.hpp"

namespace tribo::conformance {

// Appends the whole line with its line end. `asked` are the outputs of a scene; the result of a
// function has its own.
void append_answer_line(protocol::Text& to, std::optional<std::string_view> id,
                        const Answer<double>& answer, OutputSet asked);
void append_answer_line(protocol::Text& to, std::optional<std::string_view> id,
                        const Answer<HertzResult>& answer, OutputSet asked);
void append_answer_line(protocol::Text& to, std::optional<std::string_view> id,
                        const Answer<PointResult>& answer, OutputSet asked);

// {"id": …, "skip": …}
void append_skip_line(protocol::Text& to, std::optional<std::string_view> id,
                      std::string_view reason);

}  // namespace tribo::conformance
