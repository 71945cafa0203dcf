// SPDX-License-Identifier: Apache-2.0
#include "processor.hpp"

#include <hwy/targets.h>

#include <cstdint>

#if defined(__x86_64__) && __has_include(<sys/platform/x86.h>)
// Of the GNU C library, from 2.33 on, and written in C: clang does not know _Bool in C++.
#define _Bool bool  // NOLINT(bugprone-reserved-identifier)
#include <sys/platform/x86.h>
#undef _Bool
#define TRIBOCHECK_ASKS_C_LIBRARY 1
#endif

namespace tribo::detail {

#ifdef TRIBOCHECK_ASKS_C_LIBRARY

bool has_fma() { return CPU_FEATURE_ACTIVE(FMA); }

// In Highway's masks the better target has the lower bit.
void leave_out_what_is_switched_off() {
  std::int64_t left_out = 0;
  if (!CPU_FEATURE_ACTIVE(AVX512F)) left_out = HWY_AVX2 - 1;
  if (!CPU_FEATURE_ACTIVE(AVX2) || !has_fma()) left_out = HWY_SSE4 - 1;
  // Else what a program that links this library has told Highway stays in force.
  if (left_out != 0) hwy::DisableTargets(left_out);
}

#else

bool has_fma() { return __builtin_cpu_supports("fma"); }
void leave_out_what_is_switched_off() {}

#endif

}  // namespace tribo::detail
