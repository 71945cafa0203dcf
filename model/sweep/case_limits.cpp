// SPDX-License-Identifier: Apache-2.0
#include "sweep/case_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sweep/cases.hpp"

namespace tribo::sweep {
namespace {

constexpr std::uint64_t most_judged_cells = 16;  // sets of grid values

SceneUse use_of(const SceneSweep& sweep) {
  if (!sweep.outputs.empty()) return SceneUse::speeds;
  return sweep.criteria.empty() ? SceneUse::line_film : SceneUse::onset;
}

// How far a value is beyond its limit: |ln(value/limit)|.
double excess(const Validity& limit) { return std::abs(std::log(limit.value / limit.limit())); }

void count(std::vector<Validity>& counted, const std::vector<Validity>& passed,
           std::uint64_t number) {
  for (const Validity& limit : passed) {
    // Both ends of a range of speeds may pass one limit.
    if (&limit != &*std::ranges::find(passed, limit.word, &Validity::word)) continue;
    auto known = std::ranges::find(counted, limit.word, &Validity::word);
    const std::uint64_t cases = known == counted.end() ? 1 : known->cases + 1;
    if (known == counted.end()) known = counted.insert(known, Validity{});
    if (cases == 1 || excess(limit) > excess(*known)) {
      *known = limit;
      known->furthest_case = number;
    }
    known->cases = cases;
  }
}

}  // namespace

std::vector<Validity> limits_of_cases(const SweepReading& reading) {
  std::vector<Validity> limits = reading.passed;
  if (!reading.sweep || reading.sweep->drawn() == 0) return limits;
  const SceneSweep& sweep = *reading.sweep;
  const std::uint64_t cells = std::min(sweep.grid_cells, most_judged_cells);
  const std::uint64_t draws = std::min(sweep.draws, most_judged_cases / cells);
  CaseGenerator generator(sweep);
  Scene scene = sweep.scene;
  const std::size_t variables = sweep.variables.size();
  const std::size_t group_size = sweep.cases_per_group() * variables;
  std::vector<double> values(draws * group_size);
  std::vector<Validity> counted;
  for (std::uint64_t cell = 0; cell < cells; ++cell) {
    const std::uint64_t place = cells == 1 ? 0 : cell * (sweep.grid_cells - 1) / (cells - 1);
    generator.groups(place * sweep.draws, values);
    for (std::size_t i = 0; i < draws; ++i) {
      for (std::size_t v = 0; v < variables; ++v)
        sweep.variables[v].store(scene, values[i * group_size + v]);
      count(counted, passed_limits(scene, use_of(sweep)),
            (place * sweep.draws + i) * sweep.cases_kept_per_group());
    }
  }
  const std::uint64_t judged = cells * draws;
  for (Validity& one : counted) {
    one.judged_cases = judged;
    one.all_cases = sweep.cases();
    const bool is_told =
        static_cast<double>(one.cases) >= least_told_part * static_cast<double>(judged);
    const auto known = std::ranges::find(limits, one.word, &Validity::word);
    if (known != limits.end())
      *known = one;
    else if (is_told)
      limits.push_back(one);
  }
  return limits;
}

}  // namespace tribo::sweep
