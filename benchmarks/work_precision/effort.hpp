// SPDX-License-Identifier: Apache-2.0
// How long to measure.
#pragma once

namespace tribo::benchmarks {

struct Effort {
  int rounds = 7;
  double least_seconds = 0.02;
};

}  // namespace tribo::benchmarks
