// SPDX-License-Identifier: Apache-2.0
// Times a plug-in's calls. The process answers each block of questions with one line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "catalogue/catalogue.hpp"

namespace tribo::conformance {

// Loads the plug-in, and reads questions from stdin. Each empty line ends a block; all questions of
// a block are of one function. A function is called with the whole block as arrays; operating
// points are solved one by one. This is repeated for some milliseconds. Then one line answers:
//
//   {"answered": 32, "seconds": 1.9e-8, "wall": 1.9e-8, "control": 2.3e-9, "new_over_asked": 1.01}
//
// `answered`: the number of questions that get a result or are undefined; only these are timed.
// `seconds`: CPU time per question; `wall`: wall time per question; `control`: CPU time of a unit
// of the control (cpu_time.hpp), the mean of before and after; `new_over_asked`: the time of new
// cases over that of the same cases asked again, far above 1 if the plug-in keeps its answers.
// If no question is answered, the line has "answered" alone. {"error": …}: the block cannot be
// asked. Throws PluginRefused. Returns the exit code 0 when the input ends.
int time_plugin(const std::string& path);

// The index of the argument that is changed to make a new case: the first one that may be any
// number above zero, or else the last one.
inline std::size_t varied_parameter(const catalogue::Function& function) {
  const auto& parameters = function.parameters;
  const auto found = std::find_if(parameters.begin(), parameters.end(), [](const auto& one) {
    return one.words.empty() && one.range == catalogue::Range::above_zero;
  });
  const auto place = static_cast<std::size_t>(found - parameters.begin());
  return std::min(place, parameters.size() - 1);
}

}  // namespace tribo::conformance
