// SPDX-License-Identifier: Apache-2.0
// Random line contacts (sampled_contact.hpp) solved to four tolerances, and held to their films on
// finer grids: is a contact that is solved to one tolerance solved to each looser one, in no more
// work, and does its film lie within the stated error? Writes a row a contact and tolerance, and at
// the end a line of JSON. The contacts may be done in parts; work is Newton's steps times cells.
// The shares of the errors (ehl::Caution) were chosen on contacts of seed 2026, and no share on
// those of `judging_seed`.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "ehl/sampled_contact.hpp"
#include "ehl/solved_film.hpp"

namespace {

using namespace tribo;

constexpr std::uint64_t judging_seed = 43;
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

struct Totals {
  int refused = 0, not_met = 0, violations = 0, outside = 0;
  double work = 0;
  std::vector<double> cautions;  // error stated over error
};

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace

// film_survey [FIRST [END [SEED]]]: of the contacts 0 to 299.
int main(int argc, char** argv) {
  const int first = argc > 1 ? std::atoi(argv[1]) : 0, end = argc > 2 ? std::atoi(argv[2]) : 300;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : judging_seed;
  verification::ContactSampler sampler(seed);
  std::array<Totals, tolerances.size()> totals;
  for (int i = 0; i < end; ++i) {
    const verification::SampledContact drawn = sampler.next();
    if (i < first) continue;
    const ehl::SolvedFilm exact = solve(drawn.contact, 1e-6, 16384).film;
    bool was_solved = false, was_met = false;
    double work_before = INFINITY;
    for (std::size_t t = 0; t < tolerances.size(); ++t) {
      const auto [film, work] = solve(drawn.contact, tolerances[t], 8192);
      Totals& total = totals[t];
      const bool is_solved = film.outcome == ehl::Outcome::solved;
      const bool is_met = is_solved && film.reason.empty();
      total.refused += is_solved ? 0 : 1;
      total.not_met += is_met ? 0 : 1;
      total.violations +=
          (was_solved && !is_solved) || (was_met && !is_met) || work > work_before ? 1 : 0;
      total.work += work;
      was_solved = is_solved;
      was_met = is_met;
      work_before = work;
      std::string row =
          fmt::format("{},{:.6g},{:.6g},{:d},{:d},{:g},{:d},{}", i, drawn.contact.load_number,
                      drawn.contact.material_number, drawn.is_roelands, drawn.is_compressible,
                      tolerances[t], is_met, work);
      for (const auto film_of : films) {
        const ehl::Estimate &one = film.*film_of, &truth = exact.*film_of;
        const double off = std::fabs(one.value - truth.value);
        row += fmt::format(",{:.10g},{:.2g},{:.2g}", one.value, one.error, off);
        // Only a film that is known three times as well can judge.
        if (!(truth.error < one.error / 3)) continue;
        total.outside += off > one.error ? 1 : 0;
        if (off > 0) total.cautions.push_back(one.error / off);
      }
      fmt::print("{},{}\n", row, film.reason);
      std::fflush(stdout);
    }
  }
  std::string rows;
  for (std::size_t t = 0; t < tolerances.size(); ++t)
    rows += fmt::format(
        "{}{{\"tolerance\":{:g},\"refused\":{},\"not_met\":{},\"violations\":{},\"judged\":{},"
        "\"outside\":{},\"median_stated_over_true\":{:.3g},\"mean_work\":{:.0f}}}",
        t == 0 ? "" : ",", tolerances[t], totals[t].refused, totals[t].not_met,
        totals[t].violations, totals[t].cautions.size(), totals[t].outside,
        median(totals[t].cautions), totals[t].work / (end - first));
  fmt::print("{{\"seed\":{},\"first\":{},\"end\":{},\"tolerances\":[{}]}}\n", seed, first, end,
             rows);
  int bad = 0;
  for (const Totals& total : totals)
    bad += total.violations + total.outside + (100 * total.refused > end - first ? 1 : 0);
  return bad == 0 ? 0 : 1;
}
