// SPDX-License-Identifier: Apache-2.0
#include "work_precision/profile.hpp"

#include <cmath>
#include <limits>

#include "cases/root_cases.hpp"
#include "work_precision/timing.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double solved_within = 1e-10;  // relative
constexpr double infinity = std::numeric_limits<double>::infinity();

// times[solver][case], ∞ where it is not solved.
using Times = std::vector<std::vector<double>>;

Times times_by_case(const std::vector<RootContender>& solvers, const Effort& effort) {
  const StoredRootCases& cases = certified_root_cases(RootJob::wide);
  Times times(solvers.size(), std::vector<double>(cases.flooded.size(), infinity));
  for (std::size_t c = 0; c < cases.flooded.size(); ++c) {
    const RootCases one = cases.view(c, 1);
    std::vector<double> films(solvers.size());
    std::vector<Timed> timed;
    std::vector<std::size_t> solved;
    for (std::size_t s = 0; s < solvers.size(); ++s) {
      const RootRun run = solvers[s].prepare(one);
      double* const film = &films[s];
      run(one, {film, 1});
      if (!(std::abs(*film - cases.high[c]) <= solved_within * cases.high[c])) continue;
      solved.push_back(s);
      timed.push_back({[run, one, film] { run(one, {film, 1}); }, {}});
    }
    const std::vector<double> seconds =
        median_seconds(timed, effort.rounds, effort.least_seconds / 1000);
    for (std::size_t i = 0; i < solved.size(); ++i) times[solved[i]][c] = seconds[i];
  }
  return times;
}

}  // namespace

Rows performance_profile(const Effort& effort, const std::vector<RootContender>& others) {
  std::vector<RootContender> solvers = wide_root_contenders();
  std::erase_if(solvers, [](const RootContender& solver) {
    return solver.own_seconds || solver.name.starts_with("batch");
  });
  solvers.insert(solvers.end(), others.begin(), others.end());
  const Times times = times_by_case(solvers, effort);
  Rows rows;
  for (std::size_t s = 0; s < solvers.size(); ++s)
    for (int step = 0; step <= 40; ++step) {
      const double tau = std::pow(10, step / 10.0);
      rows.push_back({{"solver", solvers[s].family + ": " + solvers[s].name},
                      {"tau", four_digits(tau)},
                      {"fraction", four_digits(part_within(times, s, tau))}});
    }
  return rows;
}

}  // namespace tribo::benchmarks
