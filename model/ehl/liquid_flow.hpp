// SPDX-License-Identifier: Apache-2.0
// The liquid at a node, and the flow that pressure drives from a node to the next one.
#pragma once

#include <array>
#include <cmath>

#include "ehl/fluid.hpp"

namespace tribo::ehl {

struct LiquidAtNode {
  double log_viscosity, log_viscosity_slope, density, density_slope;
};

inline LiquidAtNode liquid_at(const Fluid& fluid, double p) {
  return {fluid.log_viscosity(p), fluid.log_viscosity_slope(p), fluid.density(p),
          fluid.density_slope(p)};
}

// The mean of e^{−y} for y from a to b, and its derivatives.
struct MeanFluidity {
  double value, by_first, by_second;
};

inline MeanFluidity mean_fluidity(double a, double b) {
  const double half = (b - a) / 2;
  if (std::fabs(half) > 300) {  // sinh(half) may be ∞ where e^{−(a + b)/2} is 0
    const double first = std::exp(-a), second = std::exp(-b), mean = (first - second) / (b - a);
    return {mean, (mean - first) / (b - a), (second - mean) / (b - a)};
  }
  const double middle = std::exp(-(a + b) / 2);
  double s, slope;  // sinh(d)/d and its derivative
  if (std::fabs(half) < 1e-2) {
    const double square = half * half;
    s = 1 + square / 6 * (1 + square / 20);
    slope = half / 3 * (1 + square / 10);
  } else {
    s = std::sinh(half) / half;
    slope = (std::cosh(half) - s) / half;
  }
  return {middle * s, -middle * (s + slope) / 2, -middle * (s - slope) / 2};
}

// A flow from one node to the next, and its derivatives by film and pressure at both.
struct DrivenFlow {
  double value, diffusion;
  std::array<double, 2> by_film, by_pressure;
};

// −ρ̄H³/(θη̄) dP/dX between two nodes a cell apart. 1/η̄ is its mean over the cell for linear ln η̄.
inline DrivenFlow driven_flow(const LiquidAtNode& here, const LiquidAtNode& next, double here_film,
                              double next_film, double pressure_rise, double cell, double theta) {
  const double middle_film = (here_film + next_film) / 2;
  const double density = (here.density + next.density) / 2;
  const MeanFluidity fluidity = mean_fluidity(here.log_viscosity, next.log_viscosity);
  const double cube = middle_film * middle_film * middle_film / theta;
  const double slope = pressure_rise / cell;
  const double conductance = density * cube * fluidity.value;
  const double by_film = -1.5 * conductance / middle_film * slope;
  const double by_fluidity = density * cube * slope, by_density = cube * fluidity.value * slope / 2;
  const double diffusion = conductance / cell;
  return {.value = -conductance * slope,
          .diffusion = diffusion,
          .by_film = {by_film, by_film},
          .by_pressure = {diffusion - by_fluidity * fluidity.by_first * here.log_viscosity_slope -
                              by_density * here.density_slope,
                          -diffusion - by_fluidity * fluidity.by_second * next.log_viscosity_slope -
                              by_density * next.density_slope}};
}

}  // namespace tribo::ehl
