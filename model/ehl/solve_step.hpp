// SPDX-License-Identifier: Apache-2.0
// How a solver ends, and how it may be watched.
#pragma once

#include <cstdint>
#include <functional>

namespace tribo::ehl {

enum class Outcome : std::uint8_t {
  solved,
  not_converged,  // no part of a step led nearer, or the steps were too few
  stopped         // the caller stopped it
};

// The watch is called with this before every step. The work stops where it returns false.
struct Step {
  int cells;
  int step;
  double change;  // of P or H₀ in the step before
};
using Watch = std::function<bool(const Step&)>;

struct NewtonLimits {
  int steps = 40;
  double change = 1e-10;  // greatest change of P and H₀ that may be left at the end
};

}  // namespace tribo::ehl
