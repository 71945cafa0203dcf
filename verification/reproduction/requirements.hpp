// SPDX-License-Identifier: Apache-2.0
// Requirements for an item that fails: the change of a single input that would make the item hold,
// and what else that change does.
#pragma once

#include <string>
#include <vector>

#include "reproduction/evaluation.hpp"

namespace tribo::reproduction {

struct Requirement {
  std::size_t item;  // index
  Field field;
  std::optional<double> sensitivity;     // d ln(number)/d ln(input) at the scene's inputs
  std::optional<double> by_sensitivity;  // of numbers: the factor that it predicts
  std::optional<double> factor;  // the nearest to 1 between 1/30 and 30 at which the item holds
  std::string surface;           // of the values below: the item's surface, or else rough
  std::string unit;              // of the values
  double paper_value;            // the input as the paper has it
  double value;                  // the input at that factor
  double low, high;              // its plausible range
  bool plausible;
  std::vector<std::string> broken, mended;  // claims that the change breaks or mends
};

// For every item that the reading does not reproduce, every input.
std::vector<Requirement> requirements(const PaperScenes& scenes, const Reading& reading,
                                      const std::vector<Item>& items,
                                      const std::vector<ItemResult>& results,
                                      const std::vector<Input>& inputs);

// C1 as a film departure: the ε that gives each surface its reported speed, and the one common ε
// whose greatest factor from the reported speeds is least.
struct CommonDeparture {
  std::array<std::optional<double>, surface_count> own;  // ε for rough, medium, smooth
  double best;                                           // ε for all
  std::array<double, surface_count> factor;              // computed/reported there
};
CommonDeparture common_departure(const PaperScenes& scenes, const Reading& reading,
                                 const std::array<double, surface_count>& reported);

}  // namespace tribo::reproduction
