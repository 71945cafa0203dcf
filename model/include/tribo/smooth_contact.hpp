// SPDX-License-Identifier: Apache-2.0
// The outputs of a scene that operating points do not hold (smooth_outputs() in outputs.hpp): the
// pressures of the dry, smooth contact, and the least film and Λ, which are computed from the film
// of an operating point.
#pragma once

#include <optional>
#include <utility>

#include "tribo/film_thickness.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo {

// The law of the least film that belongs to a film law. For points it is Hamrock and Dowson's law
// of hard bodies, or of soft bodies where the film law does not depend on G. For lines it is Pan
// and Hamrock's law if the film law is one of theirs, else Dowson and Higginson's. For solved films
// it is the solved least film.
constexpr const FilmLaw& minimum_film_law(const FilmLaw& law) {
  if (law.is_solved()) return law.is_of_lines ? solved_line_minimum_law : solved_point_minimum_law;
  if (!law.is_of_lines)
    return law.material_exponent.p == 0 ? hamrock_dowson_soft_minimum_law
                                        : hamrock_dowson_minimum_law;
  const bool is_pan_hamrock = &law == &pan_hamrock_central_law || &law == &pan_hamrock_minimum_law;
  return is_pan_hamrock ? pan_hamrock_minimum_law : dowson_higginson_minimum_law;
}

// The load that film_thickness() takes: F of a point, F R_x/L of a line, in N.
template <class T>
T load_of_film(ContactShape shape, const detail::SceneNumbers<T>& scene) {
  return shape == ContactShape::line ? T(scene.load * scene.radius_x / scene.across) : scene.load;
}

// The film in m of a scene's smooth, flooded contact by any law of its shape, at a speed in m/s.
// Error: film_contract, for a line 2 ulp more. NaN where a solved film is not known.
template <class T>
T smooth_film(const FilmLaw& law, ContactShape shape, const detail::SceneNumbers<T>& scene,
              const T& speed) {
  if (!law.has_fixed_exponents())
    return detail::moes_film(law, shape, scene, T(1)).at(speed, T(1)).film_parameter;
  return film_thickness(law, speed, scene.viscosity, scene.pressure_viscosity,
                        load_of_film(shape, scene), scene.effective_modulus, scene.radius_x,
                        scene.ellipticity);
}

// Λ by common practice: below the first number lubrication is boundary or mixed, between the two it
// is mixed, and from the second on there is a full film.
inline constexpr double least_mixed_lambda_ratio = 1, least_full_film_lambda_ratio = 3;

// The least film is h*, as solved with load sharing, heat and supply, times a ratio of two films of
// the smooth, flooded contact at the same speed: the film by the law of the least film over that by
// the scene's law. The ratio is 1 where the scene's law is itself one of the least film.
class SmoothContact {
 public:
  explicit SmoothContact(const MixedContact<double>& contact)
      : hertz_(contact.hertz()),
        rms_roughness_(contact.scene_numbers().rms_roughness),
        has_summits_(contact.scene_numbers().summit_density > 0),
        is_solved_(contact.film().is_solved()) {
    const FilmLaw& law = contact.film();
    const FilmLaw& minimum_law = minimum_film_law(law);
    if (&minimum_law == &law) return;
    if (!law.has_fixed_exponents()) {
      of_any_exponents_.emplace(contact.words(), contact.scene_numbers());
      return;
    }
    const auto at_unit_speed = [&contact](const FilmLaw& one) {
      return smooth_film(one, contact.words().shape, contact.scene_numbers(), 1.0);
    };
    part_at_unit_speed_ = at_unit_speed(minimum_law) / at_unit_speed(law);
    speed_exponent_ = minimum_law.speed_exponent - law.speed_exponent;
  }

  // An output of smooth_outputs() at a speed in m/s, at which the film is `film` in m. Λ is ∞ where
  // the scene has no roughness. Error: pressures have that of hertz_contact(); the others have the
  // error of `film` and twice that of film_contract.
  double value(Output output, double speed, double film) const {
    switch (output) {
      case Output::peak_pressure:
        return hertz_.peak_pressure;
      case Output::mean_pressure:
        return hertz_.mean_pressure;
      case Output::minimum_film:
        return minimum_film(speed, film);
      default:
        return minimum_film(speed, film) / rms_roughness_;
    }
  }
  // Do faces of which Rq alone is known touch, at a speed and film? They do below Λ = 3. The load
  // on their summits is then unknown, and summit_outputs() are undefined.
  bool has_unknown_summits(double speed, double film) const {
    return !has_summits_ &&
           minimum_film(speed, film) < least_full_film_lambda_ratio * rms_roughness_;
  }
  // Is the film of a point unknown, because M or L, with load sharing, lies outside the rows of
  // solved films? Then all outputs of the point that depend on the film are undefined.
  bool is_beyond_solved_films(double film) const { return is_solved_ && film != film; }
  // The least film in m; 0 where the film has collapsed.
  double minimum_film(double speed, double film) const {
    return film == 0 ? 0 : film * part_of_film(speed);
  }

 private:
  // The least film over the film, of the smooth, flooded contact.
  double part_of_film(double speed) const {
    if (of_any_exponents_) {
      const auto& [words, scene] = *of_any_exponents_;
      return smooth_film(minimum_film_law(*words.film), words.shape, scene, speed) /
             smooth_film(*words.film, words.shape, scene, speed);
    }
    return speed_exponent_.p == 0 ? part_at_unit_speed_
                                  : part_at_unit_speed_ * decimal_power(speed, speed_exponent_);
  }

  HertzContact<double> hertz_;
  double rms_roughness_;
  bool has_summits_, is_solved_;
  double part_at_unit_speed_ = 1;
  Fraction speed_exponent_{0, 1};  // of part_of_film()
  // Set where a law has no fixed exponents: then the part is computed at each speed.
  std::optional<std::pair<detail::ContactWords, detail::SceneNumbers<double>>> of_any_exponents_;
};

}  // namespace tribo
