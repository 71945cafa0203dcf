// SPDX-License-Identifier: Apache-2.0
// Answers that change when the same question is asked again, after other ones.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/conformance_case.hpp"
#include "conformance/conversation.hpp"

namespace tribo::conformance {

// An answer to one quantity, or the reason why there is none.
struct Said {
  std::optional<nlohmann::json> value;
  std::string reason;
};

struct Unsteady {
  std::string quantity;
  std::size_t asked_again = 0, changed = 0;  // cases
  std::string id;                            // of the case whose answers are farthest apart
  Said first, second;                        // its answers
  std::string first_place, second_place;     // Reply::place
  std::string_view unit;
  // The difference of the two answers, relative to the greater one; infinite where one of them is
  // no number.
  double apart = 0;
  // The greatest such difference over the condition, of all cases: this tells rounding in another
  // order from other changes.
  double apart_per_condition = 0;
};

// The quantities with an answer that changes in any bit, in the order of the cases.
std::vector<Unsteady> unsteady_quantities(const std::vector<TestCase>& cases,
                                          const Conversation& conversation);

// One sentence, and a line for each of the first few quantities; empty where none changes.
std::vector<std::string> unsteady_lines(const std::vector<Unsteady>& unsteady);

// "3.2e-08 m, then 3.3e-08 m, 0.03 of it apart".
std::string change_text(const Unsteady& one);

}  // namespace tribo::conformance
