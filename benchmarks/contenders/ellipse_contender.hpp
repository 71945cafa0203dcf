// SPDX-License-Identifier: Apache-2.0
// Methods that compute Hertz' elliptical contact, each as its users write it.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contenders/contender.hpp"

namespace tribo::benchmarks {

struct EllipseCase {
  double load, effective_modulus, radius_x, radius_y;  // R_y ≥ R_x
};
struct EllipseAnswer {
  double semi_axis_x, peak_pressure;
};
using EllipseBatch =
    std::function<void(std::span<const EllipseCase> cases, std::span<EllipseAnswer> answers)>;

struct EllipseContender {
  std::string family;
  std::string name;
  EllipseBatch run;
  EllipseBatch counted{};  // counts pairs of integrals in Counted; empty if it uses none
};

// The formulas of the contact need the axes' ratio k, and the complete elliptic integral of the
// second kind E for the parameter 1 − 1/k².
struct AxesRatio {
  double ellipticity, second_integral;
};

inline EllipseAnswer contact_of(const EllipseCase& c, const AxesRatio& shape) {
  const double pi = std::numbers::pi, k = shape.ellipticity;
  const double reduced = 1 / (1 / c.radius_x + 1 / c.radius_y);
  const double axis =
      std::cbrt(3 * shape.second_integral * c.load * reduced / (pi * k * c.effective_modulus));
  return {axis, 3 * c.load / (2 * pi * k * axis * axis)};
}

// Makes the function of an ellipse contender from shape(R_y/R_x), which returns an AxesRatio.
template <class Shape>
EllipseBatch by_shape(Shape shape) {
  return [shape](std::span<const EllipseCase> cases, std::span<EllipseAnswer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i)
      answers[i] = contact_of(cases[i], shape(cases[i].radius_y / cases[i].radius_x));
  };
}

// All contenders, family by family. Our own come last.
std::vector<EllipseContender> ellipse_contenders(Settings settings = Settings::usual);
// The contenders that find the axes' ratio as a root.
std::vector<EllipseContender> ellipse_roots(Settings settings);

}  // namespace tribo::benchmarks
