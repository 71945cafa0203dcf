// SPDX-License-Identifier: Apache-2.0
// One line that a subject wrote, as JSON or as a text to show.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tribo::conformance {

// Discarded where the line is no JSON. JSON has no NaN, Infinity or 1e999, but many a library
// writes them: they become texts, so that only the field that has one is wrong.
nlohmann::json read_answer_line(const std::string& line);

// Where a line stops being JSON, with the text around it.
std::string why_no_json(const std::string& line);

// The start of a text, printable, for one line of a message.
std::string start_of(const std::string& text);

}  // namespace tribo::conformance
