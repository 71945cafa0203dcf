// SPDX-License-Identifier: Apache-2.0
// Fixed work of the model's kernels, for the gates: the same points on every machine, with the
// model's own counts of the work.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tribo::gates {

using Counters = std::vector<std::pair<std::string, std::uint64_t>>;

struct Workload {
  std::string name;
  bool is_vector;                   // runs on the instruction set that batch.hpp has chosen
  std::function<void()> run;        // one pass, of a few to a few hundred microseconds
  std::function<Counters()> count;  // work of one pass; empty where it never varies
};
using Workloads = std::vector<Workload>;

const Workloads& workloads();
// std::exp over an array: the times of the workloads are compared with its time.
void run_control();

}  // namespace tribo::gates
