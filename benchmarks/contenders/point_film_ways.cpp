// SPDX-License-Identifier: Apache-2.0
#include "contenders/point_film_ways.hpp"

#include <fmt/format.h>

#include "contenders/textbook_point_film.hpp"
#include "ehl/film_features.hpp"
#include "ehl/point_needs.hpp"

namespace tribo::benchmarks {
namespace {

constexpr Eigen::Index most_dense_nodes = 2500, most_relaxed_nodes = 20'000, most_nodes = 80'000;
constexpr int most_sweeps = 3000;

FilmAnswer answer_of(const ehl::PointContact& contact, const ehl::PointFilm& film, int steps) {
  FilmAnswer answer;
  answer.steps = steps;
  if (film.outcome != ehl::Outcome::solved) return answer;
  const ehl::FilmFeatures features = ehl::features_of(film);
  const double unit = ehl::numbers_of(contact).film_number;
  answer.central = unit * features.central;
  answer.minimum = unit * features.minimum;
  answer.at_greatest_pressure = unit * features.at_greatest_pressure;
  return answer;
}

ehl::PointFilm coarse_film(const ehl::PointContact& contact, int cells) {
  return ehl::solve_from_nothing(contact, ehl::grid_for(contact, cells), {});
}

// The node distances of each grid are half of those of the grid before it. The solution on a grid
// starts from the film on the grid before it.
FilmAnswer on_one_grid(const ehl::PointContact& contact, int cells) {
  const int coarsest = coarsest_cells(contact);
  ehl::PointFilm film = coarse_film(contact, coarsest);
  for (int n = 2 * coarsest; n <= cells && film.outcome == ehl::Outcome::solved; n *= 2)
    film = ehl::solve_on(contact, film.grid.finer(), film, {});
  return answer_of(contact, film, film.steps);
}

// The finest grid of on_one_grid().
ehl::PlaneGrid grid_of(const ehl::PointContact& contact, int cells) {
  ehl::PlaneGrid grid = ehl::grid_for(contact, coarsest_cells(contact));
  for (int n = coarsest_cells(contact); n < cells; n *= 2) grid = grid.finer();
  return grid;
}

FilmAnswer relaxed(const ehl::PointContact& contact, int cells) {
  TextbookPointFilm textbook(contact, grid_of(contact, cells));
  textbook.start_from(coarse_film(contact, coarsest_cells(contact)));
  const ehl::PointFilm film = textbook.relaxed(most_sweeps);
  return answer_of(contact, film, film.steps);
}

FilmAnswer dense(const ehl::PointContact& contact, int cells) {
  TextbookPointFilm textbook(contact, ehl::grid_for(contact, cells));
  textbook.start_from(coarse_film(contact, coarsest_cells(contact) / 2));
  const ehl::PointFilm film = textbook.newton();
  return answer_of(contact, film, film.steps);
}

}  // namespace

FilmAnswer film_numbers(const ehl::PointContact& contact, const ehl::SolvedPoint& solved) {
  FilmAnswer answer;
  answer.steps = solved.steps;
  if (solved.outcome != ehl::Outcome::solved) return answer;
  const double unit = ehl::numbers_of(contact).film_number;
  answer.central = unit * solved.central.value;
  answer.minimum = unit * solved.minimum.value;
  answer.at_greatest_pressure = unit * solved.at_greatest_pressure.value;
  return answer;
}

int coarsest_cells(const ehl::PointContact& contact) {
  const int cells = ehl::needs_of(contact).coarsest.count_x() - 1;
  int on_reach = 1;
  while (ehl::grid_for(contact, on_reach).count_x() - 1 < cells) ++on_reach;
  return on_reach;
}

std::vector<FilmWay<ehl::PointContact>> point_film_ways(const ehl::PointContact& contact) {
  using Contact = ehl::PointContact;
  std::vector<FilmWay<Contact>> ways;
  const auto add = [&](const char* family, const char* what, int cells, auto solve) {
    ways.push_back({family, fmt::format("{}: {}", family, what), fmt::format("{} {}", what, cells),
                    nullptr, [solve, cells](const Contact& one) { return solve(one, cells); }});
  };
  const int coarsest = coarsest_cells(contact);
  for (int cells = coarsest / 2; ehl::grid_for(contact, cells).size() <= most_dense_nodes;
       cells += coarsest / 4)
    add("textbook", "dense LU", cells, dense);
  for (int cells = coarsest; grid_of(contact, cells).size() <= most_relaxed_nodes; cells *= 2)
    add("textbook", "relaxation", cells, relaxed);
  for (int cells = coarsest; grid_of(contact, cells).size() <= most_nodes; cells *= 2)
    add("tribocheck", "one grid", cells, on_one_grid);
  for (const double tolerance : {1e-2, 3e-3, 1e-3})
    ways.push_back({"tribocheck", "tribocheck: to a stated error",
                    fmt::format("to {:.0e}", tolerance), nullptr, [tolerance](const Contact& one) {
                      return film_numbers(one,
                                          ehl::solve_point_film(one, {.tolerance = tolerance}));
                    }});
  return ways;
}

}  // namespace tribo::benchmarks
