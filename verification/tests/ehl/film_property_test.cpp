// SPDX-License-Identifier: Apache-2.0
// Properties of every solved film: its flow is balanced, it carries the load, no pressure is below
// 0. Also its changes with the conditions, and the message where there is no film.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "ehl/film_conditions.hpp"
#include "ehl/film_kernel.hpp"
#include "ehl/films.hpp"
#include "ehl/reynolds.hpp"
#include "ehl/sampled_contact.hpp"
#include "ehl/text.hpp"
#include "support/judge.hpp"
#include "support/threshold.hpp"

namespace tribo::verification {
namespace {

using ehl::SolvedFilm;

const ehl::SolveOptions quick{.tolerance = 1e-2, .greatest_cells = 512};

testing::AssertionResult says(const SolvedFilm& film, ehl::Outcome outcome, std::string_view part) {
  if (film.outcome == outcome && film.reason.find(part) != std::string::npos)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "outcome " << static_cast<int>(film.outcome) << ": "
                                     << film.reason << "\nwanted: " << part;
}

TEST(SolvedFilm, BalancesTheFlowAndCarriesTheLoadWithoutTension) {
  for (const auto& [m, l] : {std::array<double, 2>{0.1, 0}, {1, 10}, {20, 5}, {200, 20}})
    for (const ehl::LineContact& contact : three_liquids(m, l)) {
      SCOPED_TRACE("M = " + std::to_string(m) + ", L = " + std::to_string(l));
      const ehl::LineFilm film = solved(contact, quick).film;
      const ehl::Balance balance =
          ehl::balance_of(contact, film.x, film.pressure, film.film, false);
      double load = 0;
      for (std::size_t i = 0; i + 1 < film.x.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        load += (film.pressure[row] + film.pressure[row + 1]) / 2 * (film.x[i + 1] - film.x[i]);
        EXPECT_GE(film.pressure[row], 0);
        EXPECT_GT(film.film[row], 0);
        if (i == 0) continue;
        if (film.pressure[row] > 0) {
          // The flow is the dragged flow less the flow by pressure: their rounding is allowed.
          const double dragged = film.film[row];
          EXPECT_TRUE(is_within(balance.flow[row], film.mass_flow, 1e-8 * (1 + dragged)))
              << "X = " << film.x[i];
        } else {
          EXPECT_GE(balance.surplus[row], -1e-9) << "X = " << film.x[i];
        }
      }
      EXPECT_TRUE(is_within(load, std::numbers::pi / 2, 1e-9));
      // The pressure is 0 at the ends, but for the rounding of linear equations.
      EXPECT_LT(film.pressure[0], 1e-30);
      EXPECT_LT(film.pressure[film.pressure.size() - 1], 1e-30);
      // The film follows from the pressure.
      const Eigen::VectorXd elastic = ehl::FilmKernel(film.x) * film.pressure;
      for (std::size_t i = 0; i < film.x.size(); i += 17) {
        const auto row = static_cast<Eigen::Index>(i);
        const double parabola = film.x[i] * film.x[i] / 2;
        EXPECT_TRUE(is_within(film.film[row], film.separation + parabola + elastic[row],
                              1e-13 * (1 + parabola)));
      }
    }
}

TEST(SolvedFilm, FallsWithTheLoadAndRisesWithTheViscosityUnderPressure) {
  const auto numbers = [](double m, double l) {
    const ehl::LineContact contact = ehl::barus_contact(m, l);
    const SolvedFilm film = solved(contact, quick);
    return std::array<double, 2>{contact.film_number(film.minimum.value),
                                 contact.film_number(film.at_greatest_pressure.value)};
  };
  for (const double fixed : {0.5, 5.0, 15.0}) {
    std::array<double, 2> before{1e300, 1e300};
    for (const double m : {0.5, 1.0, 2.0, 5.0, 20.0, 100.0}) {
      if (m < 5 && fixed == 15) continue;  // there the least film rises with the load
      const std::array<double, 2> now = numbers(m, fixed);
      EXPECT_LT(now[0], before[0]) << "M = " << m << ", L = " << fixed;
      EXPECT_LT(now[1], before[1]) << "M = " << m << ", L = " << fixed;
      before = now;
    }
    before = {0, 0};
    for (const double l : {0.0, 1.0, 3.0, 8.0, 20.0}) {
      const std::array<double, 2> now = numbers(2 * fixed, l);
      EXPECT_GT(now[0], before[0]) << "M = " << 2 * fixed << ", L = " << l;
      EXPECT_GT(now[1], before[1]) << "M = " << 2 * fixed << ", L = " << l;
      before = now;
    }
  }
}

TEST(LineConditions, OtherUnitsLeaveTheContactAlone) {
  Sampler sampler(31);
  for (int i = 0; i < 100; ++i) {
    const ehl::FilmConditions si = random_conditions(sampler);
    const double metre = sampler.log_uniform(1e-3, 1e3), kilogram = sampler.log_uniform(1e-3, 1e3);
    const double second = sampler.log_uniform(1e-3, 1e3);
    const double pascal = kilogram / (metre * second * second);
    ehl::FilmConditions other = si;
    other.speed *= metre / second;
    other.viscosity *= pascal * second;
    other.pressure_viscosity /= pascal;
    other.load *= pascal * metre;
    other.effective_modulus *= pascal;
    other.radius *= metre;
    const ehl::LineContact one = ehl::contact_of(si), two = ehl::contact_of(other);
    EXPECT_TRUE(is_within(two.load_number / one.load_number, 1, 1e-14));
    EXPECT_TRUE(is_within(two.material_number / one.material_number, 1, 1e-14));
    EXPECT_TRUE(is_within(two.fluid.exponent / one.fluid.exponent, 1, 1e-14));
    EXPECT_TRUE(
        is_within(one.fluid.exponent / ehl::pressure_exponent(one.load_number, one.material_number),
                  1, 1e-13));
    EXPECT_TRUE(
        is_within(ehl::scale_of(other).film / ehl::scale_of(si).film, metre, 1e-13 * metre));
  }
}

TEST(SolvedFilm, OfRoelandsTendsToThatOfBarus) {
  const ehl::LineContact barus = ehl::barus_contact(10, 5);
  const double limit = solved(barus, quick).central.value;
  double before = 1;
  for (const double pressure : {1.0, 0.1, 0.01, 0.001}) {
    ehl::LineContact roelands = barus;
    roelands.fluid.roelands_pressure = pressure;
    roelands.fluid.roelands_index = 0.6;
    const double off = 1 - solved(roelands, quick).central.value / limit;
    EXPECT_GT(off, 0);  // its viscosity rises less
    EXPECT_LT(off, before);
    EXPECT_LT(off, 0.1 * pressure);
    before = off;
  }
}

TEST(SolvedFilm, OfACompressibleLiquidIsThinnerByItsDensity) {
  for (const auto& [m, l] : {std::array<double, 2>{20, 5}, {100, 10}}) {
    const ehl::LineContact firm = ehl::barus_contact(m, l);
    ehl::LineContact soft = firm;
    soft.fluid.density_pressure = 1.5;
    const SolvedFilm one = solved(firm, quick), two = solved(soft, quick);
    const double ratio = two.at_greatest_pressure.value / one.at_greatest_pressure.value;
    // The inlet, which makes the film, is compressed by pressures of about 1/α.
    const double at_inlet = soft.fluid.density(1 / soft.fluid.exponent);
    EXPECT_TRUE(is_within(ratio, at_inlet / soft.fluid.density(1), 0.01))
        << "M = " << m << ", L = " << l;
  }
}

TEST(SolveLineFilm, SaysWhereItWasStopped) {
  int steps = 0;
  const SolvedFilm film = ehl::solve_line_film(ehl::barus_contact(10, 5), {},
                                               [&](const ehl::Step&) { return ++steps < 3; });
  EXPECT_TRUE(says(film, ehl::Outcome::stopped, "stopped on the grid of 64 cells"));
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(std::isnan(film.central.value), true);
}

TEST(SolveLineFilm, TellsEachStepToWhoWatches) {
  int steps = 0, finest = 0;
  const SolvedFilm film =
      ehl::solve_line_film(ehl::barus_contact(2, 1), quick, [&](const ehl::Step& step) {
        ++steps;
        finest = std::max(finest, step.cells);
        return true;
      });
  EXPECT_EQ(film.outcome, ehl::Outcome::solved);
  EXPECT_EQ(finest, static_cast<int>(film.film.x.size()) - 1);
  EXPECT_GE(steps, film.steps);
}

// How often the equations were factored on each grid. The two coarsest grids are left out.
std::map<int, int> steps_by_cells(const ehl::LineContact& contact,
                                  const ehl::SolveOptions& options) {
  std::map<int, int> steps;
  ehl::solve_line_film(contact, options, [&](const ehl::Step& step) {
    if (step.cells > 128) ++steps[step.cells];
    return true;
  });
  return steps;
}

TEST(SolveLineFilm, FactorsItsEquationsOnceOnAGridWhereTheFilmHasNoSpike) {
  for (const auto& [m, l] : {std::array<double, 2>{1, 0}, {10, 5}}) {
    const std::map<int, int> by_cells = steps_by_cells(ehl::barus_contact(m, l), {});
    EXPECT_FALSE(by_cells.empty());
    for (const auto& [cells, steps] : by_cells)
      EXPECT_EQ(steps, 1) << "M = " << m << ", L = " << l << ", " << cells << " cells";
  }
}

TEST(SolveLineFilm, SolvesTheGridBesideTheFinestAloneWhereTheErrorsOfOthersAreTooGreatWithoutIt) {
  const std::map<int, int> steps = steps_by_cells(ehl::barus_contact(10, 5), {});
  ASSERT_FALSE(steps.empty());
  const int finest = steps.rbegin()->first;
  ASSERT_GE(finest, 512);
  EXPECT_EQ(steps.contains(finest - finest / 8), true);
  for (int cells = finest / 2; cells > 128; cells /= 2) {
    EXPECT_EQ(steps.contains(cells), true);
    EXPECT_EQ(steps.contains(cells - cells / 8), false) << cells;
  }
}

// If the solver is stopped on a grid, it gives the films of the coarser grids. The grid beside the
// finest of them was not solved.
TEST(SolveLineFilm, HasErrorsThatHoldWhereItWasStoppedOnAFineGrid) {
  const ehl::LineContact contact = ehl::barus_contact(10, 5);
  const double exact = solved(contact, {.tolerance = 1e-5}).central.value;
  for (const int cells : {512, 1024}) {
    bool goes_on = true;
    const SolvedFilm film = ehl::solve_line_film(
        contact, {.tolerance = 1e-6},
        [&](const ehl::Step& step) { return goes_on = goes_on && step.cells < cells; });
    EXPECT_TRUE(says(film, ehl::Outcome::solved, "stopped on the grid of"));
    EXPECT_EQ(static_cast<int>(film.film.x.size()) - 1, cells / 2);
    EXPECT_TRUE(is_within(film.central.value, exact, film.central.error));
    EXPECT_LT(film.central.relative_error(), 0.1);
  }
}

TEST(SolveFrom, SaysThatTheStepsWereTooFew) {
  const ehl::LineContact contact = ehl::barus_contact(10, 5);
  const ehl::LineFilm start = solved(ehl::barus_contact(10, 4), quick).film;
  const ehl::LineFilm film = ehl::solve_from(contact, start.x, start.pressure, start.separation,
                                             {.steps = 2, .change = 1e-10}, {});
  EXPECT_EQ(film.outcome, ehl::Outcome::not_converged);
  EXPECT_EQ(film.steps, 2);
  EXPECT_GT(film.last_change, 1e-10);
}

TEST(SolveLineFilm, SaysWhereItWasNotTriedBeyondEachLimit) {
  const auto is_told = [](double load_number, double material_number) {
    const SolvedFilm film = ehl::solve_line_film(ehl::barus_contact(load_number, material_number),
                                                 {.greatest_cells = 64});
    EXPECT_EQ(film.outcome, ehl::Outcome::not_converged);
    return film.reason.find("; the solver was tried up to M = 10000 and L = 50") !=
           std::string::npos;
  };
  EXPECT_TRUE(changes_at_its_limit(
      {"M", 1e4, True::above, [&](double load_number) { return is_told(load_number, 5); }}));
  EXPECT_TRUE(changes_at_its_limit({"L", 50, True::above, [&](double material_number) {
                                      return is_told(10, material_number);
                                    }}));
}

TEST(SolveLineFilm, RefusesAFilmBelowItsResolution) {
  const SolvedFilm film = ehl::solve_line_film(ehl::barus_contact(1e8, 0));
  EXPECT_TRUE(says(film, ehl::Outcome::not_converged,
                   "grids of double numbers resolve films down to 1e-08"));
  EXPECT_EQ(film.grids, 0);
}

TEST(SolveLineFilm, SaysThatTheToleranceWasNotMet) {
  const SolvedFilm film =
      ehl::solve_line_film(ehl::barus_contact(10, 5), {.tolerance = 1e-9, .greatest_cells = 1024});
  EXPECT_TRUE(says(film, ehl::Outcome::solved, "the tolerance of 1e-09 was not met"));
  EXPECT_EQ(film.grids, 5);
  EXPECT_GT(film.central.relative_error(), 1e-9);
}

// The work is the number of cells, added up over Newton's steps. A grid beside the finest, of seven
// eighths of its cells, may be solved in vain for one tolerance and left out for a tighter one.
TEST(SolveLineFilm, SolvesToEachLooserToleranceInNoMoreWork) {
  std::vector<ehl::LineContact> contacts;
  ContactSampler sampler(32);
  for (int i = 0; i < 8; ++i) contacts.push_back(sampler.next().contact);
  // Steel at 3 and 2 GPa, which an earlier version solved to 3e-5 but not to 1e-2, and steel at
  // 3 GPa, which it did not solve to 1e-5.
  for (const auto& [m, l, index] :
       {std::array<double, 3>{300, 25, 0.68}, {300, 25, 1}, {500, 20, 0.6}}) {
    ehl::LineContact heavy = ehl::barus_contact(m, l);
    heavy.fluid.roelands_pressure = 15;
    heavy.fluid.roelands_index = index;
    heavy.fluid.density_pressure = 5;
    contacts.push_back(heavy);
  }
  constexpr std::array<double, 4> tolerances{1e-5, 1e-4, 1e-3, 1e-2};
  std::array<double, 4> all_work{};
  for (const ehl::LineContact& contact : contacts) {
    double work_before = std::numeric_limits<double>::infinity(), all_before = work_before;
    bool was_met = false;
    for (std::size_t i = 0; i < all_work.size(); ++i) {
      double work = 0, all = 0;
      const SolvedFilm film =
          ehl::solve_line_film(contact, {.tolerance = tolerances[i], .greatest_cells = 2048},
                               [&](const ehl::Step& step) {
                                 all += step.cells;
                                 work += step.cells % 7 == 0 ? 0 : step.cells;
                                 return true;
                               });
      EXPECT_EQ(film.outcome, ehl::Outcome::solved) << film.reason;
      EXPECT_LE(work, work_before);
      EXPECT_LE(all, 1.25 * all_before);
      EXPECT_GE(film.reason.empty(), was_met) << film.reason;
      work_before = work;
      all_before = all;
      was_met = film.reason.empty();
      all_work[i] += all;
    }
  }
  EXPECT_LT(all_work[3], all_work[2] / 2);  // 1e-2 is not computed as 1e-3 is
}

// This contact's spike is 5 times as high as Hertz' peak on 256 cells, and 24 times on 4096. On
// the coarsest grids the solver follows the film in time, which takes more steps.
TEST(SolveLineFilm, TakesFewStepsOnEachGridThoughASpikeGrows) {
  std::map<int, int> steps;  // on each grid
  const SolvedFilm film = ehl::solve_line_film(
      ehl::barus_contact(2.2, 15.8), {.tolerance = 1e-8, .greatest_cells = 4096, .at_edge = 0.3},
      [&](const ehl::Step& step) { return ++steps[step.cells] > 0; });
  EXPECT_EQ(film.outcome, ehl::Outcome::solved) << film.reason;
  EXPECT_GT(film.film.pressure.maxCoeff(), 20);
  EXPECT_GE(steps.size(), 8U);
  for (const auto& [cells, count] : steps)
    if (cells > 128) {
      EXPECT_LE(count, 18) << cells << " cells";
    }
}

TEST(SolveLineFilm, SaysOfTheContactItselfWhyThereIsNoFilm) {
  ehl::LineContact contact = ehl::barus_contact(10, 25);
  contact.fluid.exponent = 1e7;
  const SolvedFilm film = ehl::solve_line_film(contact, {.greatest_cells = 128});
  EXPECT_EQ(film.outcome, ehl::Outcome::not_converged);
  EXPECT_TRUE(
      film.reason.starts_with("no film was found at M = 10 and L = 25, αp₀ = 1e+07, from "
                              "coarsest grids of 64 cells; on the grid of "))
      << film.reason;
  EXPECT_EQ(ehl::text("%s", std::string(400, 'x').c_str()), std::string(400, 'x'));  // is not cut
  // Too few grids are told with their reason, too.
  EXPECT_TRUE(says(ehl::solve_line_film(ehl::barus_contact(10, 5), {.greatest_cells = 128}),
                   ehl::Outcome::not_converged,
                   "an error needs three grids, and 128 cells at most leave"));
}

}  // namespace
}  // namespace tribo::verification
