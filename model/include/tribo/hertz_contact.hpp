// SPDX-License-Identifier: Apache-2.0
// Hertz' contact of a scene, whatever its shape (hertz.hpp, hertz_ellipse.hpp, hertz_line.hpp).
#pragma once

#include "tribo/contact_numbers.hpp"
#include "tribo/hertz.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/hertz_line.hpp"

namespace tribo {

template <class T>
struct HertzContact {
  T semi_axis_x;    // a_x, m: along the direction of entrainment; for a line half its width, b
  T semi_axis_y;    // a_y, m: across entrainment; for a line half its length
  T nominal_area;   // A_nom = πa_xa_y, of a line 2bL, m²
  T mean_pressure;  // p̄ = F/A_nom, Pa
  T peak_pressure;  // 3p̄/2, of a line 4p̄/π, Pa
  T approach;       // of the two bodies, m; NaN for a line, where the whole bodies set it
};

// Hertz' contact from a scene's load F, E*, R_x, and R_y or L, in SI units and above 0. For an
// ellipse SceneNumbers::set_ellipse() has to be called before. Error of each number: hertz_contract
// for a circle, else 6 ulp, because the numbers of the ellipse have been rounded. Overflow gives ∞
// or NaN, underflow 0. The sources are in the headers of the three shapes.
template <class T>
HertzContact<T> hertz_contact(ContactShape shape, const detail::SceneNumbers<T>& scene) {
  const T &load = scene.load, &modulus = scene.effective_modulus, &radius = scene.radius_x;
  if (shape == ContactShape::circle) {
    const HertzPoint<T> point = hertz_point(load, modulus, radius);
    return {point.radius,        point.radius,        point.nominal_area,
            point.mean_pressure, point.peak_pressure, point.approach};
  }
  if (shape == ContactShape::ellipse) {
    const HertzEllipse<T> point = hertz_ellipse(load, modulus, radius, scene.ellipse);
    return {point.semi_axis_x,   point.semi_axis_y,   T(load / point.mean_pressure),
            point.mean_pressure, point.peak_pressure, point.approach};
  }
  const T& length = scene.across;
  const HertzLine<T> line = hertz_line(T(load / length), modulus, radius);
  return {line.half_width,    T(length / 2),      T(2 * line.half_width * length),
          line.mean_pressure, line.peak_pressure, quiet_nan<T>()};
}

}  // namespace tribo
