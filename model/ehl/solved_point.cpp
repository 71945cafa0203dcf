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

constexpr double minimum_share = 3;  // the least film's tolerance over options.tolerance
// The error from a grid's ends may take this share of the tolerance; finer grids do not reduce it.
constexpr double domain_share = 0.8;

int rounded_up(double cells) { return static_cast<int>(std::ceil(cells - 1e-9)); }

// The worst error, to compare with the tolerance. The film at the greatest pressure does not count:
// where that pressure is a spike's, it moves with the grid.
double worst_of(const SolvedPoint& solved) {
  return std::max(solved.central.relative_error(), solved.minimum.relative_error() / minimum_share);
}

bool is_met(const SolvedPoint& solved, const PointOptions& options) {
  return solved.minimum.value > 0 && worst_of(solved) <= options.tolerance;
}

// Whether three grids with more cells may give a smaller error than three grids did: there is room
// for a tenth more cells along each side, as more_cells() asks.
bool is_short_of_nodes(const SolvedPoint& solved, const PointOptions& options) {
  return solved.grids == 3 && solved.domain_error <= options.tolerance &&
         1.2 * static_cast<double>(solved.film.grid.size()) <=
             static_cast<double>(options.greatest_nodes);
}

// The relative error of a film from the grid's ends. It falls with the third power of the grid's
// length, so that `larger`, 3/2 times as long, leaves 0.3 of it at most. On ellipses across the
// motion up to half was left.
double domain_error_of(double FilmFeatures::*film, const PointContact& contact,
                       const FilmFeatures& grid, const FilmFeatures& larger) {
  return (contact.radius_ratio > 1 ? 2 : 1.5) * std::fabs(larger.*film / grid.*film - 1);
}

// The part of worst_of() that comes from the grid's ends.
double domain_part_of(const PointContact& contact, const FilmFeatures& grid,
                      const FilmFeatures& larger) {
  return std::fmax(domain_error_of(&FilmFeatures::central, contact, grid, larger),
                   domain_error_of(&FilmFeatures::minimum, contact, grid, larger) / minimum_share);
}

// The cells along a side of the grid beside the others, over those of the finest grid.
constexpr double share_beside = 3. / 4;

// Sets the films and their errors. `beside`: on the grid beside, null where there is none.
void estimate_all(SolvedPoint& solved, const PointContact& contact,
                  const std::vector<FilmFeatures>& grids, const FilmFeatures& larger,
                  const FilmFeatures* beside = nullptr) {
  solved.domain_error = 0;
  const auto estimate = [&](double FilmFeatures::*feature, const Caution& caution) {
    std::vector<double> values;
    values.reserve(grids.size());
    for (const FilmFeatures& f : grids) values.push_back(f.*feature);
    Estimate e = estimate_of(
        values, caution, beside == nullptr ? Beside{} : Beside{beside->*feature, 1 / share_beside});
    const double domain = domain_error_of(feature, contact, grids.front(), larger);
    if (feature != &FilmFeatures::integral)
      solved.domain_error = std::fmax(solved.domain_error, domain);
    e.error += domain * std::fabs(e.value);
    return e;
  };
  // Where the order is not near the second, one Richardson's value and a grid beside are better
  // than the sum of the changes: with these shares no stated error was below the true one on 30
  // contacts of `make point-survey` whose three grids missed their tolerance.
  constexpr double of_waver = 3, of_irregular = 1;
  constexpr Caution away_from_edge{
      .of_last = 0.25, .of_waver = of_waver, .of_irregular = of_irregular};
  // Two of Richardson's values of the least film may agree by chance: its errors are less regular.
  constexpr Caution at_edge{
      .of_last = 0.5, .of_change = 0.1, .of_waver = of_waver, .of_irregular = of_irregular};
  solved.central = estimate(&FilmFeatures::central, away_from_edge);
  solved.minimum = estimate(&FilmFeatures::minimum, at_edge);
  solved.at_greatest_pressure = estimate(&FilmFeatures::at_greatest_pressure, away_from_edge);
  if (grids.back().integral > 0)
    solved.integral = estimate(&FilmFeatures::integral, away_from_edge);
}

// Whether the liquid of a starved contact reaches an end of the grid ahead or beside the contact.
bool is_wet_at_ends(const PointContact& contact, const PointFilm& film) {
  if (!contact.is_starved()) return false;
  const PlaneGrid& grid = film.grid;
  for (int j = 0; j + 1 < grid.count_y(); ++j)
    if (film.pressure[grid.node(1, j)] > 0) return true;
  for (int i = 0; i + 1 < grid.count_x(); ++i)
    if (film.pressure[grid.node(i, grid.count_y() - 2)] > 0) return true;
  return false;
}

// The least cells that the inlet needs: it is narrower under a greater load.
double least_cells(const PointContact& contact) {
  return std::fmax(8, 8 * std::pow(contact.load_number / 30, 0.38));
}

