// SPDX-License-Identifier: Apache-2.0
// What the engine knows of a contact before it is asked at a speed: numbers, and the words that
// choose its closures and laws. A struct of numbers is a row of values of one type T, which is
// double or a whole vector.
#pragma once

#include "tribo/scene.hpp"

namespace tribo {
struct FilmLaw;
}

namespace tribo::detail {

// Of one surface under one load. T is double, or a vector of many surfaces' numbers.
template <class T>
struct SurfaceNumbers {
  T stiffness;           // K
  T offset;              // δ
  T floor;               // λ_b, 0 without one
  T floor_argument;      // λ_b − δ, without the rounding of the difference
  T hazard;              // −d ln A/dλ at the floor: positive; 0 if there is no floor
  T floor_up_to;         // λ = λ_b to half an ulp for λ₀ from 0 to here
  T film_from;           // λ = λ₀ to half an ulp for λ₀ from here on
  T film_at_unit_speed;  // λ₀/u^a
};

template <class T>
struct ContactNumbers {
  SurfaceNumbers<T> surface;
  T summit_height_sd;  // σ_s
  T area_factor, count_factor;
  T supply;  // inlet film, its ratio, or flow
  T damiens_exponent;
  T boundary_coefficient, slide_roll_ratio, eyring_stress;
  T viscosity, pressure_viscosity;
  T roelands_scale, roelands_exponent;              // ln η₀ + 9.67 and z
  T radius, nominal_area, mean_pressure, approach;  // of the smooth contact
};

// The numbers of a scene that a contact is prepared from, as scene.hpp has them.
template <class T>
struct SceneNumbers {
  T load;
  T summit_density, summit_radius, summit_height_sd, summit_plane_offset, offset_planes;
  T effective_modulus, reduced_radius, ellipticity;
  T viscosity, pressure_viscosity, eyring_stress;
  T supply;
  T boundary_coefficient, slide_roll_ratio, damiens_exponent;
};

struct ContactWords {
  AsperityModel model;
  StarvationClosure closure;
  SupplyKind supply;
  FluidShear fluid;
  ViscosityLaw viscosity;
  const FilmLaw* film;

  friend bool operator==(const ContactWords&, const ContactWords&) = default;
};

// Conversions between a scene and the words and numbers that a contact needs of it; a scene made of
// words and numbers names the default film law, whatever the law of the words.
ContactWords words_of(const Scene& scene);
SceneNumbers<double> numbers_of(const Scene& scene);
Scene scene_of(const ContactWords& words, const SceneNumbers<double>& numbers);

}  // namespace tribo::detail
