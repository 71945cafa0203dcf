// SPDX-License-Identifier: Apache-2.0
// The signals that stop a command: from Ctrl-C, from `kill`, or from a terminal that is closed.
#pragma once

namespace tribo::cli {

// From here on the first of these signals is only noted; the second one ends the process at once. A
// file that reaches its size limit makes a write fail.
void watch_for_stop();

// From here on these signals end the process at once again: the rest of the work is soon repeated.
void stop_at_once();

// The signal that was noted, or 0. The exit code of a command that was stopped is 128 and this.
int stop_signal();

}  // namespace tribo::cli
