// SPDX-License-Identifier: Apache-2.0
// The known mistakes, alone or up to three together, that give the numbers that were answered.
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
  std::size_t changed = 0;        // answers that the first choice changes
  std::size_t met = 0;            // those of them that are as it gives them
  std::vector<AnsweredNumber*> explains;  // the wrong answers that it explains; none: nothing found
  bool is_rough = false;                  // one mistake, met to 0.2 % but not to 1e-5
  std::optional<std::size_t> left_out;    // a result that an unknown mistake changes, too
};

// Searches the cases of one branch, or all if `branch` is empty. A cause changes at least three
// answers and gives 98 % of them. Fewer mistakes come first. One mistake is met to 0.2 % of its
// change (other quadrature, rounded constants), several together to 1e-5.
Cause find_cause(std::vector<AnsweredCase>& cases, const std::vector<Mistake>& mistakes,
                 const std::string& branch);

}  // namespace tribo::conformance
