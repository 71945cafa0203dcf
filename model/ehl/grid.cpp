// SPDX-License-Identifier: Apache-2.0
#include "ehl/grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace tribo::ehl {
namespace {

// Each value averaged with its neighbours, so that the spacing of the nodes changes slowly.
void smooth(Numbers& values, int times) {
  for (; times > 0; --times) {
    double before = values.front();
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
      const double here = values[i];
      values[i] = (before + 2 * here + values[i + 1]) / 4;
      before = here;
    }
  }
}

// The absolute second derivative of y at the nodes; 0 at the ends.
Numbers curvature(std::span<const double> x, std::span<const double> y) {
  Numbers result(x.size(), 0.0);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const double left = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
    const double right = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    result[i] = std::fabs(2 * (right - left) / (x[i + 1] - x[i - 1]));
  }
  return result;
}

void add_share(Numbers& density, const Numbers& part, std::span<const double> x, double share) {
  double whole = 0;
  for (std::size_t i = 0; i < part.size(); ++i) whole += part[i] * (x[i + 1] - x[i]);
  for (std::size_t i = 0; i < part.size(); ++i) density[i] += share * part[i] / whole;
}

}  // namespace

NodeDensity::NodeDensity(Numbers place, std::span<const double> density)
    : place_(std::move(place)), share_(place_.size(), 0.0) {
  for (std::size_t i = 0; i + 1 < place_.size(); ++i)
    share_[i + 1] = share_[i] + density[i] * (place_[i + 1] - place_[i]);
}

Numbers NodeDensity::nodes(int cells) const {
  Numbers result(static_cast<std::size_t>(cells) + 1);
  std::size_t k = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double share = share_.back() * static_cast<double>(i) / cells;
    while (k + 2 < share_.size() && share_[k + 1] < share) ++k;
    const double part = (share - share_[k]) / (share_[k + 1] - share_[k]);
    result[i] = place_[k] + (place_[k + 1] - place_[k]) * part;
  }
  result.front() = place_.front();
  result.back() = place_.back();
  return result;
}

double expected_film(const LineContact& contact) {
  const double m = contact.load_number, l = contact.material_number;
  const double rigid = 3 / m, elastic = 2.6 * std::pow(m, -0.2);
  const double piezoviscous =
      l == 0 ? 0
             : std::min(1.3 * std::pow(l, 2. / 3), 1.3 * std::pow(m, -0.125) * std::pow(l, 0.75));
  return std::max({rigid, elastic, piezoviscous});
}

Scales scales_of(const LineContact& contact) {
  const double m = contact.load_number;
  // Outside the half-width the gap of dry bodies grows with the power 3/2 of the distance.
  const double film = std::numbers::pi / 8 / m * expected_film(contact);
  const double edge = std::fmin(1, std::pow(film, 2. / 3));
  const double reach = std::fmax(1, std::sqrt(2 * film));
  return {edge, -2700 * reach, 1 + 2 * reach, reach};
}

NodeDensity first_density(const Scales& scales) {
  // Places at even steps of ln(−X) far from the contact, then at even steps of X.
  constexpr double near = -2;
  const int far_steps = static_cast<int>(100 * std::log(scales.inlet_end / near));
  const double step = std::fmin(0.002, scales.edge / 10);
  const int near_steps = static_cast<int>((scales.outlet_end - near) / step);
  Numbers place;
  for (int i = 0; i < far_steps; ++i)
    place.push_back(scales.inlet_end * std::pow(near / scales.inlet_end, i / (far_steps + 0.)));
  for (int i = 0; i <= near_steps; ++i)
    place.push_back(near + (scales.outlet_end - near) * i / near_steps);
  Numbers density;
  const double edge = scales.edge;
  for (std::size_t i = 0; i + 1 < place.size(); ++i) {
    const double x = (place[i] + place[i + 1]) / 2;
    density.push_back(0.8 / (1 + std::fabs(x)) + 0.4 / std::hypot(0.5 * edge, x + 1 + 0.3 * edge) +
                      0.8 / std::hypot(0.5 * edge, x - 1 + edge));
  }
  return {std::move(place), density};
}

NodeDensity density_of(std::span<const double> x, std::span<const double> pressure,
                       std::span<const double> film, double at_edge) {
  const std::size_t cells = x.size() - 1;
  Numbers bend = curvature(x, pressure);
  smooth(bend, 4);
  Numbers by_bend(cells), by_slope(cells), by_distance(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    by_bend[i] = std::sqrt((bend[i] + bend[i + 1]) / 2);
    by_slope[i] =
        std::fabs(film[i + 1] - film[i]) / (x[i + 1] - x[i]) / ((film[i] + film[i + 1]) / 2);
    by_distance[i] = 1 / (1 + std::fabs(x[i] + x[i + 1]) / 2);
  }
  Numbers density(cells, 0.0);
  add_share(density, by_bend, x, 0.6);
  add_share(density, by_slope, x, 0.15);
  add_share(density, by_distance, x, 0.25);

  const auto least = std::min_element(film.begin(), film.end()) - film.begin();
  std::size_t end = static_cast<std::size_t>(least);
  while (end < cells && pressure[end] > 0) ++end;
  const double edge = x[end] - x[static_cast<std::size_t>(least)];
  if (edge > 0)
    for (double& d : density) d = std::fmin(d, at_edge / edge);
  smooth(density, 8);
  return {Numbers(x.begin(), x.end()), density};
}

Numbers interpolated(std::span<const double> x, std::span<const double> values,
                     std::span<const double> to, double greatest_bend) {
  Numbers result(to.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    while (k + 2 < x.size() && x[k + 1] < to[i]) ++k;
    const std::size_t first = std::clamp<std::size_t>(k, 1, x.size() - 3) - 1;
    double sum = 0;
    for (std::size_t q = first; q < first + 4; ++q) {
      double factor = values[q];
      for (std::size_t j = first; j < first + 4; ++j)
        if (j != q) factor *= (to[i] - x[j]) / (x[q] - x[j]);
      sum += factor;
    }
    const auto [low, high] = std::minmax(values[k], values[k + 1]);
    const double straight = std::lerp(values[k], values[k + 1], (to[i] - x[k]) / (x[k + 1] - x[k]));
    if (std::fabs(sum - straight) > greatest_bend * (high - low)) sum = straight;
    result[i] = low == 0 ? std::clamp(sum, low, high) : std::fmax(sum, 0);
  }
  return result;
}

}  // namespace tribo::ehl
