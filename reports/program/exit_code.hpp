// SPDX-License-Identifier: Apache-2.0
// Exit codes of the program.
#pragma once

namespace tribo::cli {

inline constexpr int exit_done = 0;    // done, all held
inline constexpr int exit_failed = 1;  // a check or gate failed, or results could not be written
inline constexpr int exit_bad = 2;     // bad usage or input

}  // namespace tribo::cli
