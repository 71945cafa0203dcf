// SPDX-License-Identifier: Apache-2.0
#include "film_case.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "ehl/film_conditions.hpp"
#include "ehl/line_formulas.hpp"
#include "ehl/point_formulas.hpp"
#include "ehl/point_needs.hpp"
#include "ehl/solved_film.hpp"
#include "ehl/solved_point.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/friction.hpp"
#include "tribo/moes_film.hpp"
#include "tribo/starvation.hpp"

namespace tribo::cli {
namespace {

// Share of nodes in the outlet's constriction: resolves spikes as far as the films allow.
constexpr double at_edge = 0.3;
// A spike's height is told only where its relative error is at most this.
constexpr double greatest_spike_error = 0.02;

constexpr Measured unknown{std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::quiet_NaN()};

ehl::FilmConditions conditions_of(const Scene& scene, double speed, const FilmSettings& settings) {
  ehl::FilmConditions conditions = ehl::conditions_of(scene, speed);
  if (!settings.viscosity.empty())
    conditions.viscosity_law =
        settings.viscosity == "roelands" ? ViscosityLaw::roelands : ViscosityLaw::barus;
  if (settings.density == "dowson_higginson")
    conditions.density_law = ehl::FilmDensity::dowson_higginson;
  if (settings.is_flooded) conditions.inlet_film = std::numeric_limits<double>::infinity();
  return conditions;
}

Measured times(const ehl::Estimate& estimate, double scale) {
  return {estimate.value * scale, estimate.error * scale};
}

std::string_view stands_for(ehl::FilmQuantity quantity) {
  if (quantity == ehl::FilmQuantity::central) return "central_film";
  return quantity == ehl::FilmQuantity::minimum ? "minimum_film" : "film_at_greatest_pressure";
}

void set_spike(FilmCase& film, const ehl::SolvedFilm& solved, const ehl::LineContact& contact,
               const ehl::FilmScale& scale) {
  film.spike_pressure = film.spike_place = unknown;
  if (!ehl::features_of(contact, solved.film).has_spike) {
    film.no_spike = fmt::format(
        "there is no spike at M = {:.3g} and L = {:.3g}: behind its greatest value "
        "the pressure only falls",
        contact.load_number, contact.material_number);
    return;
  }
  const ehl::Estimate& height = solved.spike_pressure;
  if (std::isnan(height.value)) {
    film.no_spike = "not resolved: fewer than three grids show it";
    return;
  }
  film.spike_place = times(solved.spike_place, scale.half_width);
  if (height.relative_error() <= greatest_spike_error)
    film.spike_pressure = times(height, scale.peak_pressure);
  else
    film.no_spike = fmt::format(
        "not resolved: it still changed by {:.0f} % from grid to grid, to {:.3g} Pa on the grid of "
        "{} cells",
        100 * height.relative_error(), height.value * scale.peak_pressure, film.cells);
}

ehl::FilmConditions of_liquid(ehl::FilmConditions conditions, ehl::FitLiquid liquid) {
  const bool is_roelands = liquid == ehl::FitLiquid::roelands_compressible;
  conditions.viscosity_law = is_roelands ? ViscosityLaw::roelands : ViscosityLaw::barus;
  conditions.density_law =
      is_roelands ? ehl::FilmDensity::dowson_higginson : ehl::FilmDensity::incompressible;
  return conditions;
}

bool is_of(const ehl::FilmConditions& conditions, ehl::FitLiquid liquid) {
  const ehl::FilmConditions other = of_liquid(conditions, liquid);
  return conditions.viscosity_law == other.viscosity_law &&
         conditions.density_law == other.density_law;
}

// The solved film of the liquid that a formula was fitted to. Empty if that liquid is not known, if
// Roelands' law has no liquid of this viscosity, or if the film is not solved.
std::optional<ehl::SolvedFilm> film_of_fit(ehl::FilmConditions conditions, ehl::FitLiquid liquid,
                                           const ehl::SolveOptions& options,
                                           const ehl::Watch& watch) {
  if (liquid == ehl::FitLiquid::unknown) return std::nullopt;
  conditions = of_liquid(conditions, liquid);
  if (conditions.viscosity_law == ViscosityLaw::roelands &&
      !(conditions.viscosity > least_roelands_viscosity))
    return std::nullopt;
  ehl::SolvedFilm solved = ehl::solve_line_film(ehl::contact_of(conditions), options, watch);
  if (solved.outcome != ehl::Outcome::solved) return std::nullopt;
  return solved;
}

// `solved`: the film of the contact's own liquid. The films of other liquids that formulas were
// fitted to are solved here, each once.
void set_formulas(FilmCase& film, const ehl::SolvedFilm& solved,
                  const ehl::FilmConditions& conditions, const ehl::SolveOptions& options,
                  const ehl::Watch& watch) {
  const ehl::LineContact contact = ehl::contact_of(conditions);
  const ehl::FilmScale scale = ehl::scale_of(conditions);
  const double unit = scale.film / contact.film_number(1);
  std::map<ehl::FitLiquid, std::optional<ehl::SolvedFilm>> of_fits;
  for (const ehl::LineFormula& formula : ehl::line_formulas) {
    const double length = unit * ehl::film_number(formula, contact.load_number,
                                                  contact.material_number, scale.speed_number);
    const auto off = [&](const ehl::SolvedFilm& one) {
      return length / (scale.film * ehl::compared_film(formula, one).value) - 1;
    };
    double deviation = unknown.value;
    if (film.is_solved && is_of(conditions, formula.liquid) &&
        formula.liquid != ehl::FitLiquid::unknown) {
      deviation = off(solved);
    } else if (film.is_solved) {
      const auto [found, is_new] = of_fits.try_emplace(formula.liquid);
      if (is_new) found->second = film_of_fit(conditions, formula.liquid, options, watch);
      if (found->second) deviation = off(*found->second);
    }
    film.formulas.push_back({formula.name, stands_for(formula.quantity), ehl::name(formula.liquid),
                             length, deviation, off(solved)});
  }
}

// Adds the films by the laws of point contacts, and by other readings of them, beside the films of
// a flooded contact. The liquid that these laws were fitted to is not known.
void set_point_formulas(FilmCase& film, const ehl::FilmConditions& c,
                        const ehl::SolvedPoint& flooded) {
  const double unit = ehl::scale_of(c).film;
  const auto add = [&](std::string_view name, ehl::FilmQuantity quantity, double length) {
    const bool is_minimum = quantity == ehl::FilmQuantity::minimum;
    const double solved = unit * (is_minimum ? flooded.minimum.value : flooded.central.value);
    film.formulas.push_back({name, stands_for(quantity), ehl::name(ehl::FitLiquid::unknown), length,
                             unknown.value, length / solved - 1});
  };
  for (const NamedFilmLaw& named : named_film_laws) {
    if (named.law->is_of_lines || named.law->is_solved()) continue;
    double length = unknown.value;
    if (!named.law->has_fixed_exponents())
      length = MoesFilm<double>(*named.law, c.viscosity, c.pressure_viscosity, c.load,
                                c.effective_modulus, c.radius, 1 / c.radius_ratio, 1.)
                   .at(c.speed, 1.)
                   .film_parameter;
    // If α = 0, only laws with the exponent 0 of α have a film; they get 1 in its place.
    else if (c.pressure_viscosity > 0 || named.law->material_exponent.p == 0)
      length = film_thickness(*named.law, c.speed, c.viscosity,
                              c.pressure_viscosity > 0 ? c.pressure_viscosity : 1., c.load,
                              c.effective_modulus, c.radius, film.ellipticity);
    add(named.word,
        named.word.ends_with("_minimum") ? ehl::FilmQuantity::minimum : ehl::FilmQuantity::central,
        length);
  }
  for (const ehl::PointFormula& formula : ehl::point_formulas)
    add(formula.name, formula.quantity, ehl::film_thickness(formula, c));
}

// Sets the flooded film of a starved contact beside its own, and each closure's ratio of the two.
void set_closures(FilmCase& film, const ehl::SolvedPoint& flooded, const Scene& scene,
                  double unit) {
  film.flooded_central = times(flooded.central, unit);
  const double ratio = film.central.value / film.flooded_central.value;
  film.film_ratio = {
      ratio, ratio * (film.central.error / film.central.value + flooded.central.relative_error())};
  const double flooded_over_inlet = film.flooded_central.value / film.inlet_film;
  const auto by = [&](StarvationClosure closure, double exponent) {
    return starvation_ratio(closure, flooded_over_inlet, exponent);
  };
  for (std::size_t i = 0; i < starvation_closure_words.size(); ++i) {
    const double found = by(static_cast<StarvationClosure>(i), scene.closures.damiens_exponent);
    film.closures.push_back({starvation_closure_words[i], found, found / ratio - 1});
  }
  const auto off = [&](double log_exponent) {
    return by(StarvationClosure::damiens, std::exp(log_exponent)) - ratio;
  };
  const double least = -4, greatest = 5;  // of ln γ
  if (!(off(least) < 0 && off(greatest) > 0)) return;
  std::uintmax_t steps = 100;
  const auto root = boost::math::tools::toms748_solve(
      off, least, greatest, boost::math::tools::eps_tolerance<double>(40), steps);
  film.damiens_exponent = std::exp(root.first);
}

void set_profile(FilmCase& film, const ehl::PointFilm& point, const ehl::FilmScale& scale) {
  for (int i = 0; i < point.grid.count_x(); ++i) {
    const Eigen::Index node = point.grid.node(i, 0);
    film.profile.push_back({point.grid.x(i) * scale.half_width,
                            point.pressure[node] * scale.peak_pressure,
                            point.film[node] * scale.film});
  }
}

void set_fields(FilmCase& film, const ehl::PointFilm& point, const ehl::FilmScale& scale) {
  const auto times = [](const Eigen::VectorXd& values, double unit) {
    std::vector<double> all(static_cast<std::size_t>(values.size()));
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = unit * values[static_cast<Eigen::Index>(i)];
    return all;
  };
  const ehl::PlaneGrid& grid = point.grid;
  for (int i = 0; i < grid.count_x(); ++i) film.fields.x.push_back(grid.x(i) * scale.half_width);
  for (int j = 0; j < grid.count_y(); ++j) film.fields.y.push_back(grid.y(j) * scale.half_width);
  film.fields.pressure = times(point.pressure, scale.peak_pressure);
  film.fields.film = times(point.film, scale.film);
}

void set_profile(FilmCase& film, const ehl::LineFilm& line, const ehl::FilmScale& scale) {
  film.profile.reserve(line.x.size());
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    film.profile.push_back({line.x[i] * scale.half_width, line.pressure[node] * scale.peak_pressure,
                            line.film[node] * scale.film});
  }
}

}  // namespace

