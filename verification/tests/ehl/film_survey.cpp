// SPDX-License-Identifier: Apache-2.0
// Prints rows on random contacts (sampled_contact.hpp) for verification/gates/film_survey.py. Lines
// are solved to four tolerances and compared with films that are solved to 1e-6. Their work is the
// number of cells, added up over Newton's steps. Points are only drawn; or solved to the tolerance
// of the contract; or solved on few nodes (held_nodes) and compared with films on cells of half the
// size and on a grid of twice the length.
#include <fmt/format.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <vector>

#include "ehl/sampled_contact.hpp"
#include "ehl/solved_film.hpp"
#include "ehl/solved_point.hpp"

namespace {

using namespace tribo;

constexpr std::array<double, 4> tolerances{1e-5, 1e-4, 1e-3, 1e-2};
// The most nodes of held films: cells of half the size take four times as many.
Eigen::Index held_nodes(double load_number) { return load_number > 200 ? 150'000 : 55'000; }
constexpr std::array<const char*, 3> names{"central", "minimum", "at_greatest_pressure"};
constexpr std::array<ehl::Estimate ehl::SolvedFilm::*, 3> films{
    &ehl::SolvedFilm::central, &ehl::SolvedFilm::minimum, &ehl::SolvedFilm::at_greatest_pressure};
constexpr std::array<ehl::Estimate ehl::SolvedPoint::*, 3> point_films{
    &ehl::SolvedPoint::central, &ehl::SolvedPoint::minimum,
    &ehl::SolvedPoint::at_greatest_pressure};
constexpr std::array<double ehl::FilmFeatures::*, 3> features{
    &ehl::FilmFeatures::central, &ehl::FilmFeatures::minimum,
    &ehl::FilmFeatures::at_greatest_pressure};

struct Worked {
  ehl::SolvedFilm film;
  double work = 0;
};

Worked solve(const ehl::LineContact& contact, double tolerance, int greatest_cells) {
  Worked worked;
  worked.film =
      ehl::solve_line_film(contact, {.tolerance = tolerance, .greatest_cells = greatest_cells},
                           [&](const ehl::Step& step) {
                             worked.work += step.cells;
                             return true;
                           });
  return worked;
}

void print_heading(const char* columns) {
  fmt::print("{}", columns);
  for (const char* film : names) fmt::print(",{0},{0}_error,{0}_off,{0}_known", film);
  fmt::print("\n");
}

void print_film(const ehl::Estimate& one, const ehl::Estimate& truth) {
  fmt::print(",{:.12g},{:.4g},{:.4g},{:.4g}", one.value, one.error,
             std::fabs(one.value - truth.value), truth.error);
}

void survey_lines(int first, int end, std::uint64_t seed) {
  verification::ContactSampler sampler(seed);
  print_heading(
      "contact,load_number,material_number,is_roelands,is_compressible,tolerance,solved,met,work");
  for (int i = 0; i < end; ++i) {
    const verification::SampledContact drawn = sampler.next();
    if (i < first) continue;
    const ehl::SolvedFilm exact = solve(drawn.contact, 1e-6, 16384).film;
    for (const double tolerance : tolerances) {
      const auto [film, work] = solve(drawn.contact, tolerance, 8192);
      const bool is_solved = film.outcome == ehl::Outcome::solved;
      fmt::print("{},{:.6g},{:.6g},{:d},{:d},{:g},{:d},{:d},{}", i, drawn.contact.load_number,
                 drawn.contact.material_number, drawn.is_roelands, drawn.is_compressible, tolerance,
                 is_solved, is_solved && film.reason.empty(), work);
      for (std::size_t k = 0; k < films.size(); ++k) print_film(film.*films[k], exact.*films[k]);
      fmt::print("\n");
    }
  }
}

// The three films, each estimated from all grids of a solved film and one finer grid. A grid
// of twice the length, with the coarsest cells, tells by how much the length changes them. This
// change falls with the third power of the length, which gives what is left. NaN where a grid was
// not solved.
std::array<ehl::Estimate, 3> truth_of(const ehl::PointContact& contact,
                                      const ehl::SolvedPoint& solved) {
  ehl::PlaneGrid grid = solved.film.grid;
  const int part = 1 << (solved.grids - 1);
  grid = {grid.ahead / part, grid.behind / part, grid.beside / part, grid.dx * part,
          grid.dy * part};
  ehl::PointFilm film = solved.film;
  std::vector<ehl::FilmFeatures> grids;
  ehl::FilmFeatures longer;
  for (int k = 0; k <= solved.grids; ++k, grid = grid.finer()) {
    film = ehl::solve_on(contact, grid, k < solved.grids ? solved.film : film, {});
    if (film.outcome != ehl::Outcome::solved) return {};
    grids.push_back(ehl::features_of(film));
    if (k > 0) continue;
    longer = grids.front();
    if (contact.is_starved()) continue;  // its meniscus is on the grid
    const ehl::PlaneGrid twice{2 * grid.ahead, 2 * grid.behind, 2 * grid.beside, grid.dx, grid.dy};
    const ehl::PointFilm on_twice = ehl::solve_on(contact, twice, film, {});
    if (on_twice.outcome != ehl::Outcome::solved) return {};
    longer = ehl::features_of(on_twice);
  }
  std::array<ehl::Estimate, 3> truth;
  for (std::size_t k = 0; k < features.size(); ++k) {
    std::vector<double> values;
    for (const ehl::FilmFeatures& f : grids) values.push_back(f.*features[k]);
    truth[k] = ehl::estimate_of(values);
    const double by_length = longer.*features[k] / values.front();
    truth[k].error += truth[k].value * std::fabs(by_length - 1) / 7;
    truth[k].value *= by_length;
  }
  return truth;
}

// `what`: drawn, solved or held.
void survey_points(std::string_view what, int first, int end, std::uint64_t seed) {
  verification::PointSampler sampler(seed);
  print_heading(
      "contact,radius_ratio,supply,load_number,material_number,tolerance,solved,met,reason,grids,"
      "nodes,seconds,megabytes");
  for (int i = 0; i < end; ++i) {
    const verification::SampledPoint drawn = sampler.next();
    if (i < first) continue;
    const ehl::PointContact& contact = drawn.contact;
    ehl::PointOptions options{.tolerance = contact.load_number > 200 ? 3e-3 : 1e-3};
    if (what == "held") options.greatest_nodes = held_nodes(contact.load_number);
    const ehl::SolvedPoint solved =
        what == "drawn" ? ehl::SolvedPoint{} : ehl::solve_point_film(contact, options);
    const double seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const bool is_solved = solved.outcome == ehl::Outcome::solved;
    fmt::print("{},{:.6g},{:.6g},{:.6g},{:.6g},{:g},{:d},{:d},\"{}\",{},{},{:.2f},{}", i,
               contact.radius_ratio, drawn.supply, contact.load_number, contact.material_number,
               options.tolerance, is_solved, is_solved && solved.reason.empty(), solved.reason,
               solved.grids, solved.film.pressure.size(), seconds, used.ru_maxrss / 1024);
    std::array<ehl::Estimate, 3> truth;
    if (what == "held" && is_solved) truth = truth_of(contact, solved);
    for (std::size_t k = 0; k < point_films.size(); ++k)
      print_film(solved.*point_films[k], truth[k]);
    fmt::print("\n");
  }
}

}  // namespace

// film_survey WHAT FIRST END SEED
int main(int argc, char** argv) {
  const std::string_view what = argc == 5 ? argv[1] : "";
  if (what != "lines" && what != "drawn" && what != "solved" && what != "held") {
    std::fputs(
        "film_survey lines|drawn|solved|held FIRST END SEED: the line contacts FIRST to END - 1 of "
        "this seed, or the point contacts drawn, solved, or held to a finer and a longer grid\n",
        stderr);
    return 2;
  }
  const int first = std::atoi(argv[2]), end = std::atoi(argv[3]);
  const std::uint64_t seed = std::strtoull(argv[4], nullptr, 10);
  if (what == "lines")
    survey_lines(first, end, seed);
  else
    survey_points(what, first, end, seed);
}
