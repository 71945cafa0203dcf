// SPDX-License-Identifier: Apache-2.0
#include "cases/root_cases.hpp"

#include <cmath>
#include <random>

#include "accuracy/reference_table.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double one_stiffness = 0.3;
constexpr double one_offset = 1.146;

bool belongs_to(RootJob job, double k, double delta, double lambda0) {
  if (lambda0 < 1e-4 || lambda0 > 100) return false;
  if (job == RootJob::one_surface) return k == one_stiffness && delta == one_offset;
  return 1e-6 <= k && k <= 10 && delta <= 3;
}

StoredRootCases certified(RootJob job) {
  StoredRootCases cases;
  for (const auto& row :
       verification::read_reference_table(TRIBOCHECK_REFERENCE "/exact/load_sharing.csv")) {
    const double k = row.number("stiffness");
    const double delta = row.number("offset");
    const double lambda0 = row.number("flooded_film_parameter");
    if (row.text("asperity") != "greenwood_tripp" || !belongs_to(job, k, delta, lambda0)) continue;
    cases.add(k, delta, lambda0);
    cases.high.push_back(row.number("high"));
    cases.low.push_back(row.number("low"));
    cases.condition.push_back(row.number("condition"));
  }
  return cases;
}

}  // namespace

void StoredRootCases::add(double k, double delta, double lambda0) {
  stiffness.push_back(k);
  offset.push_back(delta);
  flooded.push_back(lambda0);
}

RootCases StoredRootCases::view(std::size_t first, std::size_t count) const {
  const auto part = [&](const std::vector<double>& all) {
    return std::span(all).subspan(first, count);
  };
  return {part(stiffness), part(offset), part(flooded)};
}

StoredRootCases random_root_cases(RootJob job, std::size_t count) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> unit(0, 1);
  StoredRootCases cases;
  for (std::size_t i = 0; i < count; ++i) {
    const double k = 1e-6 * std::pow(1e7, unit(generator));
    const double delta = 3 * unit(generator);
    const double lambda0 = 1e-4 * std::pow(1e6, unit(generator));
    cases.add(job == RootJob::wide ? k : one_stiffness, job == RootJob::wide ? delta : one_offset,
              lambda0);
  }
  return cases;
}

const StoredRootCases& certified_root_cases(RootJob job) {
  static const StoredRootCases wide = certified(RootJob::wide);
  static const StoredRootCases one_surface = certified(RootJob::one_surface);
  return job == RootJob::wide ? wide : one_surface;
}

Errors judge(const RootContender& contender, RootJob job) {
  const StoredRootCases& cases = certified_root_cases(job);
  std::vector<double> film(cases.flooded.size());
  contender.prepare(cases.view())(cases.view(), film);
  ErrorTally tally;
  for (std::size_t i = 0; i < film.size(); ++i)
    tally.add(film[i], cases.high[i], cases.low[i], cases.condition[i]);
  return tally.errors();
}

}  // namespace tribo::benchmarks
