// SPDX-License-Identifier: Apache-2.0
// Why a subject's numbers are off: which known mistakes give just these, or how they are off.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/mistake.hpp"

namespace tribo::conformance {

struct Diagnosis {
  std::string quantity;                     // the one that shows it most
  std::vector<std::string> functions = {};  // whose answers it explains, that of `quantity` first
  std::vector<std::string> mistakes;  // names; none: only how the numbers are off. Several: any of
                                      // these gives the same numbers. "a + b": both at once
  std::size_t explained;              // wrong answers that it gives to the digit
  std::size_t wrong;                  // wrong answers of the function
  std::string text;                   // one sentence or two
  // Functions with the same cause, as a wrong helper, become one diagnosis. Empty: no cause is
  // known.
  std::string cause = {};
};

// A diagnosis of each function that failed: the mistakes that give its numbers, alone or together
// (mistake_search.hpp), of the whole function and then of its branches. Wrong answers that no known
// mistakes give are described: by which powers of the inputs they are off, where, and how. Such
// answers are not told if they are at most 3 for each 100 that named mistakes give.
std::vector<Diagnosis> diagnose(const std::vector<TestCase>& cases,
                                const Conversation& conversation, const Tolerance& tolerance,
                                const std::vector<Mistake>& mistakes);

}  // namespace tribo::conformance
