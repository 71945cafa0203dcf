// SPDX-License-Identifier: Apache-2.0
// The starved film of smooth circles between the solved ones of reference/ehl/point_films.csv
// (model/README.md, section 7): Damiens' y = (1 + r^γ)^{−1/γ}, r = h_ff/h_oil, with a γ of ln M, L
// and ln r. M and L are those of the whole load: the inlet lies around all of Hertz' contact. The
// build makes the table of γ from the rows (model/generators/film_tables.cpp).
#pragma once

#include <cstddef>

#include "tribo/real.hpp"
#include "tribo/solved_films.hpp"

namespace tribo {

// γ at equal steps of ln M, of L and of ln r, with straight lines between the steps.
struct InletTable {
  double first_load, load_step, first_material, material_step, first_ratio, ratio_step;
  std::size_t load_steps, material_steps, ratio_steps;
  // For each ln M and each cell in L and ln r: γ at the cell's first corner, at the next ln r, at
  // the next L, and at the next of both.
  const double (*nodes)[4];

  constexpr double last_load() const {
    return first_load + load_step * static_cast<double>(load_steps);
  }
  constexpr double last_material() const {
    return first_material + material_step * static_cast<double>(material_steps);
  }
  constexpr double last_ratio() const {
    return first_ratio + ratio_step * static_cast<double>(ratio_steps);
  }
};

const InletTable& inlet_table();

// Relative error of y = h*/h_ff by the interpolation, besides that of the rows: 2e-3 for r from 1/4
// to 4. Beyond this range γ is that of its nearer end; y then differs from its limits, 1 and 1/r,
// by at most 3e-2.
inline constexpr double solved_inlet_interpolation = 2e-3;

// γ at ln M, L and ln r. NaN where M or L lie outside of the table.
template <class T>
T solved_inlet_exponent(const InletTable& table, const T& log_load, const T& material,
                        const T& log_ratio) {
  const bool is_within = log_load >= T(table.first_load) && log_load <= T(table.last_load()) &&
                         material >= T(table.first_material) &&
                         material <= T(table.last_material());
  if (!is_within) return quiet_nan<T>();
  T z = log_ratio;
  if (z < T(table.first_ratio)) z = T(table.first_ratio);
  if (z > T(table.last_ratio())) z = T(table.last_ratio());
  const auto steps = [](const T& at, double first, double step) {
    return T((at - T(first)) / T(step));
  };
  const T x = steps(log_load, table.first_load, table.load_step),
          y = steps(material, table.first_material, table.material_step),
          t = steps(z, table.first_ratio, table.ratio_step);
  const std::size_t i = detail::step_at(x, table.load_steps),
                    j = detail::step_at(y, table.material_steps),
                    k = detail::step_at(t, table.ratio_steps);
  const auto part = [](const T& of, std::size_t step) {
    return T(of - T(static_cast<double>(step)));
  };
  const auto at_load = [&](std::size_t load) {
    const double* g = table.nodes[(load * table.material_steps + j) * table.ratio_steps + k];
    const T low = T(g[0]) + (T(g[1]) - T(g[0])) * part(t, k);
    const T high = T(g[2]) + (T(g[3]) - T(g[2])) * part(t, k);
    return T(low + (high - low) * part(y, j));
  };
  const T first = at_load(i);
  return first + (at_load(i + 1) - first) * part(x, i);
}

}  // namespace tribo
