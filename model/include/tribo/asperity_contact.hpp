// SPDX-License-Identifier: Apache-2.0
// Rough contact after Greenwood and Tripp (GT, two rough faces) and Greenwood and Williamson (GW,
// one rough face) (model/README.md, section 4; paper, eqs 1.2 to 1.6 and 1.19, corrected). In both
// models the summits are paraboloids with Gaussian heights, in Hertz contact. At the separation
// λσ_s of the mean planes, with d = λ − δ:
//
//                     load share before sharing   real area / A_nom   summits in contact
//   GT  K F_{5/2}(d), K = (16√2π/15)(nβσ_s)²√(σ_s/β) E* A_nom/F
//                                                 π²(nβσ_s)² F_2(d)   4π(nβσ_s) n A_nom F_1(d)
//   GW  K F_{3/2}(d), K = (4/3) n√β σ_s^{3/2} E* A_nom/F
//                                                 π nβσ_s F_1(d)      n A_nom F_0(d)
//
// Load sharing (load_sharing.hpp) turns the first column into A = (K F_p)^q.
//
// Source: J. A. Greenwood, J. H. Tripp: The contact of two nominally flat rough surfaces. Proc.
// Inst. Mech. Eng. 185 (1970) 625, doi 10.1243/PIME_PROC_1970_185_069_02; J. A. Greenwood, J. B. P.
// Williamson: Contact of nominally flat surfaces. Proc. R. Soc. Lond. A 295 (1966) 300, doi
// 10.1098/rspa.1966.0242.
#pragma once

#include "tribo/gaussian_moment.hpp"
#include "tribo/scene.hpp"

namespace tribo {

// p of F_p in the load.
constexpr Order load_order(AsperityModel model) {
  return model == AsperityModel::greenwood_tripp ? Order::five_halves : Order::three_halves;
}

// The exponent q of A = (K F_p)^q. n → nγ₂, E → E/γ₂ and F → F/γ₂ (paper, 1.19) keep E/F and turn
// K, proportional to n² (GT) or n (GW), into Kγ₂² or Kγ₂. This K times F_p is 1; with A = 1/γ₂ it
// gives q = 1/2 or 1.
template <class T>
T sharing_exponent(AsperityModel model) {
  return model == AsperityModel::greenwood_tripp ? ratio<T>(1, 2) : T(1);
}

// The prefactors of one surface in one Hertz contact. All relative errors: 10 ε.
template <class T>
struct AsperityContact {
  AsperityModel model;
  T stiffness;     // K, dimensionless
  T offset;        // δ = m·D_d/σ_s
  T area_factor;   // of F_2 (GT) or F_1 (GW) in the real area ratio
  T count_factor;  // of F_1 (GT) or F_0 (GW) in the summit count
};

// summit_density n in 1/m², summit_radius β in m, summit_height_sd σ_s in m (see scene.hpp),
// effective_modulus E* in Pa, nominal_area A_nom in m², load F in N; all > 0, offset ≥ 0.
template <class T>
AsperityContact<T> asperity_contact(AsperityModel model, const T& summit_density,
                                    const T& summit_radius, const T& summit_height_sd,
                                    const T& offset, const T& effective_modulus,
                                    const T& nominal_area, const T& load) {
  using std::sqrt;
  const T roughness = summit_density * summit_radius * summit_height_sd;  // nβσ_s
  const T modulus_ratio = effective_modulus * nominal_area / load;        // E*/p̄
  const T slope = sqrt(T(summit_height_sd / summit_radius));
  if (model == AsperityModel::greenwood_tripp) {
    const T stiffness = 16 * sqrt(T(2)) / 15 * pi<T>() * roughness * roughness * slope;
    return {model, stiffness * modulus_ratio, offset, pi<T>() * pi<T>() * roughness * roughness,
            4 * pi<T>() * roughness * summit_density * nominal_area};
  }
  // n√β σ_s^{3/2} = (nβσ_s)√(σ_s/β)
  return {model, ratio<T>(4, 3) * roughness * slope * modulus_ratio, offset, pi<T>() * roughness,
          summit_density * nominal_area};
}

// n of F_n in the real area, and in the number of summits.
constexpr Order area_order(AsperityModel model) {
  return model == AsperityModel::greenwood_tripp ? Order::two : Order::one;
}
constexpr Order count_order(AsperityModel model) {
  return model == AsperityModel::greenwood_tripp ? Order::one : Order::zero;
}

// Real area of contact over the nominal area at λ = separation/σ_s ≥ 0; not clipped at 1.
template <class T>
T real_area_ratio(const AsperityContact<T>& contact, const T& separation_over_sd) {
  return moment_product(contact.area_factor, area_order(contact.model),
                        T(separation_over_sd - contact.offset));
}

// Summits in contact within the nominal area (a mean, not an integer) at λ = separation/σ_s ≥ 0.
template <class T>
T summit_count(const AsperityContact<T>& contact, const T& separation_over_sd) {
  return moment_product(contact.count_factor, count_order(contact.model),
                        T(separation_over_sd - contact.offset));
}

}  // namespace tribo
