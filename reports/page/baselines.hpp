// SPDX-License-Identifier: Apache-2.0
// What the slow targets left in reference/baselines, with its commit, date and machine.
#pragma once

#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

using Json = nlohmann::ordered_json;

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

// Why a baseline cannot be used, for an exception that JSON gave.
std::runtime_error of_another_shape(const ReportPlaces& places, std::string_view file,
                                    const std::exception& error);

// "`make stress`"; empty for a file that is of no kind.
std::string target_of(std::string_view file);

// “Measured on 2026-11-21 at commit 0123456789ab, in 600 s; processor; compiler.”
std::string provenance(const Json& baseline);

// “Measured on 2026-11-21 at commit 0123456789ab.”
std::string measured_when(const Json& baseline);

// The first twelve digits, and what stands after the hash: “0123456789ab and changes”.
std::string short_commit(const std::string& commit);

// The section that `fill` makes from a baseline. If the baseline is missing or has another shape,
// the section is excused.
template <class Fill>
Section from_baseline(const Section& empty, const ReportPlaces& places, std::string_view file,
                      Fill&& fill) {
  return filled_or_excused(empty, target_of(file), [&](Section& section) {
    const Json baseline = read_baseline(places, file);
    try {
      fill(section, baseline);
    } catch (const Json::exception& error) {
      throw of_another_shape(places, file, error);
    }
  });
}

}  // namespace tribo::report
