// SPDX-License-Identifier: Apache-2.0
// A solver in C++ that registers what it has: Hertz, the film and one closure of the starved inlet.
//
//   tribocheck verify --subject build/release/verification/conformance/subjects/cpp_registration
#include <cmath>
#include <numbers>

#include "conformance/serve.hpp"

namespace {

using namespace tribo::conformance;

HertzResult hertz_point(const HertzCase& asked) {
  const double radius =
      std::cbrt(3 * asked.load * asked.reduced_radius / (4 * asked.effective_modulus));
  const double mean_pressure = asked.load / (std::numbers::pi * radius * radius);
  return {radius, mean_pressure, 1.5 * mean_pressure, radius * radius / asked.reduced_radius};
}

double film(const FilmCase& asked) {
  const double modulus = 2 * asked.effective_modulus;  // E' of the formula
  const double u = asked.viscosity * asked.speed / (modulus * asked.reduced_radius);
  const double g = asked.pressure_viscosity * modulus;
  const double w = asked.load / (modulus * asked.reduced_radius * asked.reduced_radius);
  return asked.reduced_radius * 2.69 * std::pow(u, 0.67) * std::pow(g, 0.53) * std::pow(w, -0.067) *
         (1 - 0.61 * std::exp(-0.73 * asked.ellipticity));
}

Answer<double> starvation_ratio(const StarvationCase& asked) {
  if (asked.closure != tribo::StarvationClosure::damiens) return skip("only Damiens' closure");
  const double gamma = asked.damiens_exponent;
  return std::pow(1 + std::pow(asked.flooded_over_inlet, gamma), -1 / gamma);
}

}  // namespace

int main() {
  Solver solver;
  solver.hertz_point = each(hertz_point);
  solver.hamrock_dowson_central = each(film);
  solver.starvation_ratio = each(starvation_ratio);
  return serve(solver);
}
