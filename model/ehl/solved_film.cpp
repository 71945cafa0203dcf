// SPDX-License-Identifier: Apache-2.0
#include "ehl/solved_film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tribo::ehl {
namespace {

// The values of one feature on all grids.
template <class Feature>
std::vector<double> over_grids(const std::vector<FilmFeatures>& grids, const Feature& feature) {
  std::vector<double> values;
  for (const FilmFeatures& f : grids) values.push_back(feature(f));
  return values;
}

// The same nodes, and more of them upstream, up to an inlet that is twice as long.
Numbers with_longer_inlet(const Numbers& x) {
  const double growth = std::fmax(1.02, x[0] / x[1]);
  Numbers longer;
  for (double at = 2 * x[0]; at < x[0] * std::sqrt(growth); at /= growth) longer.push_back(at);
  longer.insert(longer.end(), x.begin(), x.end());
  return longer;
}

std::string text(const char* format, double a, double b) {
  char line[200];
  std::snprintf(line, sizeof line, format, a, b);
  return line;
}

void estimate_all(SolvedFilm& solved, const std::vector<FilmFeatures>& grids) {
  const auto estimate = [&](auto&& feature) {
    Estimate e = estimate_of(over_grids(grids, feature));
    e.error += std::fabs(e.value) * solved.domain_error;
    return e;
  };
  solved.central = estimate([](const FilmFeatures& f) { return f.central; });
  solved.minimum = estimate([](const FilmFeatures& f) { return f.minimum; });
  solved.at_greatest_pressure =
      estimate([](const FilmFeatures& f) { return f.at_greatest_pressure; });
  // A spike that coarse grids did not show is estimated from those that do.
  std::vector<FilmFeatures> with_spike;
  for (const FilmFeatures& f : grids) {
    if (!f.has_spike) with_spike.clear();
    if (f.has_spike) with_spike.push_back(f);
  }
  if (with_spike.size() < 3) {
    solved.spike_pressure = solved.spike_place = {};
    return;
  }
  solved.spike_pressure =
      estimate_of(over_grids(with_spike, [](const FilmFeatures& f) { return f.spike_pressure; }));
  solved.spike_place =
      estimate_of(over_grids(with_spike, [](const FilmFeatures& f) { return f.spike_place; }));
}

}  // namespace

Estimate estimate_of(const std::vector<double>& values) {
  Estimate e;
  const std::size_t n = values.size();
  if (n < 3) return e;
  const double last = values[n - 1] - values[n - 2], before = values[n - 2] - values[n - 3];
  e.value = values[n - 1];
  e.error = std::fmax(std::fabs(last), std::fabs(before));
  if (last == 0 && before == 0) return e;
  const double order = std::log2(before / last);
  if (!(order > 1.5 && order < 2.6)) return e;
  e.order = order;
  const auto richardson = [&](std::size_t i) {
    return values[i] + (values[i] - values[i - 1]) / 3;
  };
  e.value = richardson(n - 1);
  e.error = std::fabs(richardson(n - 1) - richardson(n - 2));
  if (n > 3) e.error = std::fmax(e.error, std::fabs(richardson(n - 2) - richardson(n - 3)) / 2);
  return e;
}

SolvedFilm solve_line_film(const LineContact& contact, const SolveOptions& options,
                           const Watch& watch) {
  SolvedFilm solved;
  const auto failed = [&](const LineFilm& film) {
    if (film.outcome == Outcome::solved) return false;
    solved.outcome = film.outcome;
    if (film.outcome == Outcome::stopped)
      solved.reason =
          text("stopped on the grid of %.0f cells", static_cast<double>(film.x.size()) - 1, 0);
    else
      solved.reason = text(
          "Newton's method did not converge on the grid of %.0f cells; its last step changed the "
          "pressure by %.2g of Hertz' peak",
          static_cast<double>(film.x.size()) - 1, film.last_change);
    return true;
  };
  if (expected_film(contact) / contact.film_number(1) < 1e-8) {
    solved.reason = text(
        "the film is some %.1g of what the bodies flatten (hR/b²), which is below what grids of "
        "double numbers resolve: %.0g",
        expected_film(contact) / contact.film_number(1), 1e-8);
    return solved;
  }

  const Scales scales = scales_of(contact);
  LineFilm film = solve_from_nothing(contact, options.first_cells, scales, watch);
  if (failed(film)) return solved;
  film = solve_on(contact, first_density(scales).nodes(2 * options.first_cells), film, watch);
  if (failed(film)) return solved;
  const NodeDensity density = density_of(film.x, {film.pressure.data(), film.x.size()},
                                         {film.film.data(), film.x.size()}, options.at_edge);

  std::vector<FilmFeatures> grids;
  double worst = 0;
  for (int cells = options.first_cells; cells <= options.greatest_cells; cells *= 2) {
    LineFilm finer = solve_on(contact, density.nodes(cells), film, watch);
    solved.steps = finer.steps;
    if (failed(finer)) break;
    film = std::move(finer);
    grids.push_back(features_of(contact, film));
    if (grids.size() == 1) {
      const LineFilm longer = solve_on(contact, with_longer_inlet(film.x), film, watch);
      if (failed(longer)) break;
      const FilmFeatures there = features_of(contact, longer);
      // What is left of the inlet falls with the third power of its length.
      solved.domain_error = 8. / 7 *
                            std::fmax(std::fabs(there.central / grids[0].central - 1),
                                      std::fabs(there.minimum / grids[0].minimum - 1));
    }
    if (grids.size() < 3) continue;
    estimate_all(solved, grids);
    worst = std::max({solved.central.relative_error(), solved.minimum.relative_error(),
                      solved.at_greatest_pressure.relative_error()});
    if (grids.size() > 3 && worst <= options.tolerance) break;
  }
  solved.grids = static_cast<int>(grids.size());
  solved.film = std::move(film);
  if (grids.size() < 3) return solved;
  solved.outcome = Outcome::solved;
  if (solved.reason.empty() && !(worst <= options.tolerance))
    solved.reason = text("the films are met to %.2g of themselves, not to the %.2g asked for",
                         worst, options.tolerance);
  return solved;
}

}  // namespace tribo::ehl
