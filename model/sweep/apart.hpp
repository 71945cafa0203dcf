// SPDX-License-Identifier: Apache-2.0
// Work on foreign files in a child process: a file that makes the reading library crash or hang
// does not harm this process.
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
inline constexpr bool has_sanitizer = true;  // its shadow memory takes terabytes of addresses
#else
inline constexpr bool has_sanitizer = false;
#endif

// Runs `work` in a child process and gives the bytes that it returns there. The child may take some
// seconds of the processor, more for a larger file, twice that time by the clock, and 2 GB of
// memory more than this process. Throws std::runtime_error where `work` throws, with the same text,
// and where the child crashes or is ended at a limit.
Bytes apart(std::uint64_t file_size, const std::function<Bytes()>& work);

}  // namespace tribo::sweep
