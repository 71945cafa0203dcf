// SPDX-License-Identifier: Apache-2.0
// Contacts prepared from scenes: Hertz, rough contact, the film at unit speed and the floor
// (hertz.hpp, asperity_contact.hpp, film_thickness.hpp, load_sharing.hpp) in double, once for each
// instruction set, for one lane and for vectors of scenes.
#include <hwy/highway.h>

#include <limits>

#include "load_shares-inl.hpp"
#include "sharing_method.hpp"
#include "tribo/contact_numbers.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/friction.hpp"

#if defined(TRIBO_CONTACT) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_CONTACT
#undef TRIBO_CONTACT
#else
#define TRIBO_CONTACT
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// λ₀/u^a: h₀ at unit speed over σ_s.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V film_at_unit_speed(D d, const FilmLaw& law, const detail::SceneNumbers<V>& scene) {
  // W = F/(E_HD R²), of a line F/(E_HD R L)
  const V second_length = law.is_of_lines ? scene.across : scene.radius_x;
  const auto modulus = [&](int multiple) HWY_ATTR {
    return hn::Mul(hn::Set(d, multiple), scene.effective_modulus);
  };
  const V radius = scene.radius_x;
  const V speed_number = hn::Div(hn::Mul(hn::Set(d, law.speed_multiple), scene.viscosity),
                                 hn::Mul(modulus(law.speed_modulus), radius));
  // G⁰ is 1, also where α is 0.
  const V material_number = law.material_exponent.p == 0
                                ? hn::Set(d, 1.0)
                                : hn::Mul(scene.pressure_viscosity, modulus(law.material_modulus));
  const V load_number =
      hn::Div(scene.load, hn::Mul(hn::Mul(modulus(law.load_modulus), radius), second_length));
  const V decay = hn::Mul(hn::Set(d, -ratio<double>(law.side_decay)), scene.ellipticity);
  V bracket;
  if (law.side_leakage.p == law.side_leakage.q)  // the difference cancels where k is small
    bracket = hn::Neg(exponential_less_one(d, decay));
  else
    bracket = hn::Sub(hn::Set(d, 1.0),
                      hn::Mul(hn::Set(d, ratio<double>(law.side_leakage)), exponential(d, decay)));
  const V constant = hn::Mul(hn::Set(d, ratio<double>(law.constant)), bracket);
  const V film = hn::Mul(hn::Mul(radius, constant),
                         decimal_powers(d, speed_number, law.speed_exponent, material_number,
                                        law.material_exponent, load_number, law.load_exponent));
  return hn::Div(film, scene.summit_height_sd);
}

