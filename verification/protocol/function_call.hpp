// SPDX-License-Identifier: Apache-2.0
// Single functions of the model, as a line of JSON calls them:
//
//   {"id": "f1", "function": "gaussian_moment", "order": 2.5, "argument": -1.146}
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tribo::protocol {

enum class Function : std::uint8_t {
  gaussian_moment,         // order n, argument d
  hertz_point,             // load F, effective_modulus E*, reduced_radius R
  hamrock_dowson_central,  // speed u, viscosity η₀, pressure_viscosity α, F, E*, R, ellipticity k
  starvation_ratio,        // closure, flooded_over_inlet r, damiens_exponent γ
  load_sharing,            // asperity, flooded_film_parameter λ₀, stiffness K, offset δ
};

std::string_view name(Function function);

// In the order above, in SI units; of a word, its place in the enumeration of scene.hpp.
using FunctionArguments = std::array<double, 8>;

struct Mistake {
  std::string field, message;
};

struct FunctionCall {
  std::optional<std::string> id;   // none: not given, or no text
  Function function{};             // these two where there is no mistake,
  FunctionArguments arguments{};   // all in range, defaults filled in
  std::optional<Mistake> mistake;  // the first one in the line
};

// Nothing where the line is no JSON object with a member "function".
std::optional<FunctionCall> read_function_call(std::string_view line);

}  // namespace tribo::protocol
