// SPDX-License-Identifier: Apache-2.0
// A contact as the engine has it before a speed is asked: its numbers, and the words that choose
// its closures and laws. A struct of numbers is a row of values of one type T, which is double or a
// whole vector.
#pragma once

#include "tribo/hertz_ellipse.hpp"
#include "tribo/oil.hpp"
#include "tribo/roughness.hpp"
#include "tribo/scene.hpp"
#include "tribo/spectral_moments.hpp"
#include "tribo/starvation.hpp"

namespace tribo::detail {

// Numbers of one surface under one load. T is double, or a vector of many surfaces' numbers.
template <class T>
struct SurfaceNumbers {
  T stiffness;       // K
  T offset;          // δ
  T floor;           // λ_b, 0 without one
  T floor_argument;  // λ_b − δ, without the rounding of the difference
  T hazard;          // −d ln A/dλ at the floor: positive; 0 if there is no floor
  T floor_up_to;     // λ = λ_b to half an ulp for λ₀ from 0 to here
  T film_from;       // λ = λ₀ to half an ulp for λ₀ from here on; below 0: smooth, always
  // λ₀/u^a. For a law without fixed exponents it is a logarithm at 1 m/s: ln(λ/Ĥ) or, for a law of
  // points that joins limits, ln λ by the limit H₀₀. NaN where the contact is beyond the kernels'
  // range.
  T film_at_unit_speed;
};

// The numbers from which the film of a law without fixed exponents follows at 1 m/s and γ = 1
// (moes_film.hpp): ln λ by each limit that the law joins. For solved films the first number is ln M
// and the second is L.
template <class T>
struct FilmNumbers {
  T rigid, elastic, rigid_piezoviscous, elastic_piezoviscous;
};

// The numbers that kernels read at a point. A number of the scene that is only a factor of one of
// these is in SceneNumbers alone.
template <class T>
struct ContactNumbers {
  SurfaceNumbers<T> surface;
  T summit_height_sd;  // σ_s
  T area_factor, count_factor;
  T supply;  // inlet film, its ratio, or flow
  T damiens_exponent;
  T boundary_coefficient, slide_roll_ratio, eyring_stress;
  T viscosity, pressure_viscosity;
  T roelands_scale, roelands_exponent;  // ln η₀ + 9.67 and z
  // The smooth contact: a_x (b of a line), A_nom, p̄ and the approach, which a line does not have.
  T semi_axis_x, nominal_area, mean_pressure, approach;
  FilmNumbers<T> film;  // 0 for a law of fixed exponents
};

// The numbers of a scene that a contact is prepared from, in the units of scene.hpp. Where the
// scene gives two bodies or spectral moments, these are the numbers that follow from them.
template <class T>
struct SceneNumbers {
  T load;
  T summit_density, summit_radius, summit_height_sd, summit_plane_offset, offset_planes;
  T effective_modulus;
  T radius_x;     // R_x; of a circle R
  T ellipticity;  // k of the film's constant: given for a circle, Hertz' for an ellipse
  T viscosity, pressure_viscosity, eyring_stress;
  T supply;
  T boundary_coefficient, slide_roll_ratio, damiens_exponent;
  T across;                                 // R_y of an ellipse, L of a line; not used of a circle
  T rms_roughness;                          // Rq of both faces, 0 where it is not given
  T conductivity, temperature_coefficient;  // of a heated inlet
  EllipseOfCircle<T> ellipse;               // not used of a circle and of a line

  // The ellipse and its k, which follow from R_x and R_y.
  void set_ellipse() {
    ellipse = ellipse_of_circle(radius_x, across);
    ellipticity = ellipse.axes_ratio;
  }
};

struct ContactWords {
  ContactShape shape;
  AsperityModel model;
  StarvationClosure closure;
  SupplyKind supply;
  FluidShear fluid;
  ViscosityLaw viscosity;
  const FilmLaw* film;
  ThermalInlet thermal = ThermalInlet::none;

