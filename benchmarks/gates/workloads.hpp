// SPDX-License-Identifier: Apache-2.0
// Fixed work of the model's kernels, for the gates: the same points on every machine, and what the
// model's own counters say of it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribo::gates {

using Counters = std::vector<std::pair<std::string, std::uint64_t>>;

struct Workload {
  std::string name;
  bool is_vector;                   // goes by the instruction set of batch.hpp
  std::function<void()> run;        // one pass: some ten to some hundred microseconds
  std::function<Counters()> count;  // work of one pass; empty where the source fixes it
};
using Workloads = std::vector<Workload>;

const Workloads& workloads();
// std::exp over an array: the times of the workloads are compared with its time.
void run_control();

}  // namespace tribo::gates
