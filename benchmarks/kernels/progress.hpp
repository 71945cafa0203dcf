// SPDX-License-Identifier: Apache-2.0
// One line on stderr that each step overwrites, where a person watches.
#pragma once

#include <string_view>

namespace tribo::benchmarks {

void show_progress(std::string_view step);  // empty: wipes the line

}  // namespace tribo::benchmarks
