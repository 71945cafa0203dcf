// SPDX-License-Identifier: Apache-2.0
// The number of a sweep's cases beyond each limit of the model's validity.
#pragma once

#include <cstdint>
#include <vector>

#include "sweep/plan_reader.hpp"

namespace tribo::sweep {

// The greatest number of judged cases: the first draws of some sets of grid values.
inline constexpr std::uint64_t most_judged_cases = 1024;
// A limit that a smaller part of these cases passes is left out: it concerns only the tails of a
// distribution.
inline constexpr double least_told_part = 0.01;

// The limits of reading.passed, and those that at least a hundredth of the judged cases pass. A
// limit that judged cases pass comes with the number of these cases, and with the value that is
// furthest beyond the limit. For a sweep without a distribution the result is reading.passed alone.
// This takes some milliseconds: the sweep itself is not computed.
std::vector<Validity> limits_of_cases(const SweepReading& reading);

}  // namespace tribo::sweep
