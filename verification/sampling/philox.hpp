// SPDX-License-Identifier: Apache-2.0
// Random samples of the checks by Philox4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel random
// numbers: as easy as 1, 2, 3, SC11; Random123), which turns a counter into four random words. It
// has no state: sample i is the same whatever was drawn before it.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace tribo::verification {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

inline PhiloxCounter philox_words(PhiloxCounter counter, PhiloxKey key) {
  const auto words =
      r123::Philox4x32()({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
  return {words[0], words[1], words[2], words[3]};
}

}  // namespace tribo::verification
