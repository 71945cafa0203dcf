// SPDX-License-Identifier: Apache-2.0
// Work on files of others in a child process: a file that crashes or hangs the library which reads
// it does not harm this process.
#pragma once

#include <cstdint>
#include <functional>

#include "sweep/bytes.hpp"

#if defined(__has_feature)
#define TRIBO_HAS_FEATURE(feature) __has_feature(feature)
#else
#define TRIBO_HAS_FEATURE(feature) 0
#endif

namespace tribo::sweep {

#if defined(__SANITIZE_ADDRESS__) || TRIBO_HAS_FEATURE(address_sanitizer)
inline constexpr bool has_sanitizer = true;  // its shadow takes terabytes of addresses
#else
inline constexpr bool has_sanitizer = false;
#endif

// Runs `work` in a child process and gives the bytes that it returns there. The child may take some
// seconds of the processor, more for a larger file, twice that time by the clock, and 2 GB of
// memory more than this process. An exception of `work` is thrown here as std::runtime_error with
// its text; so is the end of a child that crashed or was ended at a limit.
Bytes apart(std::uint64_t file_size, const std::function<Bytes()>& work);

}  // namespace tribo::sweep