std::vector<std::string_view> film_formula_names() {
  std::vector<std::string_view> names;
  names.reserve(ehl::line_formulas.size());
  for (const ehl::LineFormula& formula : ehl::line_formulas) names.push_back(formula.name);
  for (const NamedFilmLaw& named : named_film_laws)
    if (!named.law->is_of_lines && !named.law->is_solved()) names.push_back(named.word);
  for (const ehl::PointFormula& formula : ehl::point_formulas) names.push_back(formula.name);
  return names;
}

namespace {

// A case with the numbers that are known before the contact is solved.
FilmCase given_case(const Scene& scene, const ehl::FilmConditions& conditions,
                    const FilmSettings& settings) {
  const ehl::FilmScale scale = ehl::scale_of(conditions);
  FilmCase film{};
  film.id = scene.id;
  film.viscosity = conditions.viscosity_law == ViscosityLaw::roelands ? "roelands" : "barus";
  film.density = conditions.density_law == ehl::FilmDensity::dowson_higginson ? "dowson_higginson"
                                                                              : "incompressible";
  film.speed = conditions.speed;
  film.half_width = scale.half_width;
  film.peak_pressure = scale.peak_pressure;
  film.ellipticity = conditions.is_line() ? unknown.value : scale.ellipticity;
  film.tolerance = settings.tolerance > 0 ? settings.tolerance : conditions.is_line() ? 1e-4 : 1e-3;
  film.inlet_film = conditions.is_starved() ? conditions.inlet_film : unknown.value;
  film.flooded_central = film.film_ratio = film.friction = film.spike_pressure = film.spike_place =
      unknown;
  film.damiens_exponent = unknown.value;
  return film;
}

template <class Contact, class Solved>
void set_films(FilmCase& film, const Contact& contact, const Solved& solved, double unit) {
  film.load_number = contact.load_number;
  film.material_number = contact.material_number;
  film.is_solved = solved.outcome == ehl::Outcome::solved;
  film.reason = solved.reason;
  film.grids = solved.grids;
  film.steps = solved.steps;
  film.central = times(solved.central, unit);
  film.minimum = times(solved.minimum, unit);
  film.at_greatest_pressure = times(solved.at_greatest_pressure, unit);
}

ehl::SolveOptions line_options(double tolerance) {
  return {.tolerance = tolerance,
          .greatest_cells = tolerance < 1e-5 ? 32768 : 8192,
          .at_edge = at_edge};
}

// The shear stress over p₀ as a function of P and H, by the scene's law and with the viscosity of
// the liquid that is solved. Empty if the scene has no lubricant.eyring_stress.
ehl::Integrand shear_stress_of(const Scene& scene, const ehl::FilmConditions& conditions) {
  if (!scene.lubricant.eyring_stress) return {};
  return
      [=, scale = ehl::scale_of(conditions), fluid = scene.friction.fluid,
       limit = *scene.lubricant.eyring_stress,
       sliding = scene.friction.slide_roll_ratio * conditions.speed](double pressure, double film) {
        const double thickening =
            log_viscosity_ratio(conditions.viscosity_law, conditions.viscosity,
                                conditions.pressure_viscosity, pressure * scale.peak_pressure);
        return fluid_shear_stress(fluid, limit, conditions.viscosity, thickening, sliding,
                                  film * scale.film) /
               scale.peak_pressure;
      };
}

// Sets friction from the integral of `stress` over X, for points over X and Y. `area` turns the
// integral into SI units: for lines the unit of X (m), for points its square (m²). If `stress` is
// empty, the reason why there is no friction is set.
void set_friction(FilmCase& film, const ehl::Integrand& stress, const ehl::Estimate& integral,
                  double area, const ehl::FilmConditions& conditions) {
  if (stress)
    film.friction =
        times(integral, area * ehl::scale_of(conditions).peak_pressure / conditions.load);
  else
    film.no_friction = "friction needs lubricant.eyring_stress";
}

void solve_line(FilmCase& film, const Scene& scene, const ehl::FilmConditions& conditions,
                const ehl::Watch& watch) {
  const ehl::FilmScale scale = ehl::scale_of(conditions);
  const ehl::LineContact contact = ehl::contact_of(conditions);
  const ehl::SolveOptions options = line_options(film.tolerance);
  ehl::SolveOptions with_friction = options;
  with_friction.integrand = shear_stress_of(scene, conditions);
  const ehl::SolvedFilm solved = ehl::solve_line_film(contact, with_friction, watch);
  set_films(film, contact, solved, scale.film);
  ehl::SolveOptions of_fits = options;
  of_fits.tolerance = std::fmax(options.tolerance, 1e-4);
  set_formulas(film, solved, conditions, of_fits, watch);
  if (!film.is_solved) return;
  set_friction(film, with_friction.integrand, solved.integral, scale.half_width, conditions);
  film.cells = static_cast<int>(solved.film.x.size()) - 1;
  set_spike(film, solved, contact, scale);
  set_profile(film, solved.film, scale);
}

void solve_point(FilmCase& film, const Scene& scene, ehl::FilmConditions conditions,
                 bool with_fields, const ehl::Watch& watch) {
  const ehl::FilmScale scale = ehl::scale_of(conditions);
  const ehl::PointContact contact = ehl::point_contact_of(conditions);
  const ehl::PointOptions options{.tolerance = film.tolerance};
  ehl::PointOptions with_friction = options;
  with_friction.integrand = shear_stress_of(scene, conditions);
  const ehl::SolvedPoint solved = ehl::solve_point_film(contact, with_friction, watch);
  set_films(film, contact, solved, scale.film);
  if (!conditions.is_starved()) {
    set_point_formulas(film, conditions, solved);
  } else if (film.is_solved) {
    conditions.inlet_film = std::numeric_limits<double>::infinity();
    const ehl::SolvedPoint flooded =
        ehl::solve_point_film(ehl::point_contact_of(conditions), options, watch);
    film.steps += flooded.steps;
    set_point_formulas(film, conditions, flooded);
    if (flooded.outcome == ehl::Outcome::solved) set_closures(film, flooded, scene, scale.film);
    if (!flooded.reason.empty())
      film.reason += (film.reason.empty() ? "" : "; ") + ("the flooded film: " + flooded.reason);
  }
  if (!film.is_solved) return;
  set_friction(film, with_friction.integrand, solved.integral, scale.half_width * scale.half_width,
               conditions);
  film.no_spike = "not given for circles and ellipses, whose grids do not resolve it";
  film.cells = solved.film.grid.count_x() - 1;
  film.cells_across = 2 * solved.film.grid.beside;
  set_profile(film, solved.film, scale);
  if (with_fields) set_fields(film, solved.film, scale);
}

}  // namespace

