// SPDX-License-Identifier: Apache-2.0
// CPU time of many calls, interleaved, so that a disturbance meets all alike.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace tribo::benchmarks {

// The effort of a measurement.
struct Effort {
  int rounds = 7;
  double least_seconds = 0.02;
};

struct Timed {
  std::function<void()> run;
  std::function<double()> own_seconds;  // CPU time of the last call, if in another process
};

// CPU seconds of a call of each function: the median of `rounds` rounds. In a round each function
// is called, in a new random order, until `least` seconds have passed.
std::vector<double> median_seconds(const std::vector<Timed>& all, int rounds, double least);

double cpu_seconds();  // used by this process

}  // namespace tribo::benchmarks
