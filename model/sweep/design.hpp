// SPDX-License-Identifier: Apache-2.0
// Points of the unit cube by their number. Any point can be computed without those before it, so
// that chunks can be computed anywhere in any order.
//
//   monte_carlo      independent: Philox4x32-10 (Random123) of point, dimension and seed
//   latin_hypercube  each of the N equal cells of a dimension holds one point: a permutation of
//                    the cells by a keyed Feistel network, and a random place in the cell (McKay,
//                    Beckman, Conover 1979)
//   sobol            the digital sequence of Sobol' with the direction numbers of Joe and Kuo
//                    (Boost.Random), from its zeroth point on, with a random digital shift of each
//                    dimension
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "sweep/plan.hpp"

namespace tribo::sweep {

// The middle of one of 2⁵² equal parts of (0, 1), which the leading bits of a word choose.
constexpr double unit_number(std::uint64_t word) {
  return (static_cast<double>(word >> 12) + 0.5) * 0x1p-52;
}
inline constexpr double least_unit_number = 0x1p-53;

// Two threads must not use one object at once: each thread has its own.
class UnitPoints {
 public:
  // design: any but factorial. points: the number of points in all; a Latin hypercube is made for
  // exactly this number, which is at most 2⁴⁸. Throws std::invalid_argument for other values.
  UnitPoints(Design design, std::size_t dimensions, std::uint64_t points, std::uint64_t seed);
  ~UnitPoints();

  // Points first, first + 1 …, as many as there is room for: coordinate d of point i is
  // coordinates[i·dimensions + d], a value of unit_number(). Throws std::out_of_range where the
  // design has no such point.
  void points(std::uint64_t first, std::span<double> coordinates);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tribo::sweep
