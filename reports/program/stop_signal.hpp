// SPDX-License-Identifier: Apache-2.0
// Being stopped: by Ctrl-C, by `kill`, or by a terminal that goes away.
#pragma once

namespace tribo::cli {

// From here on the first of these signals is only noted; the second one ends the process at once. A
// file at its limit shows as a failed write.
void watch_for_stop();

// From here on these signals end the process at once again: what is left to do is soon done anew.
void stop_at_once();

// The signal that was noted, or 0. The exit code of a command that was stopped is 128 and this.
int stop_signal();

}  // namespace tribo::cli
