// SPDX-License-Identifier: Apache-2.0
// Solves the equations of a line contact on a film (ehl/line_contact.hpp) in a second way, which
// shares only these equations with model/ehl. It checks that solver, and is the second method of
// the solver's table.
//
// Reynolds' equation is integrated once: ρ̄H³/(θη̄) dP/dX = ρ̄H − c with the unknown flow c. The film
// breaks at the unknown place X_e, where P = 0 and ρ̄H = c. P is continuous, and a polynomial on
// each element. The equation holds at the left Radau points of each element, which include its
// upstream end. Without that end, P would oscillate where the liquid is so viscous that the
// equation is ρ̄H = c. The film is integrated exactly. Upstream of the first node P falls with the
// third power of the distance, as it does far from the contact.
//
// Where αp₀ is great, the pressure's spike is too sharp for any elements. Then liquids have the
// fluidity 1/η̄ + φ with smaller and smaller φ, and the films are extrapolated linearly to φ = 0.
#pragma once

#include <limits>
#include <span>
#include <string>

#include "ehl/line_contact.hpp"

namespace tribo::reference {

// The start of the search. The result does not depend on it.
struct FilmStart {
  std::span<const double> x, pressure, film;  // P is 0 at the last node
  double separation;                          // H₀
  double mass_flow;                           // c
};

struct CollocationOptions {
  int degree = 4;
  int elements = 60;         // at first; then elements are halved where P is not resolved
  double resolution = 3e-4;  // greatest |c_p| + 0.2|c_{p−1}| of an element with P = Σ c_n P_n(z)
  int most_elements = 160;
  // How far upstream the elements begin, in units of X, or in units of √(2c) where √(2c) > 1. If
  // the start does not reach so far, they begin at its first node, and the stated errors do not
  // cover that.
  double inlet = 100;
};

// Both are NaN where there is no such number.
struct CollocatedNumber {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  // estimated, absolute
};

struct CollocatedFilm {
  bool is_solved = false;
  std::string reason;                                       // why it is not solved, in a sentence
  CollocatedNumber central, minimum, at_greatest_pressure;  // H, as in ehl/film_features.hpp
  CollocatedNumber spike_pressure, spike_place;             // P and X; only if φ is 0
  CollocatedNumber outlet;                                  // X_e
  double least_fluidity = 0;                                // φ, the smallest that was solved for
  int elements = 0;                                         // elements of the finest mesh
  int steps = 0;                                            // Newton steps, in all
};

// The errors have three parts: the change when all elements are halved, the changes that smaller φ
// would still make, and the error of the inlet. A search that fails is repeated with more elements,
// at most twice; then is_solved is false, and `reason` says why.
CollocatedFilm collocate_line_film(const ehl::LineContact& contact, const FilmStart& start,
                                   const CollocationOptions& options = {});

}  // namespace tribo::reference
