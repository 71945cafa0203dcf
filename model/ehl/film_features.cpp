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

// The extremum near node i of the polynomial through this node and two neighbours on either side,
// or, next to an end, through the five nodes there. The film is smooth enough for that.
Extremum smooth_extremum(std::span<const double> x, std::span<const double> y, std::size_t i) {
  Extremum best = vertex(x, y, i);
  const std::size_t first = std::clamp<std::size_t>(i, 2, x.size() - 3) - 2;
  // c: the polynomial in Newton's form. The loop below evaluates it and its first two derivatives.
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

// The least value from the node `first` on, also between nodes. At an end it is the node's value.
double least(std::span<const double> x, std::span<const double> y, std::size_t first = 0) {
  const auto part = y.subspan(first);
  const auto i = first + static_cast<std::size_t>(std::ranges::min_element(part) - part.begin());
  return i == 0 || i + 1 == y.size() ? y[i] : smooth_extremum(x, y, i).value;
}

// The features of the line through the middle, along the direction of entrainment.
FilmFeatures features_along(std::span<const double> x, std::span<const double> p,
                            std::span<const double> h) {
  FilmFeatures found;
  const std::array<double, 1> middle{0};
  found.central = interpolated(x, h, middle).front();
  found.minimum = least(x, h);

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

  const auto upstream = p.first(found.has_spike ? before_spike : x.size());
  const auto greatest =
      static_cast<std::size_t>(std::ranges::max_element(upstream) - upstream.begin());
  const Extremum top = vertex(x, p, greatest);
  found.greatest_pressure = top.value;
  found.pressure_beside_greatest = std::min(p[greatest - 1], p[greatest + 1]);
  const std::array<double, 1> place{top.place};
  found.at_greatest_pressure = interpolated(x, h, place).front();
  return found;
}

}  // namespace

FilmFeatures features_of(const LineContact& contact, const LineFilm& film,
                         const Integrand& integrand) {
  const std::size_t count = film.x.size();
  FilmFeatures found =
      features_along(film.x, {film.pressure.data(), count}, {film.film.data(), count});
  found.at_greatest_pressure = film.mass_flow / contact.fluid.density(found.greatest_pressure);
  for (std::size_t i = 1; integrand && i + 1 < count; ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    if (film.pressure[node] > 0)
      found.integral +=
          (film.x[i + 1] - film.x[i - 1]) / 2 * integrand(film.pressure[node], film.film[node]);
  }
  return found;
}

FilmFeatures features_of(const PointFilm& film, const Integrand& integrand) {
  const PlaneGrid& grid = film.grid;
  const auto across = static_cast<std::size_t>(grid.count_x());
  Numbers x(across);
  for (int i = 0; i < grid.count_x(); ++i) x[static_cast<std::size_t>(i)] = grid.x(i);
  const auto row = [&](const Eigen::VectorXd& values, int j) {
    return std::span<const double>(values.data() + grid.node(0, j), across);
  };
  FilmFeatures found = features_along(x, row(film.pressure, 0), row(film.film, 0));
  // The least film of each row, then the least of these. The rows below Y = 0 mirror those above.
  constexpr int mirrored = 4;
  Numbers y, rows;
  for (int j = -mirrored; j < grid.count_y(); ++j) {
    y.push_back(j * grid.dy);
    rows.push_back(j < 0 ? 0 : least(x, row(film.film, j)));
  }
  std::reverse_copy(rows.begin() + mirrored + 1, rows.begin() + mirrored + mirrored + 1,
                    rows.begin());
  found.minimum = least(y, rows, mirrored);
  for (int j = 0; integrand && j < grid.count_y(); ++j)
    for (int i = 0; i < grid.count_x(); ++i) {
      const Eigen::Index node = grid.node(i, j);
      if (film.pressure[node] > 0)
        found.integral += grid.area(j) * integrand(film.pressure[node], film.film[node]);
    }
  return found;
}

}  // namespace tribo::ehl
