// SPDX-License-Identifier: Apache-2.0
// Numbers that are read off a solved film.
#pragma once

#include <functional>

#include "ehl/line_film.hpp"
#include "ehl/point_film.hpp"

namespace tribo::ehl {

// A function of P > 0 and H that is integrated over the contact where P > 0. Empty: no integral.
using Integrand = std::function<double(double pressure, double film)>;

// All numbers are without units: H, P and X of line_contact.hpp or point_contact.hpp. In a point
// contact all but the least film and the integral are of the line Y = 0.
struct FilmFeatures {
  double central = 0;  // H at X = 0
  double minimum = 0;  // the least H, between nodes too
  // H where P is greatest upstream of the spike. The spike is left out: many grids do not resolve
  // it, and in a compressible liquid H at the spike falls as the spike rises.
  double at_greatest_pressure = 0;
  double greatest_pressure = 0;         // P at that place
  double pressure_beside_greatest = 0;  // the lesser P of the two nodes beside the greatest
  bool has_spike = false;               // a second maximum of P, downstream of a minimum
  double spike_pressure = 0;            // P at its top
  double spike_place = 0;               // X of its top
  double integral = 0;                  // of the integrand over X, for points over X and Y
};

FilmFeatures features_of(const LineContact& contact, const LineFilm& film,
                         const Integrand& integrand = {});
FilmFeatures features_of(const PointFilm& film, const Integrand& integrand = {});

}  // namespace tribo::ehl
