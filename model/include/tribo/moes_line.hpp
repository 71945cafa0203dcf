// SPDX-License-Identifier: Apache-2.0
// Moes' central film of the fully flooded, smooth line contact, from rigid to elastic bodies and
// from liquids of constant viscosity to Barus' (model/README.md, section 5):
//
//   M = W (2U)^{−1/2},  L = G (2U)^{1/4},  H = (h/R) (2U)^{−1/2},  with U, G and W of
//   film_thickness.hpp, so that 2U = η₀u/(E*R);
//   RI = 3/M,  EI = 2.621 M^{−1/5},  RP = 1.287 L^{2/3},  EP = 1.311 M^{−1/8} L^{3/4},
//   H = {(RI^{7/3} + EI^{7/3})^{3s/7} + (RP^{−7/2} + EP^{−7/2})^{−2s/7}}^{1/s},
//   s = (7 + 8 e^{−2EI/RI})/5.
//
// RI, EI, RP and EP are the films of rigid and elastic bodies in isoviscous and piezoviscous
// liquids. Source: H. Moes: Optimum similarity analysis with applications to elastohydrodynamic
// lubrication. Wear 159 (1992) 57; H. Moes: Lubrication and Beyond. Twente (2000).
#pragma once

#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract moes_line_contract{20, 0};

namespace detail {

// (x^p + y^p)^{1/p} without overflow of the powers, for x and y above 0 and p ≠ 0. is_of_greater
// tells whether p > 0; power(t) is t^|p|, and root(t) is t^{1/p}.
template <class T, class Power, class Root>
T joined(const T& x, const T& y, bool is_of_greater, const Power& power, const Root& root) {
  const bool is_x_first = (x > y) == is_of_greater;
  const T& first = is_x_first ? x : y;
  const T& other = is_x_first ? y : x;
  const T part = is_of_greater ? T(other / first) : T(first / other);
  return first * root(T(1 + power(part)));
}

}  // namespace detail

// The films of the four limits, as H.
template <class T>
struct MoesFilms {
  T rigid, elastic;                            // RI, EI
  T rigid_piezoviscous, elastic_piezoviscous;  // RP, EP
};

// The four films at M > 0 and L ≥ 0. Error: 4 ulp.
template <class T>
MoesFilms<T> moes_films(const T& load_number, const T& material_number) {
  return {T(3 / load_number), T(ratio<T>(2621, 1000) * decimal_power(load_number, Fraction{-1, 5})),
          T(ratio<T>(1287, 1000) * decimal_power(material_number, Fraction{2, 3})),
          T(ratio<T>(1311, 1000) * decimal_power(load_number, Fraction{-1, 8}) *
            decimal_power(material_number, Fraction{3, 4}))};
}

// H at M > 0 and L > 0. Error: 12 ulp.
template <class T>
T moes_line_number(const T& load_number, const T& material_number) {
  using std::exp;
  using std::pow;
  const auto powers = [](const Fraction& f) {
    return [f](const T& x) { return decimal_power(x, f); };
  };
  const auto [rigid, elastic, rigid_piezoviscous, elastic_piezoviscous] =
      moes_films(load_number, material_number);
  const T isoviscous = detail::joined(rigid, elastic, true, powers({7, 3}), powers({3, 7}));
  const T piezoviscous = detail::joined(rigid_piezoviscous, elastic_piezoviscous, false,
                                        powers({7, 2}), powers({-2, 7}));
  const T s = (7 + 8 * exp(T(-2 * (elastic / rigid)))) / 5;
  return detail::joined(
      isoviscous, piezoviscous, true, [&](const T& x) { return T(pow(x, s)); },
      [&](const T& x) { return T(pow(x, T(1 / s))); });
}

// h in m. speed u in m/s (entrainment, the mean of the two surfaces), viscosity η₀ in Pa·s,
// pressure_viscosity α in 1/Pa, load_per_length F/L in N/m, effective_modulus E* in Pa (never 2E*),
// reduced_radius R in m, 1/R = 1/R₁ + 1/R₂; all > 0. Error: moes_line_contract; overflow gives ∞ or
// NaN.
template <class T>
T moes_line(const T& speed, const T& viscosity, const T& pressure_viscosity,
            const T& load_per_length, const T& effective_modulus, const T& reduced_radius) {
  using std::sqrt;
  const T twice_speed_number = viscosity * speed / (effective_modulus * reduced_radius);  // 2U
  const T root = sqrt(twice_speed_number);
  const T load_number = load_per_length / (2 * effective_modulus * reduced_radius) / root;
  const T material_number = 2 * pressure_viscosity * effective_modulus * sqrt(root);
  return reduced_radius * root * moes_line_number(load_number, material_number);
}

}  // namespace tribo
