// SPDX-License-Identifier: Apache-2.0
// What the slow targets left in reference/baselines, with its commit, date and machine.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "report/project_files.hpp"

namespace tribo::report {

using Json = nlohmann::ordered_json;

struct BaselineKind {
  std::string_view file;
  std::string_view target;  // of make, that writes it
  std::string_view what;
};

inline constexpr std::array<BaselineKind, 6> baseline_kinds{{
    {"accuracy.json", "baseline", "accuracy that later versions have to keep"},
    {"stress.json", "stress", "random points against long double"},
    {"planted_faults.json", "faults", "planted faults and what caught them"},
    {"work_precision.json", "work-precision", "error against work, and throughput"},
    {"performance.json", "gate-baseline", "work and time that the gates hold"},
    {"gates.json", "gate-proof", "proof that the gates turn red"},
}};

// Throws std::runtime_error where the file is not there or not JSON.
Json read_baseline(const ReportPlaces& places, std::string_view file);

// "`make stress`"; empty for a file that is of no kind.
std::string target_of(std::string_view file);

// “Measured on 2026-11-21 at commit 0123456789ab, in 600 s; processor; compiler.”
std::string provenance(const Json& baseline);

// “Measured on 2026-11-21 at commit 0123456789ab.”
std::string measured_when(const Json& baseline);

// The first twelve digits, and what stands after the hash: “0123456789ab and changes”.
std::string short_commit(const std::string& commit);

}  // namespace tribo::report
