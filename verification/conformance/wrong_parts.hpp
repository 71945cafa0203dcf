// SPDX-License-Identifier: Apache-2.0
// Wrong forms of parts of the model, each as a formula. The mistakes of single functions are made
// from them, and so are those of operating points, which contain the same parts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tribo/load_sharing.hpp"
#include "tribo/starvation.hpp"

namespace tribo::conformance {

// SI units, as in film_thickness.hpp.
struct FilmInputs {
  double speed, viscosity, pressure_viscosity, load, modulus, radius, ellipticity;
};
struct WrongFilm {
  std::string name, text;
  std::function<double(const FilmInputs&)> film;  // m
};
std::vector<WrongFilm> wrong_films();
double right_film(const FilmInputs& inputs);

struct WrongInlet {
  std::string name, text;
  // h*/h_ff at r = h_ff/h_oil; none: nothing is wrong with that closure.
  std::function<std::optional<double>(StarvationClosure, double r, double damiens_exponent)> ratio;
};
std::vector<WrongInlet> wrong_inlets();

struct SharingInputs {
  bool is_gt;
  double film, stiffness, offset;  // λ₀, K, δ
};
struct WrongSharing {
  std::string name, text;
  std::function<std::optional<double>(const SharingInputs&)> film_parameter;  // λ
};
std::vector<WrongSharing> wrong_sharings();

}  // namespace tribo::conformance
