// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry to check_toml_scene and check_sweep; an exception that gets out counts as a
// crash.
#include <cstddef>
#include <cstdint>

#include "stress/fuzz/checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  tribo::fuzz::check_toml_scene(text);
  tribo::fuzz::check_sweep(text);
  return 0;
}
