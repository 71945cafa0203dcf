// SPDX-License-Identifier: Apache-2.0
// On what numbers were computed: two machines that give the same text here give the same bits.
#pragma once

#include <string>

namespace tribo::sweep {

// "FMA, libm 2.36 5f0c8d1e": whether the engine has fused multiply-add, on which alone its bits
// rest; and of the C library, from which the draws take functions, its version and a
// sum over bits that its functions give, as it chooses its code by the processor too.
std::string arithmetic();

}  // namespace tribo::sweep
