// SPDX-License-Identifier: Apache-2.0
// Lines on stderr: everything that is not a result.
#pragma once

#include <string_view>

namespace tribo::cli {

// Writes "tribocheck: <text>" as one line. Signs that could steer a terminal are escaped, and a
// stderr that is closed or full is no reason to fail.
void complain(std::string_view text);

// Writes "  <text>" in the same way: a line that belongs to the last.
void complain_more(std::string_view text);

}  // namespace tribo::cli
