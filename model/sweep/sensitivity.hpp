// SPDX-License-Identifier: Apache-2.0
// Sobol indices: the part of a column's variance that each drawn variable causes, alone (first
// order) and together with the others (total).
//
// A group has k + 2 cases: two independent draws A and B, and for each of the k variables a case
// AB_i, which is A with this variable from B. V is the variance over A and B:
//   first order  S_i = E[(f(B) − c)(f(AB_i) − f(A))]/V
//                (Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, eq. 16); c is any
//                constant, here the value at the nominal case, so that little cancels
//   total        T_i = E[(f(A) − f(AB_i))²]/(2V)   (Jansen 1999; eq. 19 of Saltelli et al.)
// A group in which any value is undefined is left out. If more than 1 % of the groups are left out,
// no indices are given: the other groups are no random sample of the draws, and their indices would
// describe other inputs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sweep/bytes.hpp"
#include "sweep/summary.hpp"

namespace tribo::sweep {

// Consecutive groups form this many blocks. The jackknife leaves out one block after the other.
inline constexpr std::size_t jackknife_blocks = 32;
std::size_t block_of(std::uint64_t group, std::uint64_t groups);

// The sums of one column over some groups.
struct SensitivitySums {
  Moments both;                     // f(A) and f(B)
  std::vector<double> first_order;  // of each variable: Σ (f(B) − c)(f(AB_i) − f(A))
  std::vector<double> total;        // of each variable: Σ (f(A) − f(AB_i))²
  std::uint64_t left_out = 0;

  // values: f(A), f(B), f(AB_1) …
  void add(std::span<const double> values, double nominal);
  void merge(const SensitivitySums& other);
  void write(Bytes& to) const;
  static SensitivitySums read(Receiver& from);
};

// The sums of one column in each block.
using SensitivityBlocks = std::array<SensitivitySums, jackknife_blocks>;

// Indices are given if this is true. `groups` of `all` groups have no undefined value.
inline bool has_enough_groups(std::uint64_t groups, std::uint64_t all) {
  constexpr double least_part = 0.99;
  return groups > 0 && static_cast<double>(groups) >= least_part * static_cast<double>(all);
}

// Indices with intervals of 1.96 standard errors to both sides, by the jackknife over blocks; NaN
// where nothing varies, or where too few groups are left.
struct SobolIndices {
  std::vector<Bounded> first_order, total;  // of each variable
  std::uint64_t groups = 0;                 // in which all values are defined
};
SobolIndices sobol_indices(const SensitivityBlocks& blocks);

}  // namespace tribo::sweep
