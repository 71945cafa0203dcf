// SPDX-License-Identifier: Apache-2.0
// Reading sweeps: a scene file in TOML with grids and distributions in place of numbers, and a
// table [sweep] that says how cases are drawn and what is asked of them.
//
//   [lubricant]
//   viscosity = { distribution = "normal", mean = 0.0202, sd = 5e-4 }
//   pressure_viscosity = { printed = "2.0e-8" }            # uniform: 1.95e-8 to 2.05e-8
//
//   [surface]
//   summit_height_sd = [2.5e-8, 5e-8, 1e-7]                # a grid
//   summit_density = { from = 1e10, to = 1e12, count = 9 } # a grid; spacing = "log" or "lin"
//
//   [sweep]
//   onset = ["film_maximum"]
//
// A range or list of `speed` stays what it is in a scene: each case is asked at all of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/plan.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/validity.hpp"

namespace tribo::sweep {

struct SweepReading {
  std::optional<SceneSweep> sweep;     // set when `errors` is empty
  std::vector<InputProblem> errors;    // every problem found
  std::vector<InputProblem> warnings;  // what is legal but has no effect
  // The limits, each once, that the scene passes and does not accept: at its nominal values, and
  // with the least or the greatest value of a grid.
  std::vector<Validity> passed;
};

// One field of [sweep], for the reader, its messages and the help.
struct SweepField {
  std::string_view name;
  std::string_view allowed;
  std::string_view default_text;
  std::string_view meaning;
};
std::span<const SweepField> sweep_fields();

inline constexpr std::uint64_t default_draws = 16384;
inline constexpr std::uint64_t most_cases = 1'000'000'000'000;  // and as many points
inline constexpr std::size_t most_variables = 40;

// `source` names the input in messages. Without its folder and ending it is the default id.
SweepReading parse_sweep(std::string_view text, const std::string& source);
// A regular file of at most 1 MiB; "-" is standard input.
SweepReading read_sweep(const std::string& path);

// Puts the sweeps of some files together. Throws std::invalid_argument where two have one id.
SweepPlan make_plan(std::vector<SceneSweep> scenes);

}  // namespace tribo::sweep
