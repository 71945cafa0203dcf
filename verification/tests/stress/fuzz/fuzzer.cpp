// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry point. It runs TRIBOCHECK_FUZZED (CMakeLists.txt), the checks of one kind of
// input. An uncaught exception counts as a crash.
#include <cstddef>
#include <cstdint>

#include "stress/fuzz/checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const auto check : tribo::fuzz::TRIBOCHECK_FUZZED)
    check({reinterpret_cast<const char*>(data), size});
  return 0;
}
