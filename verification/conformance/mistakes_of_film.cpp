// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "conformance/wrong_parts.hpp"

namespace tribo::conformance {
namespace {

// Hamrock and Dowson's form with other conventions.
double film(const FilmInputs& f, double constant, double u_modulus, double g_modulus,
            double w_modulus) {
  return f.radius * constant *
         std::pow(f.viscosity * f.speed / (u_modulus * f.modulus * f.radius), 0.67) *
         std::pow(f.pressure_viscosity * g_modulus * f.modulus, 0.53) *
         std::pow(f.load / (w_modulus * f.modulus * f.radius * f.radius), -0.067);
}
double bracket(double k, double factor = 0.61) { return 1 - factor * std::exp(-0.73 * k); }

template <class Wrong>
WrongFilm wrong_film(const char* name, const char* text, Wrong&& wrong) {
  return {name, text, std::forward<Wrong>(wrong)};
}

}  // namespace

double right_film(const FilmInputs& inputs) {
  return film(inputs, 2.69 * bracket(inputs.ellipticity), 2, 2, 2);
}

std::vector<WrongFilm> wrong_films() {
  const auto with_moduli = [](double u, double g, double w) {
    return [=](const FilmInputs& f) { return film(f, 2.69 * bracket(f.ellipticity), u, g, w); };
  };
  return {
      wrong_film("film-radius-halved", "R/2 in place of R (a ball on a flat has the ball's radius)",
                 [](FilmInputs f) {
                   f.radius /= 2;
                   return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                 }),
      wrong_film("film-radius-doubled", "2R in place of R",
                 [](FilmInputs f) {
                   f.radius *= 2;
                   return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                 }),
      wrong_film("film-R-in-mm", "R in mm in place of m",
                 [](FilmInputs f) {
                   f.radius *= 1e3;
                   return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                 }),
      wrong_film("film-E*", "E* in place of 2E* in U, G and W", with_moduli(1, 1, 1)),
      wrong_film("film-E*-in-U", "E* in place of 2E* in the speed number U", with_moduli(1, 2, 2)),
      wrong_film("film-E*-in-G", "E* in place of 2E* in the material number G",
                 with_moduli(2, 1, 2)),
      wrong_film("film-E*-in-W", "E* in place of 2E* in the load number W", with_moduli(2, 2, 1)),
      wrong_film("film-4E*", "2E′ with E′ = 2E* in place of 2E*", with_moduli(4, 4, 4)),
      wrong_film("film-speed-sum", "the sum of the surface speeds in place of their mean",
                 [](FilmInputs f) {
                   f.speed *= 2;
                   return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                 }),
      wrong_film("film-speed-halved", "half of the entrainment speed",
                 [](FilmInputs f) {
                   f.speed /= 2;
                   return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                 }),
      wrong_film(
          "film-0.6", "0.6 in place of 0.61",
          [](const FilmInputs& f) { return film(f, 2.69 * bracket(f.ellipticity, 0.6), 2, 2, 2); }),
      wrong_film("film-bracket-dropped", "2.69 without 1 − 0.61 e^{−0.73k}",
                 [](const FilmInputs& f) { return film(f, 2.69, 2, 2, 2); }),
      wrong_film("film-constant-1.9", "the rounded constant 1.9 of a circular contact",
                 [](const FilmInputs& f) { return film(f, 1.9, 2, 2, 2); }),
      wrong_film("film-circular-constant",
                 "the constant of a circular contact at every ellipticity",
                 [](const FilmInputs& f) { return film(f, 2.69 * bracket(1), 2, 2, 2); }),
      wrong_film("film-minimum", "the minimum film 3.63 U^0.68 G^0.49 W^−0.073 (1 − e^{−0.68k})",
                 [](const FilmInputs& f) {
                   const double e = 2 * f.modulus;
                   return f.radius * 3.63 * std::pow(f.viscosity * f.speed / (e * f.radius), 0.68) *
                          std::pow(f.pressure_viscosity * e, 0.49) *
                          std::pow(f.load / (e * f.radius * f.radius), -0.073) *
                          (1 - std::exp(-0.68 * f.ellipticity));
                 }),
      wrong_film("film-over-radius", "h/R in place of h", [](const FilmInputs& f) {
        return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2) / f.radius;
      })};
}

}  // namespace tribo::conformance
