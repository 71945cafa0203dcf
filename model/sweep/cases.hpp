// SPDX-License-Identifier: Apache-2.0
// The cases of a sweep by their numbers: which values the varied fields take.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sweep/design.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

// Two threads must not use one generator at once: each thread has its own.
class CaseGenerator {
 public:
  explicit CaseGenerator(const SceneSweep& sweep);

  // All cases of groups first, first + 1 …, as many as there is room for: variable v of case i is
  // values[i·variables + v]. The cases of a group with sensitivity are A, B, AB_1, AB_2 …
  void groups(std::uint64_t first, std::span<double> values);

 private:
  void draw(std::uint64_t group, std::size_t count);
  void take_from_grids(std::uint64_t group, std::span<double> values) const;
  // Fills in the drawn variables of one case of each group, from their unit numbers.
  void quantiles(Rows<const double> unit, Rows<double> values, std::size_t count);
  void mix(std::span<double> group) const;  // fills in each AB_i of a group from its A and B

  const SceneSweep& sweep_;
  std::size_t grids_, drawn_;
  std::optional<UnitPoints> points_;
  std::vector<double> unit_, normals_;
};

}  // namespace tribo::sweep
