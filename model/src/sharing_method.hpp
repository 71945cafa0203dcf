// SPDX-License-Identifier: Apache-2.0
// The bounds within which the engine's root of load sharing works.
#pragma once

#include <cstddef>

#include "tribo/gaussian_moment.hpp"

namespace tribo {

// λ = λ₀ to half an ulp if λ₀ ≥ δ and (λ₀ − δ)² ≥ free_square_of(e) + free_square_slope·(k + 1),
// with K < 2^{k+1} and the film's exponent e = a − b. F_p(d) ≤ F_p(0) e^{−d²/2} for d ≥ 0. With
// q = 1/2 and p = 5/2 this gives
//   ln A ≤ ½ ln(2^{k+1} F_p(0)) − d²/4 ≤ ln(2^−54/e);
// with q = 1 and p = 3/2, A is below the square of this bound. 4 ln(0.14·2^54) + 2 ln F_{5/2}(0) =
// 140.89 and 2 ln 2 are rounded up. For another e the first grows by 4 ln(e/0.14) ≤ 4(e/0.14 − 1).
inline constexpr double free_square = 141.1, free_square_slope = 1.3863;
constexpr double free_square_of(double film_exponent) {
  return free_square - 4 + 4 / 0.14 * film_exponent;
}
static_assert(free_square_of(0.14) == free_square);
// A < 2^−54 where (λ − δ)² exceeds the bound above by this number. By the inequality above, A is so
// small where (λ − δ)² is at least 4 ln 2^54 + 2 ln F_{5/2}(0) + 2(k + 1) ln 2. The first two terms
// are 148.76, here 149.
constexpr double square_beyond_free(double film_exponent) {
  return 149 + 4 - free_square - 4 / 0.14 * film_exponent;
}

// The range in which the engine's root may be used: nothing in it overflows or loses digits. Beyond
// this range the template in long double is used.
inline constexpr double sharing_least_stiffness = 1e-300, sharing_greatest_stiffness = 1e300;
inline constexpr double sharing_greatest_offset = 40;
inline constexpr double sharing_least_film = 1e-280, sharing_greatest_film = 1e280;

// film_from of smooth bodies: λ = λ₀ for every λ₀.
inline constexpr double film_from_of_smooth = -1;

// Bounds for the numbers of a contact, and for speeds in m/s. Within them no intermediate result of
// a point overflows or loses digits near 0: the greatest products are K, of eleven such numbers,
// and λ₀/(h_oil/σ_s), of some twelve. K and the factors of area and summits have bounds of their
// own. F_n is set to 0 where it is below the least double; there its product with each of these
// factors has to be below the least double, too.
inline constexpr double least_contact_number = 1e-20, greatest_contact_number = 1e20;
inline constexpr double least_film_ratio = 1e-100;
inline constexpr double least_speed = 1e-60, greatest_speed = 1e60;
inline constexpr double greatest_moment_factor = 1e24;

// The floor, the pole of ln(1 − A), counts as near where its distance in ln λ, (1 − A)/(A |d ln A/d
// ln λ|), is below 1/sharing_pole_nearness: a step from λ₀ would be as short as this distance.
inline constexpr double sharing_pole_nearness = 64;

// A step in y = ln(λ/λ₀) is bounded: λ at most halves, or grows to 3.3 times. Only next to a
// critical stiffness and after a jump that went too far would a step be longer. Without these
// bounds more points are left to Newton's method.
inline constexpr double sharing_least_step = -0.7, sharing_greatest_step = 1.2;

// Where y is below this number, λ is λ₀e^y, off by the rounding of y, at most 2^−57. Beyond it, λ
// is the last λ times e^step, whose rounding is less where the step is short.
inline constexpr double sharing_near_rise = 0.125;

// The number of points that the batch root holds at once, in 55 kB. With blocks of 256, which fit
// into a first-level cache of 32 kB, roots of one surface took 2 % longer with AVX-512 and AVX2
// (EPYC), and all others took the same time to 1 %.
inline constexpr std::size_t sharing_block = 512;

// F_p(0), rounded up.
constexpr double sharing_moment_at_zero(Order order) {
  return order == Order::five_halves ? 0.61664 : 0.43003;
}

}  // namespace tribo
