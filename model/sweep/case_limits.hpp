// SPDX-License-Identifier: Apache-2.0
// How many cases of a sweep are beyond which limit of the model's validity.
#pragma once

#include <cstdint>
#include <vector>

#include "sweep/plan_reader.hpp"

namespace tribo::sweep {

// Cases that are looked at, at most: the first draws of some sets of grid values.
inline constexpr std::uint64_t most_judged_cases = 1024;
// A limit that fewer of them pass is a matter of a distribution's tails.
inline constexpr double least_told_part = 0.01;

// Those of reading.passed, and the limits that at least a hundredth of the drawn cases passes, of
// these with the number of cases and the value that is furthest beyond. Of a sweep without a
// distribution reading.passed alone. Takes some milliseconds, and nothing of the sweep itself.
std::vector<Validity> limits_of_cases(const SweepReading& reading);

}  // namespace tribo::sweep
