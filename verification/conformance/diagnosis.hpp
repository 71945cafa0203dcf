// SPDX-License-Identifier: Apache-2.0
// Why a subject's numbers are off: the known mistakes that give these numbers, or how they are off.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/mistake.hpp"

namespace tribo::conformance {

struct Diagnosis {
  std::string quantity;                     // has the most wrong answers of this cause
  std::vector<std::string> functions = {};  // with this cause; the function of `quantity` is first
  std::vector<std::string> mistakes;  // names; each gives the same numbers. "a + b": both at once.
                                      // Empty: the text only says how the numbers are off
  std::size_t explained;              // wrong answers that the mistakes give
  std::size_t wrong;                  // wrong answers of the function
  std::string text;                   // one sentence or two
  // Functions with the same cause, such as a wrong helper, become one diagnosis. Empty: no such
  // cause is known.
  std::string cause = {};
};

// Diagnoses each function that failed. Names the mistakes that give its numbers, alone or together
// (mistake_search.hpp), in the whole function and then in its branches. Describes wrong answers
// that no known mistakes give: where and how they are off, and by which powers of the inputs. Up
// to 3 such answers are left out for each 100 wrong answers of the branch that named mistakes give.
std::vector<Diagnosis> diagnose(const std::vector<TestCase>& cases,
                                const Conversation& conversation, const Tolerance& tolerance,
                                const std::vector<Mistake>& mistakes);

}  // namespace tribo::conformance
