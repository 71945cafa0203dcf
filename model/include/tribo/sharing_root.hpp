// SPDX-License-Identifier: Apache-2.0
// The root of load sharing (load_sharing.hpp) of one point in double, by the method of
// src/load_sharing_vector-inl.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "tribo/asperity_contact.hpp"

namespace tribo {
namespace detail {

// One surface, as the double kernels of the root want it.
struct SharingSurface {
  Order order;               // p of F_p
  double stiffness, offset;  // K, δ
  double floor, hazard;      // λ_b, 0 without one; −d ln A/dλ there
  double floor_up_to = 0;    // λ = λ_b to half an ulp for λ₀ from 0 to here
  double film_from = 0;      // λ = λ₀ to half an ulp for λ₀ from here on
  // Without a floor: up to near_zero, −ln A is nearly −ln A(0) + hλ + sλ²/2, and a root starts
  // there.
  double near_zero = 0;
  double share_at_zero = 0, hazard_at_zero = 0, slope_at_zero = 0;  // A(0), h, s
};

// The root λ of one surface at λ₀, and the steps to it. NaN where the kernel leaves it to
// Newton's method: beyond its range, or not there after max_sharing_steps.
struct SharingRoot {
  double film_parameter;
  int iterations;
};
inline constexpr int max_sharing_steps = 16;
SharingRoot film_parameter(const SharingSurface& surface, double flooded_film_parameter);

// Where λ = λ₀ to half an ulp: (λ₀ − δ)² ≥ free_square + free_square_slope·(e + 1), λ₀ ≥ δ, with
// K < 2^{e+1}. F_p(d) ≤ F_p(0) e^{−d²/2} for d ≥ 0, so that with q = 1/2 and p = 5/2
//   ln A ≤ ½ ln(2^{e+1} F_p(0)) − d²/4 ≤ ln(2^−54/0.14);
// with q = 1 and p = 3/2 A is below the square of that. 4 ln(0.14·2^54) + 2 ln F_{5/2}(0) = 140.89
// and 2 ln 2 are rounded up.
inline constexpr double free_square = 141.1, free_square_slope = 1.3863;

}  // namespace detail

// From this λ₀ on, A < 2^−54/0.14 and λ = λ₀ to half an ulp. K in [1e-300, 1e300].
inline double sharing_film_from(double stiffness, double offset) {
  const double exponent = std::ilogb(stiffness) + 1.0;
  return offset +
         std::sqrt(std::max(detail::free_square + detail::free_square_slope * exponent, 0.0));
}

// λ of one point in double: what LoadSharing would give, without the floor that it finds first.
double film_parameter(AsperityModel model, double stiffness, double offset,
                      double flooded_film_parameter);

}  // namespace tribo
