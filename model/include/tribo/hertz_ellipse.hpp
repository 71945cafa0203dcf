// SPDX-License-Identifier: Apache-2.0
// Hertz' elliptical contact of two smooth elastic bodies (model/README.md, section 3). Source: H.
// Hertz: Über die Berührung fester elastischer Körper. J. reine angew. Math. 92 (1881) 156; K. L.
// Johnson: Contact Mechanics (1985), section 4.2(c); integrals: R. Bulirsch: Numerical calculation
// of elliptic integrals and elliptic functions III. Numer. Math. 13 (1969) 305.
//
// With α = R_y/R_x ≥ 1 and q = 1 − 1/k², the axes' ratio k = a_y/a_x solves
//
//   α = (k²E − K)/(K − E) = k² B/D,     B = ∫cos²/√(1 − q sin²), D = ∫sin²/√(1 − q sin²) to π/2,
//
// K = B + D and E = B + D/k² are the complete elliptic integrals of parameter q. B and D are sums
// of positive numbers. So no digits cancel, not even at k = 1, where they cancel in K − E.
#pragma once

#include <cstddef>

#include "tribo/contract.hpp"
#include "tribo/real.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo {

inline constexpr Contract hertz_ellipse_contract{1, 0};

// The shape of an ellipse of contact, which follows from α alone.
template <class T>
struct EllipseShape {
  T ellipticity;      // k ≥ 1, the greater axis over the smaller one
  T first_integral;   // K, of parameter 1 − 1/k²
  T second_integral;  // E
};

namespace detail {

// B and D of Bulirsch's cel(), for 1/k² = 1 − q.
template <class T>
struct AssociatedIntegrals {
  T b, d;
};
template <class T>
AssociatedIntegrals<T> associated_integrals(const T& ellipticity) {
  using std::sqrt;
  const T accuracy = sqrt(epsilon<T>());
  T complement = 1 / ellipticity, e = complement, m = 1, p = 1;
  T b_cos = 1, b_sin = 0, d_cos = 0, d_sin = 1;  // factors of cos² and sin² in B and in D
  for (;;) {
    const T g = e / p, inverse = 1 / p;
    const T b_before = b_cos, d_before = d_cos, m_before = m;
    b_cos += b_sin * inverse;
    d_cos += d_sin * inverse;
    b_sin = 2 * (b_sin + b_before * g);
    d_sin = 2 * (d_sin + d_before * g);
    p += g;
    m += complement;
    if (!(m_before - complement > m_before * accuracy)) break;
    complement = 2 * sqrt(e);
    e = complement * m;
  }
  const T scale = pi<T>() / (2 * m * (m + p));
  return {scale * (b_sin + b_cos * m), scale * (d_sin + d_cos * m)};
}

// d ln α/d ln k = 1 + C/D + C/(k²B), C = (D − B)/q, by its series where D − B would lose digits.
template <class T>
T log_slope(const T& k, const T& b, const T& d) {
  using std::sqrt;
  const T small = sqrt(sqrt(epsilon<T>()));
  const T q = (k - 1) / k * ((k + 1) / k);
  const T c = q < small ? T(pi<T>() / 16 * (1 + q * (ratio<T>(3, 4) + q * ratio<T>(75, 128))))
                        : T((d - b) / q);
  return 1 + c / d + c / b / k / k;  // k² may overflow
}

// The shape in a type wider than T, because roundings of T would add up in the numbers computed
// from it. Newton's method cannot fail here, because α(k) is increasing and convex.
template <class T>
EllipseShape<WiderType<T>> wide_shape(const WiderType<T>& radius_ratio) {
  using std::abs;
  using std::sqrt;
  using Wide = WiderType<T>;
  const T alpha = T(radius_ratio);
  if (!(alpha >= 1)) return {quiet_nan<Wide>(), quiet_nan<Wide>(), quiet_nan<Wide>()};
  if (!is_finite(alpha)) return {alpha, alpha, Wide(1)};
  // The loop ends at a step of at most this size. One more step then leaves only rounding errors.
  const T accuracy = sqrt(sqrt(epsilon<T>())) / 8;
  // A start within 1.5 % for α up to 1e4, with the same bits on every machine.
  const T root = sqrt(alpha), fourth_root = sqrt(root), above = sqrt(fourth_root) - 1;
  T k = root * fourth_root / (1 + above * (ratio<T>(2, 3) + above * ratio<T>(9, 25)));
  for (;;) {
    const auto [b, d] = associated_integrals(k);
    const T step = (alpha / k * (d / b) / k - 1) / log_slope(k, b, d);
    // α(k) is convex: no step leads below the root, and the first step may lead far above it.
    k += k * step;
    if (!(k > 1)) k = 1;
    if (!(abs(step) > accuracy)) break;
  }
  // One more step removes the rounding errors of these steps; dK/d ln k = B, dE/d ln k = −D/k².
  const Wide near = k;
  const auto [b, d] = associated_integrals(near);
  const Wide step = (radius_ratio / near * (d / b) / near - 1) / log_slope(k, T(b), T(d));
  return {near + near * step, b + d + b * step, b + (d - d * step) / near / near};
}

}  // namespace detail

