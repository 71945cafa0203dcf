// SPDX-License-Identifier: Apache-2.0
// Batches on each instruction set of the machine, and on the best one again afterwards.
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

// Cases count once, as those of the set that held the fewest: the manifest is of no one machine.
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

// Whatever a batch does with places [first, first + count) of its inputs gives the bits that it
// gives when all are asked at once: `apply(first, count, result)`, for all sizes up to 40 and all
// places. Sanitizers see a read or write outside them.
template <class Apply>
void hold_bits_whatever_place_and_size(std::size_t points, Apply&& apply) {
  std::vector<double> whole(points);
  apply(std::size_t{0}, points, std::span<double>(whole));
  for (std::size_t count = 1; count <= 40 && count <= points; ++count)
    for (std::size_t first = 0; first + count <= points; ++first) {
      std::vector<double> part(count);
      apply(first, count, std::span<double>(part));
      ASSERT_EQ(std::memcmp(part.data(), whole.data() + first, count * sizeof(double)), 0)
          << count << " from " << first;
    }
}

}  // namespace tribo::verification
