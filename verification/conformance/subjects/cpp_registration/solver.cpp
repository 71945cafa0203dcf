// SPDX-License-Identifier: Apache-2.0
// A solver in C++ that registers what it has: Hertz, the film and one closure of the starved inlet.
//
//   tribocheck verify --subject build/release/verification/conformance/subjects/cpp_registration
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/serve.hpp"

namespace {

using namespace tribo::conformance;

// Radius, mean and peak pressure, approach.
std::array<double, 4> hertz_point(double load, double effective_modulus, double reduced_radius) {
  const double radius = std::cbrt(3 * load * reduced_radius / (4 * effective_modulus));
  const double mean_pressure = load / (std::numbers::pi * radius * radius);
  return {radius, mean_pressure, 1.5 * mean_pressure, radius * radius / reduced_radius};
}

double film(double speed, double viscosity, double pressure_viscosity, double load,
            double effective_modulus, double reduced_radius, double ellipticity) {
  const double modulus = 2 * effective_modulus;  // E' of the formula
  const double u = viscosity * speed / (modulus * reduced_radius);
  const double g = pressure_viscosity * modulus;
  const double w = load / (modulus * reduced_radius * reduced_radius);
  return reduced_radius * 2.69 * std::pow(u, 0.67) * std::pow(g, 0.53) * std::pow(w, -0.067) *
         (1 - 0.61 * std::exp(-0.73 * ellipticity));
}

Answer<double> starvation_ratio(tribo::StarvationClosure closure, double flooded_over_inlet,
                                double gamma) {
  if (closure != tribo::StarvationClosure::damiens) return skip("only Damiens' closure");
  return std::pow(1 + std::pow(flooded_over_inlet, gamma), -1 / gamma);
}

}  // namespace

int main() {
  Solver solver;
  solver.offer("hertz_point", hertz_point);
  solver.offer("hamrock_dowson_central", film);
  solver.offer("starvation_ratio", starvation_ratio);
  return serve(solver);
}