bool leaves_three_grids(const PointContact& contact, int cells, const PointOptions& options,
                        double longer = 1) {
  return 16 * grid_for(contact, cells, longer).size() <= options.greatest_nodes;
}

// `cells`, or fewer where three grids of this length would have too many nodes, but not fewer than
// the inlet needs.
int cells_that_fit(const PointContact& contact, int cells, const PointOptions& options,
                   double longer = 1) {
  while (cells > least_cells(contact) && !leaves_three_grids(contact, cells, options, longer))
    --cells;
  return cells;
}

// The cells that the coarsest grid begins with; 0 where three grids have too many nodes. Beyond M =
// 200 the least film needs more cells than the inlet. The exponent 1/4 is chosen on circles of M
// from 607 to 2000: without it three grids left an error of some per cent in their least films.
int first_cells(const PointContact& contact, const PointOptions& options) {
  const double least = least_cells(contact);
  if (!(least < 1e4)) return 0;  // an int holds them
  const double asked = least * std::fmax(1, std::pow(contact.load_number / 200, 0.25));
  const int cells = cells_that_fit(contact, rounded_up(asked), options);
  return leaves_three_grids(contact, cells, options) ? cells : 0;
}

// The films by the grids that follow from one coarsest grid.
SolvedPoint solve_from_coarsest(const PointContact& contact, int cells, const PointOptions& options,
                                const Watch& watch) {
  SolvedPoint solved;
  PlaneGrid grid = grid_for(contact, cells);
  const auto failed = [&](const PointFilm& film) {
    if (film.outcome == Outcome::solved) return false;
    solved.outcome = film.outcome;
    const std::string where =
        text("on the grid of %d by %d cells", film.grid.count_x() - 1, film.grid.beside);
    if (film.outcome == Outcome::stopped)
      solved.reason = "stopped " + where;
    else
      solved.reason = where + " neither Newton's method nor the film in time came to rest: " +
                      (std::isfinite(film.last_change)
                           ? text("the last step still changed the pressure by %.2g of Hertz' peak",
                                  film.last_change)
                           : text("the equations of step %d have no finite solution", film.steps));
    return true;
  };

  PointFilm film = solve_from_nothing(contact, grid, watch);
  for (double longer = length_step;
       film.outcome == Outcome::solved && is_wet_at_ends(contact, film) &&
       longer < greatest_length && 16 * grid.size() <= options.greatest_nodes;
       longer *= length_step) {
    cells = cells_that_fit(contact, cells, options, longer);
    grid = grid_for(contact, cells, longer);
    film = solve_on(contact, grid, film, watch);
  }
  if (failed(film)) return solved;
  if (is_wet_at_ends(contact, film)) {
    solved.reason = text(
        "the meniscus is not on the grid of %d by %d cells: so thick a layer of liquid all but "
        "floods the contact",
        grid.count_x() - 1, grid.beside);
    return solved;
  }
  std::vector<FilmFeatures> grids{features_of(film, options.integrand)};
  FilmFeatures larger = grids.front();  // starved: the meniscus is on it, the ends make no error
  // A grid whose ends take too much of the tolerance is made longer, as long as four grids still
  // fit, or three if four do not fit at first.
  const int least_room = 64 * grid.size() <= options.greatest_nodes ? 64 : 16;
  for (double longer = 1; !contact.is_starved(); longer *= length_step) {
    const PointFilm on_larger =
        solve_on(contact, grid_for(contact, cells, 1.5 * longer), film, watch);
    if (failed(on_larger)) return solved;
    larger = features_of(on_larger, options.integrand);
    if (domain_part_of(contact, grids.front(), larger) <= domain_share * options.tolerance) break;
    const PlaneGrid next = grid_for(contact, cells, length_step * longer);
    if (length_step * longer >= greatest_length ||
        least_room * next.size() > options.greatest_nodes)
      break;
    film = solve_on(contact, grid = next, film, watch);
    if (failed(film)) return solved;
    grids.front() = features_of(film, options.integrand);
  }
  const double domain_part = domain_part_of(contact, grids.front(), larger);
  const PlaneGrid coarsest = grid;
  while (4 * grid.size() <= options.greatest_nodes) {
    grid = grid.finer();
    PointFilm finer = solve_on(contact, grid, film, watch);
    if (failed(finer)) break;
    film = std::move(finer);
    grids.push_back(features_of(film, options.integrand));
    if (grids.size() < 3) continue;
    estimate_all(solved, contact, grids, larger);
    if (is_met(solved, options) || domain_share * worst_of(solved) < domain_part) break;
  }
  if (grids.size() >= 3 && !is_met(solved, options) && domain_part <= options.tolerance) {
    const double times = share_beside * (1 << (grids.size() - 1));
    const PointFilm beside =
        solve_on(contact, coarsest.finer(static_cast<int>(times)), film, watch);
    if (beside.outcome == Outcome::stopped) failed(beside);
    if (beside.outcome == Outcome::solved) {
      const FilmFeatures features = features_of(beside, options.integrand);
      estimate_all(solved, contact, grids, larger, &features);
    }
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
  if (is_met(solved, options)) {
    solved.reason.clear();
    return solved;
  }
  std::string met = text(
      "the tolerance of %g was not met: the errors are %.1g of the central film and %.1g of "
      "the least film on the grid of %d by %d cells",
      options.tolerance, solved.central.relative_error(), solved.minimum.relative_error(),
      solved.film.grid.count_x() - 1, solved.film.grid.beside);
  if (domain_part > options.tolerance)
    met += text(", of which up to %.1g comes from a grid that is not endless", solved.domain_error);
  solved.reason = met + (solved.reason.empty() ? "" : "; " + solved.reason);
  return solved;
}

// The length ahead that a layer of liquid may wet, over reach_of(). At its end the gap, that of dry
// bodies plus the film, is four times as thick as the layer. The meniscus was found where it is one
// to three times as thick.
double wet_length(const PointContact& contact) {
  const double film = expected_film(contact);
  const auto gap = [&](double x) {
    return film + ((x * x - 2) * std::acos(1 / x) + std::sqrt(x * x - 1)) / pi<double>();
  };
  double x = 1;
  while (x < 1000 && gap(x) < 4 * contact.inlet_film) x *= 1.05;
  return x / reach_of(contact);
}

}  // namespace

