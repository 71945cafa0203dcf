// SPDX-License-Identifier: Apache-2.0
// Known mistakes: what an answer is when one of them is made. Each is a formula that people have
// written, not a guess at a number.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::conformance {

struct Mistake {
  std::string function;  // whose cases it is about
  std::string name;      // "radius-halved"
  std::string text;      // "R/2 in place of R (a ball on a flat has R)"
  // The number it gives for a field of a case; none: it says nothing of that field or case.
  std::function<std::optional<double>(const nlohmann::json& inputs, std::string_view field)> value;
};

std::vector<Mistake> hertz_mistakes();
std::vector<Mistake> moment_mistakes();
std::vector<Mistake> function_mistakes();  // of all single functions
std::vector<Mistake> point_mistakes();     // of operating points

}  // namespace tribo::conformance
