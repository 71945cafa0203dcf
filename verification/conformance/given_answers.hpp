// SPDX-License-Identifier: Apache-2.0
// Questions to who answers them within its own program, and the answers as a conversation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "conformance/conformance_case.hpp"
#include "conformance/conversation.hpp"

namespace tribo::conformance {

// The cases as lines of JSON, and once more those of cases_to_repeat(), in the opposite order.
std::string question_lines(const std::vector<TestCase>& cases);

// Answers, a line of JSON each, as a process of `verify --subject` gives them. Each has the id of
// its question; a second one with the same id is the answer when the case is asked once more.
// Throws std::invalid_argument where a line is no answer to any of the cases.
Conversation conversation_of(const std::vector<TestCase>& cases, std::string_view lines);

}  // namespace tribo::conformance
