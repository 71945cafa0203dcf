// SPDX-License-Identifier: Apache-2.0
// The machine that this program runs on.
#pragma once

#include <string>

namespace tribo::report {

// "AMD EPYC", and "g++ 12.2.0"; "unknown" where the machine does not tell.
std::string processor_name();
std::string compiler_name();

}  // namespace tribo::report
