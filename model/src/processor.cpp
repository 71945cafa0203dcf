// SPDX-License-Identifier: Apache-2.0
#include "processor.hpp"

#include <hwy/targets.h>

#if defined(__x86_64__) && __has_include(<sys/platform/x86.h>)
// The GNU C library has this header from version 2.33 on. It is written in C and uses _Bool, which
// clang does not know in C++.
#define _Bool bool  // NOLINT(bugprone-reserved-identifier)
#include <sys/platform/x86.h>
#undef _Bool
#define TRIBOCHECK_ASKS_C_LIBRARY 1
#endif

namespace tribo::detail {

// In Highway's masks the better target has the lower bit.
std::int64_t switched_off_targets() {
#ifdef TRIBOCHECK_ASKS_C_LIBRARY
  if (!CPU_FEATURE_ACTIVE(AVX2) || !CPU_FEATURE_ACTIVE(FMA)) return HWY_SSE4 - 1;
  if (!CPU_FEATURE_ACTIVE(AVX512F)) return HWY_AVX2 - 1;
#endif
  return 0;
}

}  // namespace tribo::detail
