// SPDX-License-Identifier: Apache-2.0
// Summits of an isotropic Gaussian face from the spectral moments of its profile, which a
// profilometer gives. Sources: P. R. Nayak: Random process model of rough surfaces. J. Lubr.
// Technol. 93 (1971) 398; J. I. McCool: Relating profile instrument measurements to the functional
// performance of rough surfaces. J. Tribol. 109 (1987) 264.
#pragma once

#include <numbers>

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

// Digits cancel in α − 0.8968: 3 ulp times the condition of m₀, m₂ and m₄ are allowed.
inline constexpr Contract spectral_moments_contract{6, 3};

// Two values of α = m₀m₄/m₂²: the least of all isotropic Gaussian faces (Nayak), and the one at
// which σ_s is 0 (McCool).
inline constexpr double least_isotropic_bandwidth = 1.5;
inline constexpr Fraction bandwidth_without_summits{8968, 10000};

// Offset over σ_s times nβσ_s, from McCool's n, β and offset: 4/√π · (3/8)√π/(6π√3) = 1/(4π√3).
inline constexpr double offset_times_roughness = 1 / (4 * std::numbers::pi * std::numbers::sqrt3);

template <class T>
struct Summits {
  T bandwidth;         // α
  T summit_density;    // n = m₄/(6π√3 m₂), 1/m²
  T summit_radius;     // β = ⅜√(π/m₄), m
  T summit_height_sd;  // σ_s = √((1 − 0.8968/α) m₀), m
  T summit_plane_offset;  // from the mean plane to the mean of the summits, 4√(m₀/(πα)), over σ_s
};

// Moments of the profile, all > 0: m0, m2 and m4 are the mean squares of its heights (m²), slopes
// and curvatures (1/m²). Five NaN where the bandwidth is not above 0.8968, because σ_s² would not
// be above 0. Error: spectral_moments_contract.
//
// Whatever the moments, summit_plane_offset · nβσ_s = offset_times_roughness.
template <class T>
Summits<T> summits_from_spectral_moments(const T& m0, const T& m2, const T& m4) {
  using std::sqrt;
  const T bandwidth = m0 / m2 * (m4 / m2);
  const T excess = bandwidth - ratio<T>(bandwidth_without_summits);
  if (!(excess > 0)) {
    const T nan = quiet_nan<T>();
    return {nan, nan, nan, nan, nan};
  }
  return {bandwidth, m4 / (6 * pi<T>() * sqrt(T(3)) * m2), 3 * sqrt(T(pi<T>() / m4)) / 8,
          sqrt(T(excess / bandwidth * m0)), 4 / sqrt(T(pi<T>() * excess))};
}

}  // namespace tribo
