// SPDX-License-Identifier: Apache-2.0
// Results that the slow targets left in reference/baselines, with commit, date and machine.
#pragma once

#include <array>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

#include "page/group.hpp"
#include "page/project_files.hpp"

namespace tribo::report {

struct BaselineKind {
  std::string_view file;
  std::string_view target;  // the target of make that writes the file
  std::string_view what;
};

inline constexpr std::array<BaselineKind, 7> baseline_kinds{{
    {"accuracy.json", "baseline", "accuracy that later versions have to keep"},
    {"stress.json", "stress", "random points against long double"},
    {"planted_faults.json", "faults", "planted faults and what caught them"},
    {"work_precision.json", "work-precision", "error against work"},
    {"performance.json", "gate-baseline", "work and time that the gates hold"},
    {"gates.json", "gate-proof", "proof that the gates turn red"},
    {"sweep.json", "bench-sweep", "speed, memory and scaling of sweeps"},
}};

// Throws std::runtime_error where the file is not there or not JSON.
Json read_baseline(const ReportPlaces& places, std::string_view file);

std::runtime_error of_another_shape(const ReportPlaces& places, std::string_view file,
                                    const std::exception& error);

// Gives make(baseline). Throws std::runtime_error where the file is not there, not JSON, or of a
// shape that `make` cannot read.
template <class Make>
auto from_baseline(const ReportPlaces& places, std::string_view file, Make&& make) {
  const Json baseline = read_baseline(places, file);
  try {
    return make(baseline);
  } catch (const Json::exception& error) {
    throw of_another_shape(places, file, error);
  }
}

// When, at which commit and on which machine a baseline was measured.
Json run_of(const Json& baseline);

// A part of a group that it can do without.
struct BaselinePart {
  std::string_view key;  // in the group's data
  std::string_view file;
  std::string_view what;  // the page lists it where it is missing
};
void add_missing(Group& group, const BaselinePart& part, const std::string& why);

// Adds make(baseline) as a part of the group, or {"missing": why} where from_baseline throws.
template <class Make>
void add_part(Group& group, const ReportPlaces& places, const BaselinePart& part, Make&& make) {
  try {
    group.data[std::string(part.key)] = from_baseline(places, part.file, make);
  } catch (const std::exception& error) {
    add_missing(group, part, error.what());
  }
}

// Copies values of one type. Throws Json::exception where one is missing or of another type.
template <class Value>
void copy(const Json& from, std::initializer_list<const char*> keys, Json& to) {
  for (const char* const key : keys) to[key] = from.at(key).get<Value>();
}

// Infinity, and what was not measured, is null in JSON.
inline Json number_or_null(const Json& value) {
  return value.is_null() ? Json() : Json(value.get<double>());
}

}  // namespace tribo::report
