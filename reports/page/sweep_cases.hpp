// SPDX-License-Identifier: Apache-2.0
// The kept points of a sweep's result, a row each: what varies, the speed, and each output.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "sweep/result_file.hpp"

namespace tribo::report {

enum class CaseFormat : std::uint8_t { table, csv, json };

// Calls told(text) with the next lines: a table for each scene, one CSV for all scenes, or an
// object of JSON a line. Numbers are unrounded, but in a table, which has the first hundred points.
// `file`: the result. Throws std::invalid_argument where a scene has no points, or more numbers
// than fit into memory comfortably.
void write_sweep_cases(const sweep::SweepResult& result, const sweep::ResultFile& file,
                       CaseFormat format, const std::function<void(std::string_view)>& told);

}  // namespace tribo::report
