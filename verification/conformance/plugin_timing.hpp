// SPDX-License-Identifier: Apache-2.0
// The time of a plug-in's calls, in a process that answers to a block of questions with one line.
#pragma once

#include <string>

namespace tribo::conformance {

// Loads the plug-in, and reads questions from stdin. Each empty line ends a block; all questions of
// a block are of one function. The plug-in is called with the whole block as arrays, again and
// again for some milliseconds, and one line answers:
//
//   {"answered": 32, "seconds": 1.9e-8, "wall": 1.9e-8, "control": 2.3e-9}
//
// `answered`: the questions for which it has a result, or says that there is none; they alone are
// timed. `seconds`: CPU time for one of them; `wall`: the same by the clock; `control`: CPU time of
// the control (cpu_time.hpp), before and after. {"error": …}: the block cannot be asked. Throws
// PluginRefused. Returns an exit code.
int time_plugin(const std::string& path);

}  // namespace tribo::conformance
