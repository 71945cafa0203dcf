// SPDX-License-Identifier: Apache-2.0
// Lines of JSON from a reader, an answer to each: `stream` without its descriptors and its stderr.
#pragma once

#include <functional>

#include "protocol/line_reader.hpp"
#include "protocol/output_stream.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {

// Answers all lines but blank ones, in order, until the input ends. A program that waits for each
// answer gets it before it must ask again: the output is flushed whenever no complete line is
// waiting.
void answer_lines(LineReader& lines, OutputStream& output,
                  const std::function<void(const InputProblem&)>& warn);

}  // namespace tribo::protocol
