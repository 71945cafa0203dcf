// SPDX-License-Identifier: Apache-2.0
// The outputs of a scene that follow without the balance of the load (smooth_outputs() in
// outputs.hpp): pressures of the dry, smooth contact, its least film in a flooded inlet, and Λ.
#pragma once

#include "tribo/film_thickness.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo {

// The law of the least film that belongs to a law of the central film, by the same authors where
// they have both: Hamrock and Dowson's of hard or of soft bodies; of lines Pan and Hamrock's, else
// Dowson and Higginson's.
constexpr const FilmLaw& minimum_film_law(const FilmLaw& law) {
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
// Error: film_contract, and 2 ulp more of a line.
template <class T>
T smooth_film(const FilmLaw& law, ContactShape shape, const detail::SceneNumbers<T>& scene,
              const T& speed) {
  return film_thickness(law, speed, scene.viscosity, scene.pressure_viscosity,
                        load_of_film(shape, scene), scene.effective_modulus, scene.radius_x,
                        scene.ellipticity);
}

class SmoothContact {
 public:
  explicit SmoothContact(const MixedContact<double>& contact)
      : hertz_(contact.hertz()),
        law_(&minimum_film_law(contact.film())),
        rms_roughness_(contact.scene_numbers().rms_roughness),
        minimum_film_at_unit_speed_(
            smooth_film(*law_, contact.words().shape, contact.scene_numbers(), 1.0)) {}

  // An output of smooth_outputs() at a speed in m/s. Λ is ∞ where the scene has no roughness.
  // Error: of pressures that of hertz_contact(), of others film_contract.
  double value(Output output, double speed) const {
    switch (output) {
      case Output::peak_pressure:
        return hertz_.peak_pressure;
      case Output::mean_pressure:
        return hertz_.mean_pressure;
      case Output::minimum_film:
        return minimum_film(speed);
      default:
        return minimum_film(speed) / rms_roughness_;
    }
  }
  double minimum_film(double speed) const {
    return minimum_film_at_unit_speed_ * decimal_power(speed, law_->speed_exponent);
  }

 private:
  HertzContact<double> hertz_;
  const FilmLaw* law_;
  double rms_roughness_;
  double minimum_film_at_unit_speed_;
};

}  // namespace tribo
