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

// For each function that failed. A mistake is named where it gives at least 98 in 100 of the
// answers that it would change, three at least, and none that it would leave alone are wrong for
// another reason without being told.
std::vector<Diagnosis> diagnose(const std::vector<Case>& cases, const Conversation& conversation,
                                const Tolerance& tolerance);

}  // namespace tribo::conformance
