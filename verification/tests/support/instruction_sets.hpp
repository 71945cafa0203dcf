// SPDX-License-Identifier: Apache-2.0
// Runs batches on each instruction set of the machine; afterwards the best set is in use again.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/case_count.hpp"
#include "tribo/batch.hpp"

namespace tribo::verification {

class WithInstructionSet {
 public:
  explicit WithInstructionSet(std::string_view name) { use_instruction_set(name); }
  ~WithInstructionSet() { use_instruction_set(instruction_sets().front()); }
  WithInstructionSet(const WithInstructionSet&) = delete;
  WithInstructionSet& operator=(const WithInstructionSet&) = delete;
};

// Counts the least number of cases that held on any set, so that the manifest does not depend on
// the machine.
template <class Visitor>
void on_each_instruction_set(Visitor&& visit) {
  ASSERT_GE(instruction_sets().size(), 1u);
  const std::size_t before = case_count.held;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const std::string_view name : instruction_sets()) {
    const WithInstructionSet chosen(name);
    ASSERT_EQ(instruction_set(), name);
    const testing::ScopedTrace trace(__FILE__, __LINE__, std::string(name));
    case_count.held = before;
    visit();
    fewest = std::min(fewest, case_count.held);
  }
  case_count.held = fewest;
}

// A batch of the inputs [first, first + count), by `apply(first, count, result)`, must give the
// same bits as a batch of all inputs, for all sizes up to 40 and all places. It must leave the
// cells on both sides of its result as they are. Sanitizers find reads outside these inputs.
template <class Apply>
void hold_bits_whatever_place_and_size(std::size_t points, Apply&& apply) {
  constexpr std::size_t guards = 16;  // two of the widest vectors, on either side
  const std::vector<double> untouched(guards, -123.456);
  std::vector<double> whole(points);
  apply(std::size_t{0}, points, std::span<double>(whole));
  for (std::size_t count = 0; count <= 40 && count <= points; ++count)
    for (std::size_t first = 0; first + count <= points; ++first) {
      std::vector<double> part(guards + count + guards, untouched.front());
      apply(first, count, std::span(part).subspan(guards, count));
      ASSERT_EQ(std::memcmp(part.data() + guards, whole.data() + first, count * sizeof(double)), 0)
          << count << " from " << first;
      for (const double* const cells : {part.data(), part.data() + guards + count})
        ASSERT_EQ(std::memcmp(cells, untouched.data(), guards * sizeof(double)), 0)
            << count << " from " << first;
    }
}

}  // namespace tribo::verification
