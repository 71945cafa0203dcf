// SPDX-License-Identifier: Apache-2.0
#include "ehl/solved_film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace tribo::ehl {
namespace {

// The values of one feature on all grids.
template <class Feature>
std::vector<double> over_grids(const std::vector<FilmFeatures>& grids, const Feature& feature) {
  std::vector<double> values;
  values.reserve(grids.size());
  for (const FilmFeatures& f : grids) values.push_back(feature(f));
  return values;
}

// The same nodes, and more of them upstream, up to an inlet that is twice as long: close enough for
// the pressure there, which falls with the third power of the distance.
Numbers with_longer_inlet(const Numbers& x) {
  constexpr int more = 16;
  Numbers longer;
  for (int i = 0; i < more; ++i)
    longer.push_back(x[0] * std::pow(2, 1 - static_cast<double>(i) / more));
  longer.insert(longer.end(), x.begin(), x.end());
  return longer;
}

template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 300> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

// Why a contact is not tried; empty if it is.
std::string refusal(const LineContact& contact) {
  const double m = contact.load_number, l = contact.material_number;
  if (!std::isfinite(m) || !std::isfinite(l) || !std::isfinite(contact.fluid.exponent))
    return text("the numbers of this contact, M = %.3g and L = %.3g, are not finite", m, l);
  if (m < least_load_number)
    return text(
        "M = %.3g is below %g: the load is too small to flatten the bodies, and the solver was not "
        "made for that",
        m, least_load_number);
  const double film = expected_film(contact) / contact.film_number(1);
  if (film < least_film)
    return text(
        "the film is about %.1g of b²/R, by which the bodies are flattened; grids of double "
        "numbers resolve films down to %.0g of it",
        film, least_film);
  return {};
}

// Why Newton's method did not converge: what it had reached at its last step.
std::string why_not(const LineContact& contact, const Step& last) {
  const double m = contact.load_number, l = contact.material_number;
  const LineContact& there = last.contact;
  std::string why = text(
      "Newton's method did not converge at M = %.3g and L = %.3g, on the grid of %d cells: its "
      "step %d still changed the pressure by %.2g of Hertz' peak",
      there.load_number, there.material_number, last.cells, last.step, last.change);
  if (there.load_number != m || there.material_number != l)
    why += text("; this was on the way to M = %.3g and L = %.3g", m, l);
  if (m > greatest_tried_load_number || l > greatest_tried_material_number)
    why += text("; the solver was tried up to M = %g and L = %g", greatest_tried_load_number,
                greatest_tried_material_number);
  return why;
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

CoarseFilm solve_coarse_film(const LineContact& contact, int cells, const Scales& scales,
                             double at_edge, const Watch& watch) {
  CoarseFilm coarse{solve_from_nothing(contact, cells, scales, watch), first_density(scales)};
  LineFilm& film = coarse.film;
  if (film.outcome != Outcome::solved) return coarse;
  film = solve_on(contact, coarse.density.nodes(2 * cells), film, watch);
  if (film.outcome != Outcome::solved) return coarse;
  const std::size_t count = film.x.size();
  coarse.density =
      density_of(film.x, {film.pressure.data(), count}, {film.film.data(), count}, at_edge);
  film = solve_on(contact, coarse.density.nodes(cells), film, watch);
  return coarse;
}

SolvedFilm solve_line_film(const LineContact& contact, const SolveOptions& options,
                           const Watch& watch) {
  SolvedFilm solved;
  solved.reason = refusal(contact);
  if (!solved.reason.empty()) return solved;

  Step last{contact, options.first_cells, 0, 0};
  const Watch noting = [&](const Step& step) {
    last = step;
    return !watch || watch(step);
  };
  const auto failed = [&](const LineFilm& film) {
    if (film.outcome == Outcome::solved) return false;
    solved.outcome = film.outcome;
    solved.reason = film.outcome == Outcome::stopped
                        ? text("stopped on the grid of %d cells, before step %d of Newton's method",
                               last.cells, last.step + 1)
                        : why_not(contact, last);
    return true;
  };

  // An inlet of the usual length costs up to 2e-5 of the film.
  const Scales scales = scales_of(contact, std::fmax(1, std::sqrt(8e-5 / options.tolerance)));
  // Thin films under great loads are not found on few cells.
  int cells = options.first_cells;
  CoarseFilm coarse = solve_coarse_film(contact, cells, scales, options.at_edge, noting);
  while (coarse.film.outcome == Outcome::not_converged && cells < 8 * options.first_cells) {
    cells *= 2;
    coarse = solve_coarse_film(contact, cells, scales, options.at_edge, noting);
  }
  if (failed(coarse.film)) return solved;

  LineFilm film;
  std::vector<FilmFeatures> grids;
  double worst = 0;  // relative error of the three films
  for (; cells <= options.greatest_cells; cells *= 2) {
    LineFilm finer = grids.empty() ? std::move(coarse.film)
                                   : solve_on(contact, coarse.density.nodes(cells), film, noting);
    if (failed(finer)) break;
    solved.steps = finer.steps;
    film = std::move(finer);
    grids.push_back(features_of(contact, film));
    if (grids.size() == 1) {
      const LineFilm longer = solve_on(contact, with_longer_inlet(film.x), film, noting);
      if (failed(longer)) break;
      const FilmFeatures there = features_of(contact, longer);
      // Upstream the pressure falls with the third power of the distance, and the load that is left
      // out there with the second.
      solved.domain_error = 4. / 3 *
                            std::fmax(std::fabs(there.central / grids[0].central - 1),
                                      std::fabs(there.minimum / grids[0].minimum - 1));
    }
    if (grids.size() < 3) continue;
    estimate_all(solved, grids);
    worst = std::max({solved.central.relative_error(), solved.minimum.relative_error(),
                      solved.at_greatest_pressure.relative_error()});
    const bool is_of_domain = worst < 1.25 * solved.domain_error;  // no grid makes that less
    // Without a spike there is nothing to wait for.
    const bool is_spike_met = !(solved.spike_pressure.relative_error() > options.spike_tolerance);
    if (grids.size() > 3 && (worst <= options.tolerance || is_of_domain) && is_spike_met) break;
  }
  solved.grids = static_cast<int>(grids.size());
  solved.film = std::move(film);
  if (grids.size() < 3) return solved;
  solved.outcome = Outcome::solved;
  if (worst <= options.tolerance) {
    solved.reason.clear();  // of a grid that was not needed
    return solved;
  }
  std::string met =
      text("the tolerance of %g was not met: the error is %.1g on the grid of %d cells",
           options.tolerance, worst, static_cast<int>(solved.film.x.size()) - 1);
  if (solved.domain_error > options.tolerance)
    met += text(", of which %.1g comes from an inlet that is not endless", solved.domain_error);
  solved.reason = met + (solved.reason.empty() ? "" : "; " + solved.reason);
  return solved;
}

}  // namespace tribo::ehl
