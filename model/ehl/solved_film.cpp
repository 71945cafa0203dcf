// SPDX-License-Identifier: Apache-2.0
#include "ehl/solved_film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ehl/text.hpp"

namespace tribo::ehl {
namespace {

using Feature = double FilmFeatures::*;

// The values of one feature on all grids.
std::vector<double> over_grids(const std::vector<FilmFeatures>& grids, Feature feature) {
  std::vector<double> values;
  values.reserve(grids.size());
  for (const FilmFeatures& f : grids) values.push_back(f.*feature);
  return values;
}

// The same nodes and more upstream, to an inlet that is twice as long. They need not be closer,
// because the pressure there falls with the third power of the distance.
Numbers with_longer_inlet(const Numbers& x) {
  constexpr int more = 16;
  Numbers longer;
  for (int i = 0; i < more; ++i)
    longer.push_back(x[0] * std::pow(2, 1 - static_cast<double>(i) / more));
  longer.insert(longer.end(), x.begin(), x.end());
  return longer;
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

// The contact in words, by the numbers that determine its film.
std::string name_of(const LineContact& contact) {
  const Fluid& fluid = contact.fluid;
  std::string name = text("M = %.3g and L = %.3g", contact.load_number, contact.material_number);
  if (fluid.exponent > 0) name += text(", αp₀ = %.3g", fluid.exponent);
  if (fluid.exponent > 0 && fluid.roelands_pressure > 0)
    name += text(", Roelands' z = %.3g", fluid.roelands_index);
  if (fluid.density_pressure > 0) name += ", a compressible liquid";
  return name;
}

// The message where no film was found: how far the last step had come.
std::string why_not(const Step& last, const LineFilm& film) {
  std::string why =
      text("on the grid of %d cells neither Newton's method nor the film in time came to rest: ",
           last.cells);
  return why + (std::isfinite(film.last_change)
                    ? text("step %d still changed the pressure by %.2g of Hertz' peak",
                           last.step + 1, film.last_change)
                    : text("the equations of step %d have no finite solution", last.step + 1));
}

// The shares for the films' errors. A spike that is too narrow for all grids still moves the films,
// more so in a compressible liquid, whose film follows the spike. The least film lies beside it.
struct FilmCautions {
  Caution away_from_spike, beside_spike;
};
FilmCautions cautions_of(bool is_compressible, std::size_t grids) {
  // Where the spike is not resolved, the values may waver as much as they change from grid to grid,
  // and the order with them.
  constexpr double least_order = 0.5, greatest_order = 4;
  const double less_by_grids = std::pow(0.35, std::max(0., static_cast<double>(grids) - 4));
  if (is_compressible)
    return {{0.85, 0.2, 0.015 * less_by_grids, 14},
            {1.45, 0.4, 0.33 * less_by_grids, 10.5, least_order, greatest_order}};
  return {{0.95, 0.08, 0.01 * less_by_grids, 16},
          {0.6, 0.25, 0.09 * less_by_grids, 5.5, least_order, greatest_order}};
}

// The state of the grid beside the finest one. `awaited`: it is not solved yet, and its part in the
// errors is taken as 0.
enum class BesideFinest : std::uint8_t { solved, awaited, failed };

void estimate_all(SolvedFilm& solved, const LineContact& contact,
                  const std::vector<FilmFeatures>& grids, BesideFinest is_beside,
                  const FilmFeatures& beside, double cells_ratio) {
  const FilmCautions cautions = cautions_of(contact.fluid.density_pressure > 0, grids.size());
  const auto estimate = [&](Feature feature, Caution caution) {
    if (is_beside == BesideFinest::awaited) caution.of_waver = 0;
    if (is_beside == BesideFinest::failed) caution.greatest_order = 0;  // no order is trusted
    Estimate e = estimate_of(over_grids(grids, feature), caution, {beside.*feature, cells_ratio});
    e.error += solved.domain_error * std::fabs(e.value);
    return e;
  };
  solved.central = estimate(&FilmFeatures::central, cautions.away_from_spike);
  solved.at_greatest_pressure =
      estimate(&FilmFeatures::at_greatest_pressure, cautions.away_from_spike);
  solved.minimum = estimate(&FilmFeatures::minimum, cautions.beside_spike);
  if (grids.back().integral > 0)
    solved.integral = estimate(&FilmFeatures::integral, cautions.away_from_spike);
  // In a compressible liquid this film follows the greatest pressure, which lies between nodes and
  // is known only to its difference from the pressure there.
  const FilmFeatures& finest = grids.back();
  const double ratio = contact.fluid.density(finest.greatest_pressure) /
                       contact.fluid.density(finest.pressure_beside_greatest);
  solved.at_greatest_pressure.error += std::fabs(ratio - 1) * solved.at_greatest_pressure.value;
  // If coarse grids do not show the spike, it is estimated from the finer grids that do.
  std::vector<FilmFeatures> with_spike;
  for (const FilmFeatures& f : grids) {
    if (!f.has_spike) with_spike.clear();
    if (f.has_spike) with_spike.push_back(f);
  }
  constexpr Caution of_spike{1, 0.5, 0};
  solved.spike_pressure =
      estimate_of(over_grids(with_spike, &FilmFeatures::spike_pressure), of_spike);
  solved.spike_place = estimate_of(over_grids(with_spike, &FilmFeatures::spike_place), of_spike);
}

}  // namespace

Estimate estimate_of(const std::vector<double>& values, const Caution& caution,
                     const Beside& beside) {
  Estimate e;
  const std::size_t n = values.size();
  if (n < 3) return e;
  const double last = values[n - 1] - values[n - 2], before = values[n - 2] - values[n - 3];
  e.value = values[n - 1];
  e.error = 1.5 * (std::fabs(last) + std::fabs(before));
  if (last == 0 && before == 0) return e;
  const double order = std::log2(before / last);
  const bool is_regular = order > caution.least_order && order < caution.greatest_order;
  const bool is_beside = !std::isnan(beside.value);
  if (!is_regular && !(is_beside && caution.of_irregular > 0)) return e;
  const auto richardson = [&](std::size_t i) {
    return values[i] + (values[i] - values[i - 1]) / 3;
  };
  e.value = richardson(n - 1);
  e.error = caution.of_change * std::fabs(last);
  if (is_beside) {
    const double second_order =
        e.value + (values[n - 1] - e.value) * beside.cells_ratio * beside.cells_ratio;
    e.error = std::fmax(e.error, caution.of_waver * std::fabs(beside.value - second_order));
  }
  if (!is_regular) {
    e.error = std::fmax(e.error,
                        caution.of_irregular * std::fmax(std::fabs(last), std::fabs(before) / 4));
    return e;
  }
  e.order = order;
  double share = n == 3 && !is_beside ? 3 * caution.of_last : caution.of_last;
  for (std::size_t i = n - 1; i >= 2 && i + 3 >= n; --i, share *= caution.falling)
    e.error = std::fmax(e.error, share * std::fabs(richardson(i) - richardson(i - 1)));
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

namespace {

// The film by the grids that follow from one coarsest grid. The tolerance only decides which grid
// is the last: if one tolerance is met, each greater one is met too, on fewer grids.
SolvedFilm solve_from_coarsest(const LineContact& contact, int cells, const SolveOptions& options,
                               const Watch& watch) {
  SolvedFilm solved;
  Step last{cells, 0, 0};
  const Watch noting = [&](const Step& step) {
    last = step;
    return !watch || watch(step);
  };
  const auto failed = [&](const LineFilm& film) {
    if (film.outcome == Outcome::solved) return false;
    solved.outcome = film.outcome;
    solved.reason =
        film.outcome == Outcome::stopped
            ? text("stopped on the grid of %d cells, before step %d", last.cells, last.step + 1)
            : why_not(last, film);
    return true;
  };

  CoarseFilm coarse =
      solve_coarse_film(contact, cells, scales_of(contact), options.at_edge, noting);
  if (failed(coarse.film)) return solved;

  LineFilm film;
  std::vector<FilmFeatures> grids;
  double worst = 0;         // relative error of the three films
  bool is_awaited = false;  // the grid beside the finest one
  const auto judge = [&](BesideFinest is_beside, const FilmFeatures& beside = {},
                         double cells_ratio = 1) {
    is_awaited = is_beside == BesideFinest::awaited;
    estimate_all(solved, contact, grids, is_beside, beside, cells_ratio);
    worst = std::max({solved.central.relative_error(), solved.minimum.relative_error(),
                      solved.at_greatest_pressure.relative_error()});
  };
  // A grid beside the finest one, with an eighth fewer cells, shows how much its values waver.
  const auto judge_by_grid_beside = [&] {
    const int finest = static_cast<int>(film.x.size()) - 1, fewer = finest - finest / 8;
    const LineFilm other = solve_on(contact, coarse.density.nodes(fewer), film, noting);
    if (failed(other))
      judge(BesideFinest::failed);
    else
      judge(BesideFinest::solved, features_of(contact, other, options.integrand),
            static_cast<double>(finest) / fewer);
  };
  const auto is_met = [&] {
    const bool is_of_domain = worst < 1.25 * solved.domain_error;  // a finer grid does not help
    // Without a spike the error is NaN, and this is true.
    const bool is_spike_met = !(solved.spike_pressure.relative_error() > options.spike_tolerance);
    return (worst <= options.tolerance || is_of_domain) && is_spike_met;
  };
  for (; cells <= options.greatest_cells; cells *= 2) {
    LineFilm finer = grids.empty() ? std::move(coarse.film)
                                   : solve_on(contact, coarse.density.nodes(cells), film, noting);
    if (failed(finer)) break;
    solved.steps = finer.steps;
    film = std::move(finer);
    grids.push_back(features_of(contact, film, options.integrand));
    if (grids.size() == 1) {
      const LineFilm longer = solve_on(contact, with_longer_inlet(film.x), film, noting);
      if (failed(longer)) break;
      const FilmFeatures there = features_of(contact, longer);
      // Upstream the pressure falls with the third power of the distance, and the load that is left
      // out there with the second: 4/3 of the change. A quarter is added, as this grid is coarse.
      solved.domain_error = 5. / 3 *
                            std::fmax(std::fabs(there.central / grids[0].central - 1),
                                      std::fabs(there.minimum / grids[0].minimum - 1));
    }
    if (grids.size() < 3) continue;
    // Errors that are too great without the grid beside are too great with it, too.
    judge(BesideFinest::awaited);
    if (!is_met()) continue;
    judge_by_grid_beside();
    if (is_met()) break;
  }
  if (is_awaited) judge_by_grid_beside();
  solved.grids = static_cast<int>(grids.size());
  solved.film = std::move(film);
  if (grids.size() < 3) {
    if (solved.reason.empty())
      solved.reason = text("an error needs three grids, and %d cells at most leave %d",
                           options.greatest_cells, solved.grids);
    return solved;
  }
  solved.outcome = Outcome::solved;
  if (worst <= options.tolerance) {
    solved.reason.clear();  // a finer grid may have failed, but was not needed
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

}  // namespace

SolvedFilm solve_line_film(const LineContact& contact, const SolveOptions& options,
                           const Watch& watch) {
  SolvedFilm solved;
  solved.reason = refusal(contact);
  if (!solved.reason.empty()) return solved;
  // Few cells are not enough for thin films under great loads, or where a spike draws most cells.
  constexpr int coarsest_grids = 5, first_cells = 64;
  constexpr double least_at_edge = 0.05;
  SolveOptions now = options;
  std::string tried;
  for (int i = 0, cells = first_cells; i < coarsest_grids; ++i, cells *= 2) {
    solved = solve_from_coarsest(contact, cells, now, watch);
    now.at_edge = std::max(now.at_edge / 2, std::min(now.at_edge, least_at_edge));
    if (solved.outcome != Outcome::not_converged) return solved;
    tried += text(i == 0 ? "%d" : ", %d", cells);
    if (4 * cells > options.greatest_cells) break;
  }
  solved.reason = text("no film was found at %s, from coarsest grids of %s cells; %s",
                       name_of(contact).c_str(), tried.c_str(), solved.reason.c_str());
  if (contact.load_number > greatest_tried_load_number ||
      contact.material_number > greatest_tried_material_number)
    solved.reason += text("; the solver was tried up to M = %g and L = %g",
                          greatest_tried_load_number, greatest_tried_material_number);
  return solved;
}

}  // namespace tribo::ehl
