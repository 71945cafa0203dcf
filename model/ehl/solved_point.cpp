// SPDX-License-Identifier: Apache-2.0
#include "ehl/solved_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ehl/far_inlet.hpp"
#include "ehl/film_features.hpp"
#include "ehl/text.hpp"

namespace tribo::ehl {
namespace {

constexpr double minimum_share = 3;  // of the tolerance, for the least film

int rounded_up(double cells) { return static_cast<int>(std::ceil(cells - 1e-9)); }

// The worst error over its tolerance.
double worst_of(const SolvedPoint& solved) {
  return std::max({solved.central.relative_error(), solved.at_greatest_pressure.relative_error(),
                   solved.minimum.relative_error() / minimum_share});
}

void estimate_all(SolvedPoint& solved, const std::vector<FilmFeatures>& grids,
                  const FilmFeatures& larger) {
  solved.domain_error = 0;
  const auto estimate = [&](double FilmFeatures::*feature, double of_last) {
    std::vector<double> values;
    values.reserve(grids.size());
    for (const FilmFeatures& f : grids) values.push_back(f.*feature);
    Estimate e = estimate_of(values, {.of_last = of_last});
    // What the ends of the grid do falls with the third power of its length: 3/2 times the length
    // leaves 0.3 of it.
    const double domain = 1.5 * std::fabs(larger.*feature / grids.front().*feature - 1);
    solved.domain_error = std::fmax(solved.domain_error, domain);
    e.error += domain * std::fabs(e.value);
    return e;
  };
  solved.central = estimate(&FilmFeatures::central, 0.25);
  solved.minimum = estimate(&FilmFeatures::minimum, 0.5);
  solved.at_greatest_pressure = estimate(&FilmFeatures::at_greatest_pressure, 0.25);
}

// The films by the grids that follow from one coarsest grid.
SolvedPoint solve_from_coarsest(const PointContact& contact, int cells, const PointOptions& options,
                                const Watch& watch) {
  SolvedPoint solved;
  PlaneGrid grid = grid_for(contact, cells);
  const auto failed = [&](const PointFilm& film) {
    if (film.outcome == Outcome::solved) return false;
    solved.outcome = film.outcome;
    solved.reason =
        film.outcome == Outcome::stopped
            ? text("stopped on the grid of %d by %d cells", film.grid.count_x() - 1,
                   film.grid.beside)
            : text(
                  "on the grid of %d by %d cells neither Newton's method nor the film in time "
                  "came to rest: the last step still changed the pressure by %.2g of Hertz' peak",
                  film.grid.count_x() - 1, film.grid.beside, film.last_change);
    return true;
  };

  PointFilm film = solve_from_nothing(contact, grid, watch);
  if (failed(film)) return solved;
  const PointFilm longer = solve_on(contact, grid_for(contact, cells, 1.5), film, watch);
  if (failed(longer)) return solved;
  const FilmFeatures larger = features_of(longer);
  std::vector<FilmFeatures> grids{features_of(film)};
  while (4 * grid.size() <= options.greatest_nodes) {
    grid = grid.finer();
    PointFilm finer = solve_on(contact, grid, film, watch);
    if (failed(finer)) break;
    film = std::move(finer);
    grids.push_back(features_of(film));
    if (grids.size() < 3) continue;
    estimate_all(solved, grids, larger);
    if (worst_of(solved) <= options.tolerance) break;
  }
  solved.grids = static_cast<int>(grids.size());
  solved.steps = film.steps;
  solved.film = std::move(film);
  if (grids.size() < 3) {
    if (solved.reason.empty())
      solved.reason = text("an error needs three grids, and %d nodes at most leave %d",
                           static_cast<int>(options.greatest_nodes), solved.grids);
    return solved;
  }
  solved.outcome = Outcome::solved;
  if (worst_of(solved) <= options.tolerance) {
    solved.reason.clear();
    return solved;
  }
  const std::string met = text(
      "the tolerance of %g was not met: the errors are %.1g of the central film and %.1g of "
      "the least film on the grid of %d by %d cells",
      options.tolerance, solved.central.relative_error(), solved.minimum.relative_error(),
      solved.film.grid.count_x() - 1, solved.film.grid.beside);
  solved.reason = met + (solved.reason.empty() ? "" : "; " + solved.reason);
  return solved;
}

}  // namespace

PlaneGrid grid_for(const PointContact& contact, int cells, double longer) {
  const double reach = reach_of(contact), k = numbers_of(contact).ellipticity;
  // Heavily loaded contacts have short inlets; below, the error falls with the third power.
  const double light = 20 / contact.load_number;
  const double ahead = longer * (light < 1 ? 1.3 + 3.2 * std::pow(light, 0.27)
                                           : std::fmin(12, 4.5 * std::pow(light, 0.4)));
  const double side = 2 * ahead / 3;
  const double spread = -k / std::tan(FarInlet(contact).break_angle());
  const double behind = std::fmax(1.4, 1.1 * spread * side);
  return {rounded_up(ahead * cells), rounded_up(behind * cells),
          rounded_up(std::fmax(side, 1.5) * cells), reach / cells, k * reach / cells};
}

SolvedPoint solve_point_film(const PointContact& contact, const PointOptions& options,
                             const Watch& watch) {
  SolvedPoint solved;
  const double m = contact.load_number, l = contact.material_number;
  if (!std::isfinite(m) || !std::isfinite(l) || !std::isfinite(contact.fluid.exponent)) {
    solved.reason =
        text("the numbers of this contact, M = %.3g and L = %.3g, are not finite", m, l);
    return solved;
  }
  if (m < least_point_load_number) {
    solved.reason = text(
        "M = %.3g is below %g: the load is too small to flatten the bodies, and the solver was "
        "not made for that",
        m, least_point_load_number);
    return solved;
  }
  // The inlet is narrower the greater the load.
  int cells = std::max(8, rounded_up(8 * std::pow(m / 30, 0.38)));
  std::string tried;
  for (int i = 0; i < 3; ++i, cells += cells / 2) {
    solved = solve_from_coarsest(contact, cells, options, watch);
    if (solved.outcome != Outcome::not_converged) return solved;
    tried += text(i == 0 ? "%d" : ", %d", cells);
  }
  solved.reason = text(
      "no film was found at M = %.3g and L = %.3g, from coarsest grids of %s "
      "cells a semi-axis; %s",
      m, l, tried.c_str(), solved.reason.c_str());
  if (m > greatest_tried_point_load_number)
    solved.reason += text("; the solver was tried up to M = %g", greatest_tried_point_load_number);
  return solved;
}

}  // namespace tribo::ehl
