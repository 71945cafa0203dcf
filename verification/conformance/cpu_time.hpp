// SPDX-License-Identifier: Apache-2.0
// CPU time of other processes, and of a fixed piece of work, the control. Times of solvers are
// given as multiples of the control's time.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace tribo::conformance {

// CPU seconds of a process and of all below it, to the nanosecond while they live. The time of an
// ended process counts once its parent has waited for it, in clock ticks of the system (10 ms).
double cpu_seconds_of_tree(pid_t top);

// CPU seconds of this process.
double own_cpu_seconds();

// Fixed work of two kinds. `exponentials`: std::exp of an array, as in tribocheck_bench; near to
// what a compiled solver does. `texts`: numbers written, read and looked up by their text; near to
// what an interpreter does.
enum class Control : std::uint8_t { exponentials, texts };

// The name of a control in baselines. It changes when the work changes.
const char* name_of(Control control);

// CPU seconds of one unit of the control's work (an exponential, or a text), measured over at least
// 2 ms.
double control_seconds(Control control);

}  // namespace tribo::conformance
