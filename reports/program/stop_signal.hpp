// SPDX-License-Identifier: Apache-2.0
// The signals that stop a command: from Ctrl-C, from `kill`, or from a terminal that is closed.
#pragma once

namespace tribo::cli {

// From here on the first signal of each kind is only noted, and a second one of the same kind ends
// the process at once. A file that reaches its size limit makes a write fail, and does not end the
// process.
void watch_for_stop();

// From here on these signals end the process at once again, because little work is lost by that.
void stop_at_once();

// The number of the signal that was noted last, or 0. The exit code of a stopped command is 128
// plus this number.
int stop_signal();

}  // namespace tribo::cli
