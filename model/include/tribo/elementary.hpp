// SPDX-License-Identifier: Apache-2.0
// Elementary functions of many numbers in double, by the engine's vectors. A number gets the same
// bits alone and at any place of a batch, on every x86-64 with fused multiply-add. The bits of the
// C library's functions differ between versions of the library. Error: 1 ulp. As in std, NaN gives
// NaN, e^x overflows to infinity, ln 0 is -infinity and ln of a negative number is NaN.
//
// Both spans of a call have one length, and may be the same. Nothing is allocated, nothing throws.
#pragma once

#include <span>

namespace tribo {

void exponential(std::span<const double> x, std::span<double> result);  // e^x
void logarithm(std::span<const double> x, std::span<double> result);    // ln x

}  // namespace tribo
