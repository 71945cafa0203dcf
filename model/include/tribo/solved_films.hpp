// SPDX-License-Identifier: Apache-2.0
// Solved films (model/ehl) of flooded, smooth lines and circles between the rows of
// reference/ehl/line_films.csv and point_films.csv (model/README.md, section 5): ln Ĥ over ln M and
// L by bicubic pieces, whose nodes the build makes of the rows (model/generators/film_tables.cpp).
#pragma once

#include <cstddef>

#include "tribo/film_laws.hpp"
#include "tribo/real.hpp"

namespace tribo {

// Ĥ, and the slopes of ln Ĥ against ln M and ln L.
template <class T>
struct FilmNumber {
  T value, load_slope, material_slope;
};

// Nodes at equal steps of ln M, and of L from 0 on; those of one M stand together.
struct FilmTable {
  double first_load, load_step, material_step;  // ln M, steps of ln M and of L
  std::size_t load_steps, material_steps;
  // ln Ĥ, its derivatives by ln M, L and both, each times the steps; NaN where rows are missing.
  const double (*nodes)[4];

  constexpr double last_load() const {
    return first_load + load_step * static_cast<double>(load_steps);
  }
  constexpr double last_material() const {
    return material_step * static_cast<double>(material_steps);
  }
};

// The table of a law whose form is solved or solved_minimum.
const FilmTable& film_table(const FilmLaw& law);

// Relative error of the interpolation, besides that of the rows. Two ranges have a greater error:
// 2.5e-2 in the central film of circles below L = 2.5, and 2e-3 in the least film of lines below L
// = 1.
inline constexpr double solved_point_interpolation = 5e-3,
                        solved_point_minimum_interpolation = 15e-3;
inline constexpr double solved_line_interpolation = 2e-3, solved_line_minimum_interpolation = 5e-4;

namespace detail {

// The weights of a cubic piece at t from 0 to 1, of its value and derivative at the beginning and
// at the end, and the slopes of the weights.
template <class T>
struct CubicWeights {
  explicit CubicWeights(const T& t)
      : end(t * t * (3 - 2 * t)),
        begin_slope(t * (1 - t) * (1 - t)),
        end_slope(t * t * (t - 1)),
        d_end(6 * t * (1 - t)),
        d_begin_slope((1 - t) * (1 - 3 * t)),
        d_end_slope(t * (3 * t - 2)) {}
  T value(const T& from, const T& from_slope, const T& to, const T& to_slope) const {
    return from + (to - from) * end + from_slope * begin_slope + to_slope * end_slope;
  }
  T slope(const T& from, const T& from_slope, const T& to, const T& to_slope) const {
    return (to - from) * d_end + from_slope * d_begin_slope + to_slope * d_end_slope;
  }
  T end, begin_slope, end_slope, d_end, d_begin_slope, d_end_slope;
};

// The step of a table in which x lies. x is counted in steps from the table's first node.
template <class T>
std::size_t step_at(const T& x, std::size_t steps) {
  std::size_t step = 0;
  while (step + 1 < steps && x >= T(static_cast<double>(step + 1))) ++step;
  return step;
}

}  // namespace detail

// Do ln M and L lie in the rectangle of the table? The film may still be missing there.
template <class T>
bool is_within(const FilmTable& table, const T& log_load, const T& material) {
  return log_load >= T(table.first_load) && log_load <= T(table.last_load()) && material >= 0 &&
         material <= T(table.last_material());
}

// Ĥ at ln M and L ≥ 0. Beyond the table ln Ĥ goes on in a straight line, so that a search may pass
// there. NaN where rows are missing.
template <class T>
FilmNumber<T> solved_film_number(const FilmTable& table, const T& log_load, const T& material) {
  using std::exp;
  const auto between = [](const T& x, double low, double high) {
    return x < T(low) ? T(low) : x > T(high) ? T(high) : x;
  };
  const T x_within = between(log_load, table.first_load, table.last_load());
  const T y_within = between(material, 0, table.last_material());
  const T x = (x_within - T(table.first_load)) / T(table.load_step);
  const T y = y_within / T(table.material_step);
  const std::size_t i = detail::step_at(x, table.load_steps);
  const std::size_t j = detail::step_at(y, table.material_steps);
  const detail::CubicWeights<T> along(T(x - T(static_cast<double>(i))));
  const detail::CubicWeights<T> across(T(y - T(static_cast<double>(j))));
  // Value, x-slope, and the y-slopes of both, at the beginning and the end of the step in M
  T value[2], slope[2], value_y[2], slope_y[2];
  for (std::size_t side = 0; side < 2; ++side) {
    const double* low = table.nodes[(i + side) * (table.material_steps + 1) + j];
    const double* high = low + 4;
    value[side] = across.value(T(low[0]), T(low[2]), T(high[0]), T(high[2]));
    value_y[side] = across.slope(T(low[0]), T(low[2]), T(high[0]), T(high[2]));
    slope[side] = across.value(T(low[1]), T(low[3]), T(high[1]), T(high[3]));
    slope_y[side] = across.slope(T(low[1]), T(low[3]), T(high[1]), T(high[3]));
  }
  const T by_load = along.slope(value[0], slope[0], value[1], slope[1]) / T(table.load_step);
  const T by_material =
      along.value(value_y[0], slope_y[0], value_y[1], slope_y[1]) / T(table.material_step);
  const T log_film = along.value(value[0], slope[0], value[1], slope[1]) +
                     by_load * (log_load - x_within) + by_material * (material - y_within);
  return {T(exp(log_film)), by_load, T(by_material * material)};
}

}  // namespace tribo
