// SPDX-License-Identifier: Apache-2.0
// Random line contacts (sampled_contact.hpp) solved to four tolerances, and compared with their
// films to a tolerance of 1e-6: rows for verification/gates/film_survey.py, which judges them. Work
// is Newton's steps times cells.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "ehl/sampled_contact.hpp"
#include "ehl/solved_film.hpp"

namespace {

using namespace tribo;

constexpr std::array<double, 4> tolerances{1e-5, 1e-4, 1e-3, 1e-2};
constexpr std::array<ehl::Estimate ehl::SolvedFilm::*, 3> films{
    &ehl::SolvedFilm::central, &ehl::SolvedFilm::minimum, &ehl::SolvedFilm::at_greatest_pressure};

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

}  // namespace

// film_survey FIRST END SEED
int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("film_survey FIRST END SEED: the contacts FIRST to END - 1 of this seed\n", stderr);
    return 2;
  }
  const int first = std::atoi(argv[1]), end = std::atoi(argv[2]);
  verification::ContactSampler sampler(std::strtoull(argv[3], nullptr, 10));
  fmt::print(
      "contact,load_number,material_number,is_roelands,is_compressible,tolerance,solved,met,work");
  for (const char* film : {"central", "minimum", "at_greatest_pressure"})
    fmt::print(",{0},{0}_error,{0}_off,{0}_known", film);
  fmt::print("\n");
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
      for (const auto film_of : films) {
        const ehl::Estimate &one = film.*film_of, &truth = exact.*film_of;
        fmt::print(",{:.12g},{:.4g},{:.4g},{:.4g}", one.value, one.error,
                   std::fabs(one.value - truth.value), truth.error);
      }
      fmt::print("\n");
    }
  }
}
