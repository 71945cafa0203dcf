// SPDX-License-Identifier: Apache-2.0
// Compares the model in double with the certified tables. Each quantity has a number of cases, its
// errors, the allowed errors and a verdict. |error| ≤ max(n, k·condition) ulp is allowed; n and k
// are declared beside the function.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tribo::verification {

struct QuantityResult {
  std::string quantity;
  std::size_t cases = 0;
  double worst_ulp = 0;
  double worst_ulp_per_condition = 0;
  double allowed_ulp = 0;                // n
  double allowed_ulp_per_condition = 0;  // k; 0: the condition does not count
  double worst_part_of_bound = 0;  // the greatest error/bound; above 1 the quantity has failed
  std::string worst_row;           // id of the row with that error

  bool passed() const { return cases > 0 && worst_part_of_bound <= 1; }
};

// Judges the model by every table in `folder` (reference/exact). Throws std::runtime_error where a
// table cannot be read.
std::vector<QuantityResult> check_accuracy(const std::string& folder);

}  // namespace tribo::verification