  friend bool operator==(const ContactWords&, const ContactWords&) = default;
};

// The law of the inlet in the words and numbers of a scene or of a contact.
template <class T, template <class> class Numbers>
InletLaw<T> inlet_law(const ContactWords& words, const Numbers<T>& numbers) {
  return {words.closure, numbers.damiens_exponent};
}

// The words of a scene that a contact needs.
ContactWords words_of(const Scene& scene);
ContactWords words_of(const Scene& scene, const FilmLaw& film);

// Smooth bodies have no summits: n = 0, so that K and A are 0. Their λ is h over this unit in m, in
// place of σ_s. It is a power of two, so that all digits of h are kept.
inline constexpr double smooth_height_unit = 0x1p-24;

// The numbers of a scene as they are given, without the ellipse. No field is converted, because a
// sweep writes its values directly into these numbers (Access::number of scene/schema.hpp).
inline SceneNumbers<double> given_numbers(const Scene& scene) {
  const Surface& surface = scene.surface;
  const Bodies& bodies = scene.bodies;
  const ContactShape shape = bodies.shape();
  const bool is_smooth = surface.is_smooth();
  return {.load = scene.load,
          .summit_density = surface.summit_density,
          .summit_radius = is_smooth ? 1 : surface.summit_radius,
          .summit_height_sd = is_smooth ? smooth_height_unit : surface.summit_height_sd,
          .summit_plane_offset = surface.summit_plane_offset,
          .offset_planes = static_cast<double>(surface.offset_planes),
          .effective_modulus = bodies.effective_modulus,
          .radius_x = shape == ContactShape::circle ? bodies.reduced_radius : bodies.radius_x,
          .ellipticity = bodies.ellipticity,
          .viscosity = scene.lubricant.viscosity,
          .pressure_viscosity = scene.lubricant.pressure_viscosity,
          .eyring_stress = scene.lubricant.eyring_stress.value_or(1),
          .supply = scene.supply.value,
          .boundary_coefficient = scene.friction.boundary_coefficient.value_or(0),
          .slide_roll_ratio = scene.friction.slide_roll_ratio,
          .damiens_exponent = scene.closures.damiens_exponent,
          .across = shape == ContactShape::line ? bodies.length : bodies.radius_y,
          .rms_roughness = surface.rms_roughness,
          .conductivity = scene.lubricant.conductivity,
          .temperature_coefficient = scene.lubricant.temperature_coefficient,
          .ellipse = {}};
}

// `convert` is called with each number, in the order of the struct.
template <class T, class Convert>
SceneNumbers<T> numbers_by(const SceneNumbers<double>& n, Convert&& convert) {
  return {.load = convert(n.load),
          .summit_density = convert(n.summit_density),
          .summit_radius = convert(n.summit_radius),
          .summit_height_sd = convert(n.summit_height_sd),
          .summit_plane_offset = convert(n.summit_plane_offset),
          .offset_planes = convert(n.offset_planes),
          .effective_modulus = convert(n.effective_modulus),
          .radius_x = convert(n.radius_x),
          .ellipticity = convert(n.ellipticity),
          .viscosity = convert(n.viscosity),
          .pressure_viscosity = convert(n.pressure_viscosity),
          .eyring_stress = convert(n.eyring_stress),
          .supply = convert(n.supply),
          .boundary_coefficient = convert(n.boundary_coefficient),
          .slide_roll_ratio = convert(n.slide_roll_ratio),
          .damiens_exponent = convert(n.damiens_exponent),
          .across = convert(n.across),
          .rms_roughness = convert(n.rms_roughness),
          .conductivity = convert(n.conductivity),
          .temperature_coefficient = convert(n.temperature_coefficient),
          .ellipse = {}};
}

template <class T>
SceneNumbers<T> numbers_in(const SceneNumbers<double>& n) {
  return numbers_by<T>(n, [](double x) { return T(x); });
}

// The numbers that a contact is prepared from. An ellipse's axes are computed here, once for all
// speeds.
template <class T>
SceneNumbers<T> numbers_of(const Scene& scene) {
  using Wide = WiderType<T>;
  const auto& [first, second] = scene.bodies.bodies;
  SceneNumbers<T> numbers = numbers_in<T>(given_numbers(scene));
  if (scene.surface.has_moments()) {
    const SpectralMoments& m = scene.surface.moments;
    const auto summits = summits_from_spectral_moments(Wide(m.m0), Wide(m.m2), Wide(m.m4));
    // Greenwood and Tripp's σ_s is of the sum of two faces, which here are alike.
    const bool has_two = scene.closures.asperity == AsperityModel::greenwood_tripp;
    using std::sqrt;
    const Wide rise = has_two ? Wide(sqrt(Wide(2))) : Wide(1);
    numbers.summit_density = T(summits.summit_density);
    numbers.summit_radius = T(summits.summit_radius);
    numbers.summit_height_sd = T(summits.summit_height_sd * rise);
    numbers.summit_plane_offset = T(summits.summit_plane_offset / rise);
    numbers.rms_roughness = T(sqrt(Wide(m.m0)) * rise);
  }
  if (scene.lubricant.oil.is_given())
    numbers.viscosity = T(oil_viscosity<Wide>(scene.lubricant.oil));
  if (scene.surface.average_roughness > 0)
    numbers.rms_roughness = T(rms_from_average_roughness(Wide(scene.surface.average_roughness)));
  if (first.modulus > 0)
    numbers.effective_modulus =
        T(effective_modulus(Wide(first.modulus), Wide(first.poisson_ratio), Wide(second.modulus),
                            Wide(second.poisson_ratio)));
  if (first.radius_x != 0)
    numbers.radius_x = T(relative_radius(Wide(first.radius_x), Wide(second.radius_x)));
  if (first.radius_y != 0)
    numbers.across = T(relative_radius(Wide(first.radius_y), Wide(second.radius_y)));
  if (scene.bodies.shape() == ContactShape::ellipse) numbers.set_ellipse();
  return numbers;
}

}  // namespace tribo::detail
