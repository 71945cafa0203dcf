// SPDX-License-Identifier: Apache-2.0
// What the slow targets left in reference/baselines, with its commit, date and machine.
#pragma once

#include <array>
#include <string_view>

#include "page/group.hpp"
#include "page/project_files.hpp"

namespace tribo::report {

struct BaselineKind {
  std::string_view file;
  std::string_view target;  // of make, that writes it
  std::string_view what;
};

inline constexpr std::array<BaselineKind, 7> baseline_kinds{{
    {"accuracy.json", "baseline", "accuracy that later versions have to keep"},
    {"stress.json", "stress", "random points against long double"},
    {"planted_faults.json", "faults", "planted faults and what caught them"},
    {"work_precision.json", "work-precision", "error against work, and throughput"},
    {"performance.json", "gate-baseline", "work and time that the gates hold"},
    {"gates.json", "gate-proof", "proof that the gates turn red"},
    {"sweep.json", "bench-sweep", "speed, memory and scaling of sweeps"},
}};

// Throws std::runtime_error where the file is not there or not JSON.
Json read_baseline(const ReportPlaces& places, std::string_view file);

}  // namespace tribo::report
