// SPDX-License-Identifier: Apache-2.0
// How many comparisons of a test held, and the greatest error/bound. main.cpp prints both after
// each test, and gates/inventory.py compares them with the manifest: a test that no longer compares
// anything fails, and so does a widened bound.
#pragma once

#include <algorithm>
#include <cstddef>

namespace tribo::verification {

struct CaseCount {
  std::size_t held = 0;               // comparisons
  double greatest_part_of_bound = 0;  // error/bound
};

inline CaseCount case_count;

// Every judge calls this for each comparison with a bound, whether it held or not.
inline void record_part_of_bound(double part) {
  case_count.greatest_part_of_bound = std::max(case_count.greatest_part_of_bound, part);
}

}  // namespace tribo::verification