// The shape at radius_ratio α = R_y/R_x ≥ 1; ∞ gives k = ∞, and numbers below 1 give NaN. Error of
// each number: 1 ulp.
template <class T>
EllipseShape<T> ellipse_shape(const T& radius_ratio) {
  const auto shape = detail::wide_shape<T>(radius_ratio);
  return {T(shape.ellipticity), T(shape.first_integral), T(shape.second_integral)};
}

// The radius ratio α = R_y/R_x of the gap whose ellipse of contact has the ellipticity k = a_y/a_x
// > 0. k may be below 1. Error: some ulp.
template <class T>
T radius_ratio_of(const T& ellipticity) {
  if (!(ellipticity >= 1)) return 1 / radius_ratio_of(T(1 / ellipticity));
  const auto [b, d] = detail::associated_integrals(ellipticity);
  return ellipticity * (b / d) * ellipticity;
}

// An ellipse of contact compared with the circle of contact that R_y = R_x would give under the
// same load. The numbers follow from R_x and R_y alone.
template <class T>
struct EllipseOfCircle {
  T axis_cube;   // (a_x/a)³, a³ = 3FR_x/(4E*)
  T axes_ratio;  // k = a_y/a_x, below 1 where R_y < R_x
  T approach;    // the approach over a_x²/R_x: 1 for a circle
};

namespace detail {

template <class T>
EllipseOfCircle<WiderType<T>> wide_ellipse(const T& radius_x, const T& radius_y) {
  using Wide = WiderType<T>;
  const bool is_exchanged = radius_y < radius_x;
  const Wide x = radius_x, y = radius_y;
  const auto [k, first, second] = wide_shape<T>(is_exchanged ? Wide(x / y) : Wide(y / x));
  const Wide reduced = relative_radius(x, y) / x;       // R/R_x, 1/2 for a circle
  const Wide cube = 4 * second * reduced / pi<Wide>();  // of the smaller axis, times k
  const Wide approach = first / (2 * second * reduced);
  if (is_exchanged) return {cube * k * k, 1 / k, approach / k / k};
  return {cube / k, k, approach};
}

// A polynomial in u without the number piece[0], which the caller adds last. Its constant is
// piece[0] + piece[1]. The even and the odd powers in the factor of u are two separate sums.
template <class T, std::size_t count>
T beyond_first(const double (&piece)[count], const T& u) {
  static_assert(count % 2 == 1 && count > 5);
  const T square = u * u;
  T even = piece[count - 3] + square * piece[count - 1];
  T odd = piece[count - 4] + square * piece[count - 2];
  for (std::size_t k = count - 5; k > 2; k -= 2) {
    even = piece[k] + square * even;
    odd = piece[k - 1] + square * odd;
  }
  return piece[1] + u * (piece[2] + square * even + u * odd);
}

}  // namespace detail

// radius_x R_x and radius_y R_y > 0 in m. Error of each number: 1 ulp.
template <class T>
EllipseOfCircle<T> ellipse_of_circle(const T& radius_x, const T& radius_y) {
  const auto ellipse = detail::wide_ellipse(radius_x, radius_y);
  return {T(ellipse.axis_cube), T(ellipse.axes_ratio), T(ellipse.approach)};
}
// In double the same numbers come from polynomials (model/generators/ellipse_pieces.cpp) where the
// greater radius is less than 2¹⁴ times the smaller one, and else from wide_ellipse().
template <>
EllipseOfCircle<double> ellipse_of_circle(const double& radius_x, const double& radius_y);

template <class T>
struct HertzEllipse {
  T semi_axis_x;    // a_x, m: along the direction of entrainment
  T semi_axis_y;    // a_y = k a_x, m
  T ellipticity;    // k = a_y/a_x, below 1 where R_y < R_x
  T mean_pressure;  // F/(πa_xa_y), Pa
  T peak_pressure;  // 3/2 of mean_pressure, Pa
  T approach;       // of the two bodies, m
};

// Hertz' contact on an ellipse that is known already. load F > 0 in N, effective_modulus E* > 0 in
// Pa (never 2E*).
template <class T, class Known>
HertzEllipse<T> hertz_ellipse(const T& load, const T& effective_modulus, const T& radius_x,
                              const EllipseOfCircle<Known>& ellipse) {
  using Wide = WiderType<T>;
  const Wide axis_x = cube_root(
      Wide(3 * Wide(load) * radius_x / (4 * Wide(effective_modulus)) * ellipse.axis_cube));
  const Wide axis_y = axis_x * ellipse.axes_ratio;
  const Wide mean_pressure = load / (pi<Wide>() * axis_x * axis_y);
  return {T(axis_x),
          T(axis_y),
          T(ellipse.axes_ratio),
          T(mean_pressure),
          T(3 * mean_pressure / 2),
          T(axis_x * axis_x / radius_x * ellipse.approach)};
}

// radius_x R_x and radius_y R_y > 0 in m (two_bodies.hpp). Error: hertz_ellipse_contract; overflow
// gives ∞ or NaN, underflow 0. R_x = R_y gives the circle of hertz_point() with R = R_x.
template <class T>
HertzEllipse<T> hertz_ellipse(const T& load, const T& effective_modulus, const T& radius_x,
                              const T& radius_y) {
  return hertz_ellipse(load, effective_modulus, radius_x, detail::wide_ellipse(radius_x, radius_y));
}

}  // namespace tribo
