// SPDX-License-Identifier: Apache-2.0
// Known mistakes: what an answer is when one of them is made. Each is a formula that people have
// written, not a guess at a number. They stand in reference/mistakes.toml.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.hpp"

namespace tribo::conformance {

struct Mistake {
  std::string function;  // whose cases it is about
  std::string name;      // "radius-halved"
  std::string text;      // "R/2 in place of R (a ball on a flat has R)"
  // The number it gives for a field of a case; empty: it says nothing of that field or case.
  std::function<std::optional<double>(const nlohmann::json& inputs, std::string_view field)> value;
};

// A mistake in a function of the catalogue, for operating points too, which contain the function.
struct FunctionMistake {
  const catalogue::Function* function;
  std::string name, text;
  // Empty: it says nothing of these arguments.
  std::function<std::optional<catalogue::Results>(const catalogue::Arguments&)> results;
};

// All mistakes of the file, for single functions and for operating points. Throws
// std::runtime_error with one line: file, entry, what is wrong.
std::vector<Mistake> read_mistakes(const std::string& path);

}  // namespace tribo::conformance
