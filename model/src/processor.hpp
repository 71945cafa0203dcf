// SPDX-License-Identifier: Apache-2.0
// Which instruction sets this process may use: those that the processor has, and that the C library
// has not been told to leave alone. GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA switches
// them off for the C library's functions and for ours alike, so that one machine can run what
// another one would.
#pragma once

#include <cstdint>

namespace tribo::detail {

// Fused multiply-add.
bool has_fma();

// Highway's targets that need an instruction set which is switched off or not there.
std::int64_t switched_off_targets();

}  // namespace tribo::detail
