// SPDX-License-Identifier: Apache-2.0
// CPU time of many functions, whose calls are interleaved, so that a disturbance affects all of
// them alike.
#pragma once

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
  std::function<double()> own_seconds{};  // CPU time of the last call, if in another process
};

// CPU seconds of a call of each function: the median of `rounds` rounds. Each round goes through
// the functions in a new random order, and calls each until it has used `least` seconds of CPU
// time; a function with `own_seconds` is called once.
std::vector<double> median_seconds(const std::vector<Timed>& all, int rounds, double least);

double cpu_seconds();  // used by this process

}  // namespace tribo::benchmarks
