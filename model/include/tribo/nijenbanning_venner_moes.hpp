// SPDX-License-Identifier: Apache-2.0
// The film of the fully flooded, smooth point contact, from rigid to elastic bodies and from
// liquids of constant viscosity to Barus', by Nijenbanning, Venner and Moes (model/README.md,
// section 5):
//
//   M = W (2U)^{−3/4},  L = G (2U)^{1/4},  H = (h/R_x) (2U)^{−1/2},  D = R_x/R_y,  H₀₀ = 1.8/D,
//   RI = 145 (1 + 0.796 D^{14/15})^{−15/7} D^{−1} M^{−2},  s = 1.5 (1 + e^{−1.2x}),
//   EI = 3.18 Q^{−14/25} D^{−1/15} M^{−2/15},  RP = 1.29 (1 + 0.691 D)^{−2/3} L^{2/3},
//   EP = 1.48 Q^{−7/20} D^{−1/24} M^{−1/12} L^{3/4},  Q = 1 + 0.006 ln D + 0.63 D^{4/7},
//   H = {[RI^{3/2} + (EI^{−4} + H₀₀^{−4})^{−3/8}]^{2s/3} + [RP^{−8} + EP^{−8}]^{−s/8}}^{1/s}.
//
// U, G and W are those of film_thickness.hpp. The abstract of the source calls h the central film;
// RI is near the film at the greatest pressure. The printed paper is not at hand. Its public
// transcriptions differ in x and in the first bracket, so that two readings of each are kept.
// Source: G. Nijenbanning, C. H. Venner, H. Moes: Film thickness in elastohydrodynamically
// lubricated elliptic contacts. Wear 176 (1994) 217.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tribo/contract.hpp"
#include "tribo/moes_line.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract nijenbanning_venner_moes_contract{60, 0};

// The ratio x in the exponent s: EI/RI or EI/EP. Solved films of lines and circles are nearer to
// the formula with EI/RI.
enum class MoesExponent : std::uint8_t { elastic_over_rigid, elastic_over_piezoviscous };
inline constexpr auto moes_exponent_words =
    std::to_array<std::string_view>({"ei_over_ri", "ei_over_ep"});
// The first bracket: as above, or [RI^{3s/2} + (EI^{−4} + H₀₀^{−4})^{−3s/8}]^{2/(3s)}.
enum class MoesBracket : std::uint8_t { three_halves, three_halves_of_s };
inline constexpr auto moes_bracket_words =
    std::to_array<std::string_view>({"three_halves", "three_halves_of_s"});

// The films of the limits, as H.
template <class T>
struct MoesPointFilms {
  T rigid, elastic;                            // RI, EI
  T greatest;                                  // H₀₀, which EI does not exceed
  T rigid_piezoviscous, elastic_piezoviscous;  // RP, EP
};

// At M > 0, L ≥ 0 and D = R_x/R_y from 1e-12 to 1e12. Error: 8 ulp.
template <class T>
MoesPointFilms<T> moes_point_films(const T& load_number, const T& material_number,
                                   const T& radius_ratio) {
  using std::log;
  const T& d = radius_ratio;
  const T q = 1 + ratio<T>(6, 1000) * log(d) + ratio<T>(63, 100) * decimal_power(d, {4, 7});
  const T rigid =
      145 * decimal_power(T(1 + ratio<T>(796, 1000) * decimal_power(d, {14, 15})), {-15, 7});
  return {T(rigid / d / (load_number * load_number)),
          T(ratio<T>(318, 100) * decimal_power(q, {-14, 25}) * decimal_power(d, {-1, 15}) *
            decimal_power(load_number, {-2, 15})),
          T(ratio<T>(18, 10) / d),
          T(ratio<T>(129, 100) *
            decimal_power(T(material_number / (1 + ratio<T>(691, 1000) * d)), {2, 3})),
          T(ratio<T>(148, 100) * decimal_power(q, {-7, 20}) * decimal_power(d, {-1, 24}) *
            decimal_power(load_number, {-1, 12}) * decimal_power(material_number, {3, 4}))};
}

// H at M > 0, L > 0 and D = R_x/R_y > 0.
template <class T>
T nijenbanning_venner_moes_number(const T& load_number, const T& material_number,
                                  const T& radius_ratio,
                                  MoesExponent exponent = MoesExponent::elastic_over_rigid,
                                  MoesBracket bracket = MoesBracket::three_halves) {
  using std::exp;
  using std::pow;
  const auto power = [](const Fraction& f) {
    return [f](const T& x) { return decimal_power(x, f); };
  };
  const auto real_power = [](const T& p) { return [p](const T& x) { return T(pow(x, p)); }; };
  const MoesPointFilms<T> of = moes_point_films(load_number, material_number, radius_ratio);
  const T& other =
      exponent == MoesExponent::elastic_over_rigid ? of.rigid : of.elastic_piezoviscous;
  const T s = ratio<T>(3, 2) * (1 + exp(T(-ratio<T>(12, 10) * (of.elastic / other))));
  const T elastic = detail::joined(of.elastic, of.greatest, false, power({4, 1}), power({-1, 4}));
  const T piezoviscous = detail::joined(of.rigid_piezoviscous, of.elastic_piezoviscous, false,
                                        power({8, 1}), power({-1, 8}));
  T isoviscous;
  if (bracket == MoesBracket::three_halves) {
    isoviscous = detail::joined(of.rigid, elastic, true, power({3, 2}), power({2, 3}));
  } else {
    const T p = ratio<T>(3, 2) * s;
    isoviscous = detail::joined(of.rigid, elastic, true, real_power(p), real_power(T(1 / p)));
    isoviscous = pow(isoviscous, T(1 / s));
  }
  return detail::joined(isoviscous, piezoviscous, true, real_power(s), real_power(T(1 / s)));
}

// h in m. speed u in m/s (entrainment, the mean of the two surfaces), viscosity η₀ in Pa·s,
// pressure_viscosity α in 1/Pa, load F in N, effective_modulus E* in Pa (never 2E*), radius_x R_x
// (along the entrainment) and radius_y R_y in m; all > 0. Error: nijenbanning_venner_moes_contract;
// overflow gives ∞ or NaN.
template <class T>
T nijenbanning_venner_moes(const T& speed, const T& viscosity, const T& pressure_viscosity,
                           const T& load, const T& effective_modulus, const T& radius_x,
                           const T& radius_y,
                           MoesExponent exponent = MoesExponent::elastic_over_rigid,
                           MoesBracket bracket = MoesBracket::three_halves) {
  using std::sqrt;
  const T twice_speed_number = viscosity * speed / (effective_modulus * radius_x);  // 2U
  const T root = sqrt(twice_speed_number);
  const T fourth_root = sqrt(root);
  const T load_number = load / (2 * effective_modulus * radius_x * radius_x) / (root * fourth_root);
  const T material_number = 2 * pressure_viscosity * effective_modulus * fourth_root;
  return radius_x * root *
         nijenbanning_venner_moes_number(load_number, material_number, T(radius_x / radius_y),
                                         exponent, bracket);
}

}  // namespace tribo
