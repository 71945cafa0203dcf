// SPDX-License-Identifier: Apache-2.0
// The timed sweeps: the paper's rough surface, with Sobol' points.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sweep/plan.hpp"

namespace tribo::benchmarks {

struct Workload {
  std::string name;
  std::string what;
  std::vector<std::pair<std::string, std::string>> varied;  // path and TOML
  std::string settings;                                     // lines of [sweep]
};

const std::vector<Workload>& workloads();

// keep: "points" or "summaries".
std::string text_of(const Workload& workload, std::uint64_t draws, std::string_view keep);
sweep::SweepPlan plan_of(const Workload& workload, std::uint64_t draws, std::string_view keep);

}  // namespace tribo::benchmarks
