// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry to check_stream; an exception that gets out counts as a crash.
#include <cstddef>
#include <cstdint>

#include "stress/fuzz/checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tribo::fuzz::check_stream({reinterpret_cast<const char*>(data), size});
  return 0;
}
