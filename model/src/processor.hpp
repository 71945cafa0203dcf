// SPDX-License-Identifier: Apache-2.0
// The instruction sets that this process may use: those of the processor, except those that the C
// library has been told not to use. GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA switches
// them off for the functions of the C library and for ours alike, so that one machine can run the
// code that another machine would run.
#pragma once

#include <cstdint>

namespace tribo::detail {

// Highway's targets that need an instruction set which is switched off or not there.
std::int64_t switched_off_targets();

}  // namespace tribo::detail
