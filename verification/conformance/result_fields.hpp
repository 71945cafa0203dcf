// SPDX-License-Identifier: Apache-2.0
// A solver's answer as one line of JSON.
#pragma once

#include <optional>
#include <string_view>

#include "conformance/serve.hpp"
#include "protocol/text_streams.hpp"

namespace tribo::conformance {

// Appends the whole line with its line end: of a function of the catalogue, or of a scene of which
// `asked` are the outputs.
void append_answer_line(protocol::Text& to, std::optional<std::string_view> id,
                        const Answer<catalogue::Results>& answer,
                        const catalogue::Function& function);
void append_answer_line(protocol::Text& to, std::optional<std::string_view> id,
                        const Answer<PointResult>& answer, OutputSet asked);

// {"id": …, "skip": …}
void append_skip_line(protocol::Text& to, std::optional<std::string_view> id,
                      std::string_view reason);

}  // namespace tribo::conformance