FilmNeeds needs_of_film(const Scene& scene, double speed, const FilmSettings& settings) {
  const ehl::FilmConditions conditions = conditions_of(scene, speed, settings);
  const FilmCase given = given_case(scene, conditions, settings);
  constexpr double program = 12e6;  // bytes, without any contact
  if (conditions.is_line()) {
    const ehl::LineContact contact = ehl::contact_of(conditions);
    // Time and memory are fits to measurements. They include a second solve, of the liquid that
    // formulas were fitted to.
    const auto on = [](int grids) {
      const double nodes = std::ldexp(64, grids - 1) + 1;
      return FilmNeeds::Grids{grids, nodes, 1e-4 * nodes * std::fmax(1, nodes / 1000),
                              program + 7000 * nodes};
    };
    const int most =
        1 + static_cast<int>(std::log2(line_options(given.tolerance).greatest_cells / 64));
    return {given.viscosity,
            given.density,
            given.tolerance,
            contact.load_number,
            contact.material_number,
            {},
            on(3),
            on(most)};
  }
  const ehl::PointContact contact = ehl::point_contact_of(conditions);
  const ehl::PointNeeds needs = ehl::needs_of(contact, {.tolerance = given.tolerance});
  const auto on = [&](int grids, Eigen::Index nodes) {
    return FilmNeeds::Grids{grids, static_cast<double>(nodes), ehl::point_seconds(contact, nodes),
                            program + ehl::point_memory(nodes)};
  };
  return {given.viscosity,
          given.density,
          given.tolerance,
          contact.load_number,
          contact.material_number,
          needs.reason,
          on(needs.least_grids, needs.finest(needs.least_grids).size()),
          on(needs.most_grids, needs.most_nodes)};
}

