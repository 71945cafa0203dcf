// SPDX-License-Identifier: Apache-2.0
#include "contenders/line_film_ways.hpp"

#include <fmt/format.h>

#include "contenders/dense_line_film.hpp"
#include "ehl/film_features.hpp"
#include "ehl/line_formulas.hpp"
#include "ehl/solved_film.hpp"

namespace tribo::benchmarks {
namespace {

constexpr int coarse_cells = 128;
constexpr double formula_speed_number = 1e-11;  // U

FilmAnswer answer_of(const ehl::LineContact& contact, const ehl::LineFilm& film) {
  FilmAnswer answer;
  answer.steps = film.steps;
  if (film.outcome != ehl::Outcome::solved) return answer;
  const ehl::FilmFeatures features = ehl::features_of(contact, film);
  answer.central = contact.film_number(features.central);
  answer.minimum = contact.film_number(features.minimum);
  answer.at_greatest_pressure = contact.film_number(features.at_greatest_pressure);
  return answer;
}

// Each grid has twice the cells of the grid before it. The solution on a grid starts from the film
// on the grid before it.
FilmAnswer on_one_grid(const ehl::LineContact& contact, int cells) {
  const ehl::CoarseFilm coarse = coarse_film(contact);
  ehl::LineFilm film = coarse.film;
  for (int n = coarse_cells; n <= cells && film.outcome == ehl::Outcome::solved; n *= 2)
    film = ehl::solve_on(contact, coarse.density.nodes(n), film, {});
  return answer_of(contact, film);
}

FilmAnswer dense(const ehl::LineContact& contact, int cells) {
  const ehl::CoarseFilm coarse = coarse_film(contact);
  ehl::LineFilm film = coarse.film;
  for (int n = coarse_cells; n <= cells && film.outcome == ehl::Outcome::solved; n *= 2) {
    DenseNewton newton(contact, coarse.density.nodes(n));
    newton.start_from(film);
    film = newton.run();
  }
  return answer_of(contact, film);
}

// The grid is uniform from X = −4, as in textbooks, to X = 1.5. Both ends lie further out if the
// film reaches further.
FilmAnswer uniform(const ehl::LineContact& contact, int cells) {
  const ehl::CoarseFilm coarse = coarse_film(contact);
  const double reach = (ehl::scales_of(contact).outlet_end - 1) / 2;
  const double from = -4 * reach, to = 1 + reach / 2;
  ehl::Numbers x;
  for (int i = 0; i <= cells; ++i) x.push_back(from + (to - from) * i / cells);
  DenseNewton newton(contact, x);
  newton.start_from(coarse.film);
  return answer_of(contact, newton.run());
}

FilmAnswer solved_to(const ehl::LineContact& contact, double tolerance) {
  return film_numbers(
      contact, ehl::solve_line_film(contact, {.tolerance = tolerance, .greatest_cells = 16384}));
}

double FilmAnswer::*place_of(ehl::FilmQuantity quantity) {
  if (quantity == ehl::FilmQuantity::central) return &FilmAnswer::central;
  if (quantity == ehl::FilmQuantity::minimum) return &FilmAnswer::minimum;
  return &FilmAnswer::at_greatest_pressure;
}

}  // namespace

FilmAnswer film_numbers(const ehl::LineContact& contact, const ehl::SolvedFilm& solved) {
  FilmAnswer answer;
  answer.steps = solved.steps;
  if (solved.outcome != ehl::Outcome::solved) return answer;
  answer.central = contact.film_number(solved.central.value);
  answer.minimum = contact.film_number(solved.minimum.value);
  answer.at_greatest_pressure = contact.film_number(solved.at_greatest_pressure.value);
  return answer;
}

ehl::CoarseFilm coarse_film(const ehl::LineContact& contact) {
  return ehl::solve_coarse_film(contact, coarse_cells, ehl::scales_of(contact),
                                ehl::SolveOptions{}.at_edge, {});
}

std::vector<LineFilmWay> line_film_ways() {
  std::vector<LineFilmWay> ways;
  for (const ehl::LineFormula& formula : ehl::line_formulas) {
    double FilmAnswer::*const place = place_of(formula.quantity);
    ways.push_back(
        {"published fit", "published fit: " + std::string(formula.name), std::string(formula.name),
         place, [&formula, place](const ehl::LineContact& contact) {
           FilmAnswer answer;
           if (contact.material_number > 0)
             answer.*place = ehl::film_number(formula, contact.load_number, contact.material_number,
                                              formula_speed_number);
           return answer;
         }});
  }
  const auto add = [&](const char* family, const char* what, int greatest_cells, auto solve) {
    for (int cells = coarse_cells; cells <= greatest_cells; cells *= 2)
      ways.push_back(
          {family, fmt::format("{}: {}", family, what), fmt::format("{} {}", what, cells), nullptr,
           [solve, cells](const ehl::LineContact& contact) { return solve(contact, cells); }});
  };
  add("textbook", "dense LU, uniform grid", 2048, uniform);
  add("textbook", "dense LU, our grid", 2048, dense);
  add("tribocheck", "one grid", 8192, on_one_grid);
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    ways.push_back(
        {"tribocheck", "tribocheck: to a stated error", fmt::format("to {:.0e}", tolerance),
         nullptr,
         [tolerance](const ehl::LineContact& contact) { return solved_to(contact, tolerance); }});
  return ways;
}

}  // namespace tribo::benchmarks
