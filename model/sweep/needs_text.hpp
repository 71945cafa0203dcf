// SPDX-License-Identifier: Apache-2.0
// Time and memory as each --estimate prints them.
#pragma once

#include <string>

namespace tribo::sweep {

std::string bytes_text(double bytes);   // "23.4 MB"
std::string time_text(double seconds);  // "2.3 min"

}  // namespace tribo::sweep
