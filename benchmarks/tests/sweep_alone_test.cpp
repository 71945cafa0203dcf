// SPDX-License-Identifier: Apache-2.0
// Sweeps are compared with the needed work alone (Alone). It is complete: as a whole and step by
// step it gives the sweep's own results.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sweep/alone.hpp"
#include "sweep/case_solver.hpp"
#include "sweep/cases.hpp"
#include "sweep/workloads.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::uint64_t> bits_of(std::span<const double> numbers) {
  std::vector<std::uint64_t> bits(numbers.size());
  std::transform(numbers.begin(), numbers.end(), bits.begin(),
                 [](double one) { return std::bit_cast<std::uint64_t>(one); });
  return bits;
}

// The cases fill two blocks, and part of a third one.
TEST(SweepAlone, HasTheBitsOfTheSweepItself) {
  for (const Workload& workload : workloads()) {
    const sweep::SweepPlan plan = plan_of(workload, 4096, "points");
    const sweep::SceneSweep& scene = plan.scenes.front();
    const std::size_t cases = 2 * Alone::block_cases + 7;
    std::vector<double> inputs(cases * scene.variables.size());
    sweep::CaseGenerator(scene).groups(0, inputs);
    std::vector<double> expected(cases * scene.width(), nan), results = expected;
    sweep::CaseSolver(scene).solve(inputs, expected);
    Alone(scene).solve(inputs, results);
    EXPECT_EQ(bits_of(results), bits_of(expected)) << workload.name;
  }
}

// The contacts of the last block are kept, so that a step can be repeated. If only the speed
// varies, cases have no contacts of their own, as in a sweep.
TEST(SweepAlone, StepsDoTheLastBlockAgain) {
  for (const Workload& workload : workloads()) {
    const sweep::SweepPlan plan = plan_of(workload, 4096, "points");
    const sweep::SceneSweep& scene = plan.scenes.front();
    std::vector<double> inputs(Alone::block_cases * scene.variables.size());
    sweep::CaseGenerator(scene).groups(0, inputs);
    std::vector<double> results(Alone::block_cases * scene.width(), nan), again = results;
    Alone alone(scene);
    alone.solve(inputs, results);
    const std::vector<double> untouched = again;
    scene.criteria.empty() ? alone.solve_points(again) : alone.find_onsets(again);
    EXPECT_EQ(bits_of(again), bits_of(workload.name == "film_of_speed" ? untouched : results))
        << workload.name;
  }
}

}  // namespace
}  // namespace tribo::benchmarks
