// SPDX-License-Identifier: Apache-2.0
// The time, memory and disk that a sweep will take, from its plan and a few cases at some of its
// speeds. The estimate takes constant memory, and less than a second for each scene; films that a
// sweep solves take longer, as some cases are solved at all speeds.
#pragma once

#include <string>
#include <vector>

#include "sweep/plan.hpp"

namespace tribo::sweep {

struct Needs {
  double seconds = 0;                 // to compute, to write and to read again
  double memory = 0;                  // bytes, at most at any time
  double file = 0, parts = 0;         // bytes; both are there at the end
  std::vector<double> point_seconds;  // of each scene, on one thread
};
// threads: as many as the run would have.
Needs needs_of(const SweepPlan& plan, int threads);

// At least as much as needs_of(), from the plan alone; seconds are not estimated.
Needs most_needs(const SweepPlan& plan, int threads);

// Why a sweep has no room in this machine's memory, or on the disk of its result; empty if it has
// room, or if that cannot be known. Calls needs_of() only where most_needs() does not fit. there:
// bytes of its parts that are on the disk already.
std::string lack_of_room(const SweepPlan& plan, int threads, const std::string& result,
                         double there);

}  // namespace tribo::sweep
