// SPDX-License-Identifier: Apache-2.0
// read(2) and write(2) that see through interruptions and descriptors somebody made non-blocking.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

namespace tribo::protocol {

// As read(2) and write(2): −1 and errno at an error that is to be reported.
ssize_t read_some(int descriptor, char* to, std::size_t most);
ssize_t write_some(int descriptor, const char* from, std::size_t count);

// The text of errno, thread-safe.
std::string system_message(int code);

}  // namespace tribo::protocol
