// SPDX-License-Identifier: Apache-2.0
// Which instruction sets this process may use: those that the processor has, and that the C library
// has not been told to leave alone. GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA switches
// them off for the C library's functions and for ours alike, so that one machine can run what
// another one would.
#pragma once

namespace tribo::detail {

// Fused multiply-add.
bool has_fma();

// Tells Highway to leave out what is switched off. To be called before the first choice of a vector
// kernel.
void leave_out_what_is_switched_off();

}  // namespace tribo::detail
