// SPDX-License-Identifier: Apache-2.0
// On what numbers were computed: two machines that give the same text here give the same bits.
#pragma once

#include <string>

namespace tribo::sweep {

// "AVX3_DL, libm 2.36 5f0c8d1e": the batch kernels' instruction set, the C library's version, and a
// sum over bits that its functions give, as it chooses its code by the processor too.
std::string arithmetic();

}  // namespace tribo::sweep
