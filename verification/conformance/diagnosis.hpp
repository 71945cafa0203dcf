// SPDX-License-Identifier: Apache-2.0
// Why a subject's numbers are off: which known mistake gives just these, or how they are off.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/mistake.hpp"

namespace tribo::conformance {

struct Diagnosis {
  std::string quantity;               // the one that shows it most
  std::vector<std::string> mistakes;  // names; none: only how the numbers are off. Several: any of
                                      // these gives the same numbers
  std::size_t explained;              // wrong answers that it gives to the digit
  std::size_t wrong;                  // wrong answers of the function
  std::string text;                   // one sentence or two
};

// A diagnosis of each function that failed. One of `mistakes` is named if it would change at least
// three answers and gives at least 98 in 100 of them. Other wrong answers are described too, unless
// a mistake is named and they are at most 3 in 100 of the wrong answers.
std::vector<Diagnosis> diagnose(const std::vector<Case>& cases, const Conversation& conversation,
                                const Tolerance& tolerance, const std::vector<Mistake>& mistakes);

}  // namespace tribo::conformance
