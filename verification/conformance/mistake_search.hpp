// SPDX-License-Identifier: Apache-2.0
// Which known mistakes, alone or up to three together, give just the numbers that were answered.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// Mistakes that are made together.
using Mistakes = std::vector<const Mistake*>;

struct Cause {
  std::vector<Mistakes> choices;  // each of them gives these numbers; the first is the likeliest
  std::size_t changed = 0;        // answers that the first of them changes
  std::size_t met = 0;            // of those, answers that are as it gives them
  std::vector<AnsweredNumber*> explains;  // the wrong answers that it explains; none: nothing found
  bool is_rough = false;                  // one mistake, met to 0.2 % but not to 1e-5
  std::optional<std::size_t> left_out;    // a result that something else changes, too
};

// Searches all cases, or those of one branch. A cause changes at least three answers and gives at
// least 98 in 100 of them; causes of fewer mistakes come first. One mistake may be met to 0.2 % of
// its change (other quadrature, rounded constants), several together to 1e-5 of it.
Cause find_cause(std::vector<AnsweredCase>& cases, const std::vector<Mistake>& mistakes,
                 const std::string& branch);

}  // namespace tribo::conformance
