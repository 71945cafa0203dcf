// SPDX-License-Identifier: Apache-2.0
// Questions as text for a program that answers them itself, and its answers as a conversation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "conformance/conformance_case.hpp"
#include "conformance/conversation.hpp"

namespace tribo::conformance {

// The cases as lines of JSON. Those of cases_to_repeat() follow once more, in reverse order.
std::string question_lines(const std::vector<TestCase>& cases);

// Reads answers, one line of JSON each, as a subject of `verify --subject` writes them. Each has
// the id of its question. A second answer with the same id is that to the repeated question. Throws
// std::invalid_argument if a line is no answer to any of the cases.
Conversation conversation_of(const std::vector<TestCase>& cases, std::string_view lines);

}  // namespace tribo::conformance