// Numbers at 1 m/s of a law without fixed exponents. For solved films: ln M, L and, in
// at_unit_speed, ln(λ/Ĥ). For a law that joins limits: ln λ by each limit; at_unit_speed is ln(λ/Ĥ)
// for lines, and ln λ by H₀₀ for points.
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE void add_film(D d, ContactShape shape, const FilmLaw& law,
                           const detail::SceneNumbers<V>& scene, detail::FilmNumbers<V>& film,
                           V& at_unit_speed) {
  const auto times = [d](double factor, V x) HWY_ATTR { return hn::Mul(hn::Set(d, factor), x); };
  const auto plus = [d](V x, double factor, V y)
                        HWY_ATTR { return hn::MulAdd(hn::Set(d, factor), y, x); };
  const V root = hn::Sqrt(hn::Div(scene.viscosity, hn::Mul(scene.effective_modulus,
                                                           scene.radius_x)));  // (2U)^{1/2}
  const V fourth_root = hn::Sqrt(root);
  const V second_length = law.is_of_lines ? scene.across : scene.radius_x;
  const V load = hn::Div(scene.load, hn::Mul(times(2, scene.effective_modulus),
                                             hn::Mul(scene.radius_x, second_length)));
  const V m = logarithm(d, hn::Div(load, law.is_of_lines ? root : hn::Mul(root, fourth_root)));
  const V material =
      hn::Mul(hn::Mul(times(2, scene.pressure_viscosity), scene.effective_modulus), fourth_root);
  const V scale = logarithm(d, hn::Div(hn::Mul(scene.radius_x, root), scene.summit_height_sd));
  at_unit_speed = scale;
  if (law.is_solved()) {
    film = {m, material, hn::Zero(d), hn::Zero(d)};
    return;
  }
  const V l = logarithm(d, hn::Max(material, hn::Set(d, 1e-30)));
  const auto number = [&](double constant) HWY_ATTR { return logarithm(d, hn::Set(d, constant)); };
  if (law.is_of_lines) {
    film = {hn::Sub(number(3), m), plus(number(2.621), -0.2, m), plus(number(1.287), 2.0 / 3, l),
            plus(plus(number(1.311), -0.125, m), 0.75, l)};
  } else {
    const V one = hn::Set(d, 1.0);
    const V ratio =
        shape == ContactShape::ellipse ? hn::Div(scene.radius_x, scene.across) : one;  // D
    const V log_ratio = logarithm(d, ratio);
    const auto power = [&](double exponent)
                           HWY_ATTR { return exponential(d, times(exponent, log_ratio)); };
    const V log_q = logarithm(d, plus(plus(one, 6e-3, log_ratio), 0.63, power(4.0 / 7)));
    film.rigid = plus(hn::Sub(plus(number(145), -15.0 / 7,
                                   logarithm_of_one_plus(d, times(0.796, power(14.0 / 15)))),
                              log_ratio),
                      -2, m);
    film.elastic = plus(plus(plus(number(3.18), -0.56, log_q), -1.0 / 15, log_ratio), -2.0 / 15, m);
    film.rigid_piezoviscous = plus(
        plus(number(1.29), -2.0 / 3, logarithm_of_one_plus(d, times(0.691, ratio))), 2.0 / 3, l);
    film.elastic_piezoviscous = plus(
        plus(plus(plus(number(1.48), -0.35, log_q), -1.0 / 24, log_ratio), -1.0 / 12, m), 0.75, l);
    at_unit_speed = hn::Add(scale, hn::Sub(number(1.8), log_ratio));
  }
  film.rigid = hn::Add(film.rigid, scale);
  film.elastic = hn::Add(film.elastic, scale);
  film.rigid_piezoviscous = hn::Add(film.rigid_piezoviscous, scale);
  film.elastic_piezoviscous = hn::Add(film.elastic_piezoviscous, scale);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void add_hertz(D d, ContactShape shape, const detail::SceneNumbers<V>& scene,
                          detail::ContactNumbers<V>& contact) {
  const V pi = hn::Set(d, 3.14159265358979323846), four = hn::Set(d, 4.0);
  V& axis = contact.semi_axis_x;
  if (shape == ContactShape::line) {
    // b² = 4FR/(πE*L)
    const V square = hn::Div(hn::Mul(hn::Mul(four, scene.load), scene.radius_x),
                             hn::Mul(hn::Mul(pi, scene.effective_modulus), scene.across));
    axis = hn::Sqrt(square);
    contact.nominal_area = hn::Mul(hn::Mul(hn::Set(d, 2.0), axis), scene.across);
    contact.approach = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
  } else {
    // a³ = 3FR/(4E*)
    V cube = hn::Div(hn::Mul(hn::Mul(hn::Set(d, 3.0), scene.load), scene.radius_x),
                     hn::Mul(four, scene.effective_modulus));
    if (shape == ContactShape::ellipse) cube = hn::Mul(cube, scene.ellipse.axis_cube);
    axis = decimal_power(d, cube, Fraction{1, 3});
    contact.nominal_area = hn::Mul(hn::Mul(pi, axis), axis);
    contact.approach = hn::Div(hn::Mul(axis, axis), scene.radius_x);
    if (shape == ContactShape::ellipse) {
      contact.nominal_area = hn::Mul(contact.nominal_area, scene.ellipse.axes_ratio);
      contact.approach = hn::Mul(contact.approach, scene.ellipse.approach);
    }
  }
  contact.mean_pressure = hn::Div(scene.load, contact.nominal_area);
}

// Are the numbers of a contact within the bounds of sharing_method.hpp? A number that may be 0
// passes if it is 0. The offset of the summit planes, μ_b and Damiens' γ are not checked here.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_ordinary(D d, ContactShape shape, const detail::SceneNumbers<V>& scene,
                                   const detail::ContactNumbers<V>& contact) {
  V least = scene.load, greatest = scene.load;
  const auto add = [&](V number) HWY_ATTR {
    least = hn::Min(least, number);
    greatest = hn::Max(greatest, number);
  };
  const auto add_unless_zero = [&](V number) HWY_ATTR {
    add(hn::IfThenElse(hn::Eq(number, hn::Zero(d)), scene.load, number));
  };
  add_unless_zero(scene.summit_density);
  add(scene.summit_radius);
  add(scene.summit_height_sd);
  add(scene.effective_modulus);
  add(scene.radius_x);
  if (shape != ContactShape::circle) add(scene.across);
  add(scene.ellipticity);
  add(scene.viscosity);
  add(scene.eyring_stress);
  add_unless_zero(scene.pressure_viscosity);
  add_unless_zero(scene.slide_roll_ratio);
  add_unless_zero(scene.supply);
  const V factor =
      hn::Max(hn::Max(contact.surface.stiffness, contact.area_factor), contact.count_factor);
  return hn::And(hn::And(hn::Ge(least, hn::Set(d, least_contact_number)),
                         hn::Le(greatest, hn::Set(d, greatest_contact_number))),
                 hn::Le(factor, hn::Set(d, greatest_moment_factor)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE detail::ContactNumbers<V> contact_of(D d, const detail::ContactWords& words,
                                                const detail::SceneNumbers<V>& scene) {
  const V pi = hn::Set(d, 3.14159265358979323846);
  const AsperityModel model = words.model;
  const FilmLaw& law = *words.film;
  detail::ContactNumbers<V> contact;
  add_hertz(d, words.shape, scene, contact);
  // K and the factors of area and count, from nβσ_s, E*/p̄ and √(σ_s/β)
  const V roughness =
      hn::Mul(hn::Mul(scene.summit_density, scene.summit_radius), scene.summit_height_sd);
  const V modulus_ratio =
      hn::Div(hn::Mul(scene.effective_modulus, contact.nominal_area), scene.load);
  const V slope = hn::Sqrt(hn::Div(scene.summit_height_sd, scene.summit_radius));
  V stiffness;
  if (model == AsperityModel::greenwood_tripp) {
    constexpr double factor = 4.7390751340355903;  // 16√2π/15
    stiffness = hn::Mul(hn::Mul(hn::Mul(hn::Set(d, factor), roughness), roughness), slope);
    contact.area_factor = hn::Mul(hn::Mul(hn::Mul(pi, pi), roughness), roughness);
    contact.count_factor =
        hn::Mul(hn::Mul(hn::Mul(hn::Mul(hn::Set(d, 4.0), pi), roughness), scene.summit_density),
                contact.nominal_area);
  } else {
    stiffness = hn::Mul(hn::Mul(hn::Set(d, 4.0 / 3), roughness), slope);
    contact.area_factor = hn::Mul(pi, roughness);
    contact.count_factor = hn::Mul(scene.summit_density, contact.nominal_area);
  }
  const V zero = hn::Zero(d);
  contact.film = {zero, zero, zero, zero};
  V at_unit_speed;
  if (law.has_fixed_exponents())
    at_unit_speed = film_at_unit_speed(d, law, scene);
  else
    add_film(d, words.shape, law, scene, contact.film, at_unit_speed);
  contact.surface =
      surface_of(d, load_order(model), law, hn::Mul(stiffness, modulus_ratio),
                 hn::Mul(scene.offset_planes, scene.summit_plane_offset), at_unit_speed);
  contact.summit_height_sd = scene.summit_height_sd;
  contact.supply = scene.supply;
  contact.damiens_exponent = scene.damiens_exponent;
  contact.boundary_coefficient = scene.boundary_coefficient;
  contact.slide_roll_ratio = scene.slide_roll_ratio;
  contact.eyring_stress = scene.eyring_stress;
  contact.viscosity = scene.viscosity;
  contact.pressure_viscosity = scene.pressure_viscosity;
  contact.roelands_scale =
      hn::Add(logarithm(d, scene.viscosity), hn::Set(d, roelands_log_viscosity<double>()));
  contact.roelands_exponent =
      hn::Div(hn::Mul(scene.pressure_viscosity, hn::Set(d, roelands_pressure<double>())),
              contact.roelands_scale);
  contact.surface.film_at_unit_speed = hn::IfThenElse(
      is_ordinary(d, words.shape, scene, contact), contact.surface.film_at_unit_speed,
      hn::Set(d, std::numeric_limits<double>::quiet_NaN()));
  return contact;
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
