// SPDX-License-Identifier: Apache-2.0
// Work on files of others in a child process: a file that crashes or hangs the library which reads
// it does not harm this process.
#pragma once

#include <cstdint>
#include <functional>

#include "sweep/bytes.hpp"

namespace tribo::sweep {

// Runs `work` in a child process and gives the bytes that it returns there. The child may take some
// seconds of the processor, more for a larger file, twice that time by the clock, and 2 GB of
// memory more than this process. An exception of `work` is thrown here as std::runtime_error with
// its text; so is the end of a child that crashed or was ended at a limit.
Bytes apart(std::uint64_t file_size, const std::function<Bytes()>& work);

}  // namespace tribo::sweep
