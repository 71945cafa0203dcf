// SPDX-License-Identifier: Apache-2.0
// The cases at which roots are timed and judged: Greenwood and Tripp, λ₀ log-uniform in 1e-4…100;
//   wide         K log-uniform in 1e-6…10, δ uniform in 0…3
//   one surface  K = 0.3, δ = 1.146
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "cases/errors.hpp"
#include "cases/measured.hpp"
#include "contenders/root_contender.hpp"

namespace tribo::benchmarks {

enum class RootJob { wide, one_surface };

constexpr std::string_view name(RootJob job) {
  return job == RootJob::wide ? "root_wide" : "root_one_surface";
}

struct StoredRootCases {
  std::vector<double> stiffness, offset, flooded;
  std::vector<double> high, low, condition;  // λ's; empty where λ is not known
  void add(double k, double delta, double lambda0);
  RootCases view(std::size_t first, std::size_t count) const;
  RootCases view() const { return view(0, flooded.size()); }
};

StoredRootCases random_root_cases(RootJob job, std::size_t count);
// The rows of reference/exact within the job's ranges.
const StoredRootCases& certified_root_cases(RootJob job);

Errors judge(const RootContender& contender, RootJob job);

// Each contender at this job.
std::vector<Measured> jobs_of(const std::vector<RootContender>& contenders, RootJob job);

}  // namespace tribo::benchmarks
