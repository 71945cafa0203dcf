// SPDX-License-Identifier: Apache-2.0
// The catalogue of functions as JSON, for the program and for the library of other languages.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.hpp"

namespace tribo::cli {

// The names of parameters, in their order.
std::vector<std::string_view> names_of(std::span<const catalogue::Parameter> parameters);

// The JSON request of a function's example.
nlohmann::ordered_json example_of(const catalogue::Function& function);

// One function (reference/schemas/function.schema.json), and all (functions.schema.json).
nlohmann::ordered_json function_document(const catalogue::Function& function);
nlohmann::ordered_json functions_document();

}  // namespace tribo::cli