int more_cells(const PointContact& contact, int cells, const PointOptions& options) {
  int more = cells + cells / 2;
  while (!leaves_three_grids(contact, more, options)) --more;
  return more >= 1.1 * cells ? more : 0;
}

PlaneGrid grid_for(const PointContact& contact, int cells, double longer) {
  const double reach = reach_of(contact), k = numbers_of(contact).ellipticity;
  // Heavily loaded contacts have short inlets; under lighter loads the error from the ends falls
  // with the third power of the length.
  const double light = 20 / contact.load_number;
  double ahead =
      light < 1 ? 1.3 + 3.2 * std::pow(light, 0.27) : std::fmin(12, 4.5 * std::pow(light, 0.4));
  if (contact.is_starved()) ahead = wet_length(contact);
  const double side = std::fmax(2 * ahead / 3, 1.5);
  const double spread = -k / std::tan(FarInlet(contact).break_angle());
  const double behind = std::fmax(1.4, 1.1 * spread * side);
  const auto on = [&](double length) { return rounded_up(longer * length * cells); };
  return {on(ahead), on(behind), on(side), reach / cells, k * reach / cells};
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
  if (!(contact.radius_ratio >= 1e-3 && contact.radius_ratio <= 1e3)) {
    solved.reason =
        text("R_y/R_x is %.3g, and contacts from 0.001 to 1000 are solved; a longer one is a line",
             contact.radius_ratio);
    return solved;
  }
  if (m < least_point_load_number) {
    solved.reason = text(
        "M = %.3g is below %g: the load is too small to flatten the bodies, and the solver was "
        "not made for that",
        m, least_point_load_number);
    return solved;
  }
  if (contact.is_starved()) {
    const double layer = contact.inlet_film / expected_film(contact);
    if (!(layer >= least_layer && layer <= greatest_layer)) {
      solved.reason = text(
          "the layer of liquid at the inlet is %.3g times as thick as the flooded film is expected "
          "to be, and layers of %g to %g times its thickness are solved: a thicker one all but "
          "floods the "
          "contact, and of a thinner one the film is all but the layer",
          layer, least_layer, greatest_layer);
      return solved;
    }
  }
  int cells = first_cells(contact, options);
  if (cells == 0) {
    solved.reason = text("an error needs three grids, and %d nodes at most leave fewer at M = %.3g",
                         static_cast<int>(options.greatest_nodes), m);
    return solved;
  }
  std::string tried;
  SolvedPoint best;
  for (int i = 0; i < most_coarsest_grids && cells > 0;
       ++i, cells = more_cells(contact, cells, options)) {
    solved = solve_from_coarsest(contact, cells, options, watch);
    if (solved.outcome == Outcome::stopped) return best.outcome == Outcome::solved ? best : solved;
    tried += text(i == 0 ? "%d" : ", %d", cells);
    if (solved.outcome != Outcome::solved) continue;
    const bool is_last = is_met(solved, options) || !is_short_of_nodes(solved, options);
    if (best.outcome != Outcome::solved || worst_of(solved) < worst_of(best))
      best = std::move(solved);
    if (is_last) break;
  }
  if (best.outcome == Outcome::solved) return best;
  solved.reason = text(
      "no film was found at M = %.3g and L = %.3g, from coarsest grids of %s "
      "cells a semi-axis; %s",
      m, l, tried.c_str(), solved.reason.c_str());
  if (m > greatest_tried_point_load_number)
    solved.reason += text("; the solver was tried up to M = %g", greatest_tried_point_load_number);
  return solved;
}

}  // namespace tribo::ehl
