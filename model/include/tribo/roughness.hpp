// SPDX-License-Identifier: Apache-2.0
// Root-mean-square roughness as profilers give it (ISO 4287, now ISO 21920: Rq and Ra).
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract lambda_ratio_contract{4, 0};

// Rq = √(π/2) Ra of a face whose heights are Gaussian, in the unit of Ra > 0: the mean of |z| is
// √(2/π) of the standard deviation. Error: 2 ulp.
template <class T>
T rms_from_average_roughness(const T& average) {
  using std::sqrt;
  return sqrt(T(pi<T>() / 2)) * average;
}

// The composite roughness √(Rq₁² + Rq₂²) of two faces whose heights do not depend on each other, in
// their unit; both > 0. Error: 2 ulp, for any two numbers: squares do not overflow or underflow.
template <class T>
T composite_roughness(const T& first, const T& second) {
  using std::sqrt;
  const bool is_first_greater = first > second;
  const T& greater = is_first_greater ? first : second;
  const T& less = is_first_greater ? second : first;
  const T part = less / greater;
  return greater * sqrt(T(1 + part * part));
}

}  // namespace tribo
