// SPDX-License-Identifier: Apache-2.0
#include "ehl/film_features.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace tribo::ehl {
namespace {

struct Extremum {
  double place, value;
};

// The extremum of the parabola through a node and its two neighbours.
Extremum vertex(std::span<const double> x, std::span<const double> y, std::size_t i) {
  const double left = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
  const double right = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  const double bend = (right - left) / (x[i + 1] - x[i - 1]);
  const double place = (x[i - 1] + x[i]) / 2 - left / (2 * bend);
  return {place, y[i - 1] + left * (place - x[i - 1]) + bend * (place - x[i - 1]) * (place - x[i])};
}

// The extremum of the polynomial through a node and two neighbours on either side, next to an end
// through the five nodes there: the film is smooth enough.
Extremum smooth_extremum(std::span<const double> x, std::span<const double> y, std::size_t i) {
  Extremum best = vertex(x, y, i);
  const std::size_t first = std::clamp<std::size_t>(i, 2, x.size() - 3) - 2;
  // The polynomial in Newton's form; below, its first two derivatives at a place.
  std::array<double, 5> c{};
  for (std::size_t k = 0; k < 5; ++k) c[k] = y[first + k];
  for (std::size_t order = 1; order < 5; ++order)
    for (std::size_t k = 4; k >= order; --k)
      c[k] = (c[k] - c[k - 1]) / (x[first + k] - x[first + k - order]);
  for (int step = 0; step < 4; ++step) {
    double value = c[4], slope = 0, bend = 0;
    for (std::size_t k = 4; k-- > 0;) {
      const double from = best.place - x[first + k];
      bend = bend * from + 2 * slope;
      slope = slope * from + value;
      value = value * from + c[k];
    }
    best.value = value;
    const double move = bend == 0 ? 0 : -slope / bend;
    if (!(best.place + move > x[i - 1] && best.place + move < x[i + 1])) break;
    best.place += move;
  }
  return best;
}

}  // namespace

FilmFeatures features_of(const LineContact& contact, const LineFilm& film) {
  const std::span<const double> x(film.x), p(film.pressure.data(), film.x.size()),
      h(film.film.data(), film.x.size());
  FilmFeatures found;
  const std::array<double, 1> middle{0};
  found.central = interpolated(x, h, middle).front();

  Eigen::Index least;
  found.minimum = film.film.minCoeff(&least);
  if (least > 0 && least + 1 < film.film.size())
    found.minimum = smooth_extremum(x, h, static_cast<std::size_t>(least)).value;

  bool is_past_minimum = false;
  std::size_t before_spike = 0;
  for (std::size_t i = 1; i + 1 < x.size() && !found.has_spike; ++i) {
    if (x[i] <= 0 || p[i] == 0) continue;
    if (p[i] < p[i - 1] && p[i] <= p[i + 1]) {
      is_past_minimum = true;
      before_spike = i;
    }
    if (!is_past_minimum || p[i] <= p[i - 1] || p[i] < p[i + 1]) continue;
    const Extremum top = vertex(x, p, i);
    found.has_spike = true;
    found.spike_pressure = top.value;
    found.spike_place = top.place;
  }

  const std::size_t upstream = found.has_spike ? before_spike : x.size();
  Eigen::Index greatest;
  film.pressure.head(static_cast<Eigen::Index>(upstream)).maxCoeff(&greatest);
  found.greatest_pressure = vertex(x, p, static_cast<std::size_t>(greatest)).value;
  found.pressure_beside_greatest =
      std::min(film.pressure[greatest - 1], film.pressure[greatest + 1]);
  found.at_greatest_pressure = film.mass_flow / contact.fluid.density(found.greatest_pressure);
  return found;
}

}  // namespace tribo::ehl