std::string key_of_film(const Scene& scene, double speed, const FilmSettings& settings) {
  const ehl::FilmConditions c = conditions_of(scene, speed, settings);
  const FilmCase film = given_case(scene, c, settings);
  const std::string friction =
      scene.lubricant.eyring_stress
          ? fmt::format("{} {} {}", *scene.lubricant.eyring_stress,
                        fluid_shear_words[static_cast<std::size_t>(scene.friction.fluid)],
                        scene.friction.slide_roll_ratio)
          : "-";
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {}", c.speed, c.viscosity,
                     c.pressure_viscosity, c.load, c.effective_modulus, c.radius, c.radius_ratio,
                     c.inlet_film, film.viscosity, film.density, film.tolerance,
                     scene.closures.damiens_exponent, friction, scene.id);
}

bool is_of_line(const Scene& scene) { return ehl::conditions_of(scene, 1).is_line(); }

FilmCase solve_film(const Scene& scene, double speed, const FilmSettings& settings,
                    const FilmWatch& watch) {
  const ehl::FilmConditions conditions = conditions_of(scene, speed, settings);
  const ehl::Watch step_watch = [&](const ehl::Step& step) { return watch(step.cells, step.step); };
  FilmCase film = given_case(scene, conditions, settings);
  if (conditions.is_line())
    solve_line(film, scene, conditions, step_watch);
  else
    solve_point(film, scene, conditions, settings.with_fields, step_watch);
  return film;
}

}  // namespace tribo::cli
