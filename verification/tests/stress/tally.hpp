// SPDX-License-Identifier: Apache-2.0
// The worst errors row by row, and the worst points judged again in ball arithmetic.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "contract/point.hpp"

namespace tribo::verification {

inline constexpr std::uint64_t no_point = std::numeric_limits<std::uint64_t>::max();

// The greatest of the added numbers, and the least index that gave it; their order is of no matter.
struct Worst {
  double value = 0;
  std::uint64_t index = no_point;

  void add(double candidate, std::uint64_t at) {
    if (candidate > value || (candidate == value && at < index)) *this = {candidate, at};
  }
  void add(const Worst& other) { add(other.value, other.index); }
};

// A point that is to be judged again, with its error over the bound.
struct Suspect {
  double part_of_bound;
  std::uint64_t index;
  std::size_t number;  // its place in the point's Evaluation

  // Worse points come first.
  friend bool operator<(const Suspect& a, const Suspect& b) {
    return a.part_of_bound != b.part_of_bound ? a.part_of_bound > b.part_of_bound
                                              : a.index < b.index;
  }
};

struct RowTally {
  std::uint64_t cases = 0;
  Worst ulp, ulp_per_condition, part_of_bound;
  std::uint64_t beyond_contract = 0;
  std::uint64_t not_a_number = 0;
  Worst broken;                   // the first point beyond the contract or without a number
  std::vector<Suspect> suspects;  // a heap with the smallest error/bound on top
};

// The judgement of ball arithmetic on the suspects of a row.
struct ProofTally {
  std::uint64_t cases = 0;
  std::uint64_t undecided = 0;
  Worst ulp, ulp_per_condition;  // of the double
  std::uint64_t beyond_contract = 0;
  Worst long_double_ulp_per_condition;  // of the long double, in its own units
};

class Tally {
 public:
  // Keeps `suspects` points a row.
  explicit Tally(std::size_t suspects);
  void add(std::uint64_t index, const Evaluation& evaluation);
  void merge(const Tally& other);
  const std::vector<RowTally>& rows() const { return rows_; }

 private:
  void keep(RowTally& row, const Suspect& suspect) const;
  std::size_t suspects_;
  std::vector<RowTally> rows_;
};

// The bound on the error of the long double, in its own ε times the condition. It is 1/32 of the
// double's contract of 8 ulp.
inline constexpr double long_double_ulp_per_condition = 500;

// Judges the suspects number `part`, `part` + `parts`, … of all rows in ball arithmetic.
std::vector<ProofTally> prove(const Tally& tally, std::uint64_t seed, std::size_t part,
                              std::size_t parts);
void merge(std::vector<ProofTally>& into, const std::vector<ProofTally>& from);

}  // namespace tribo::verification
