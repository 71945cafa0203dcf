// SPDX-License-Identifier: Apache-2.0
// The film parameter of load sharing at 1024 cases; slow contenders solve 256 of them.
#include <cmath>
#include <memory>
#include <random>

#include "accuracy/reference_table.hpp"
#include "cases/jobs.hpp"

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

constexpr std::size_t most = 1024;
constexpr std::size_t few = 256;

Measured root_job(const RootContender& contender, RootJob job,
                  const std::shared_ptr<const StoredRootCases>& stored) {
  const RootCases all = stored->view();
  const RootCases cases = stored->view(0, contender.is_slow ? few : most);
  const auto film = std::make_shared<std::vector<double>>(cases.size());
  const auto ready = std::make_shared<RootRun>();
  Measured measured{std::string(name(job)),
                    contender.family,
                    contender.name,
                    cases.size(),
                    [=] {
                      (void)stored;  // the copy keeps the cases alive
                      if (!*ready) *ready = contender.prepare(cases);
                      (*ready)(cases, *film);
                    },
                    [=] { return judge(contender, job); },
                    {},
                    contender.own_seconds};
  if (contender.evaluations)
    measured.evaluations = [=] {
      const RootCases& counted = contender.is_slow ? cases : all;
      return contender.evaluations(counted) / static_cast<double>(counted.size());
    };
  return measured;
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

Errors judge(const RootContender& contender, RootJob job) {
  static const StoredRootCases wide = certified(RootJob::wide);
  static const StoredRootCases one_surface = certified(RootJob::one_surface);
  const StoredRootCases& cases = job == RootJob::wide ? wide : one_surface;
  std::vector<double> film(cases.flooded.size());
  contender.prepare(cases.view())(cases.view(), film);
  ErrorTally tally;
  for (std::size_t i = 0; i < film.size(); ++i)
    tally.add(film[i], cases.high[i], cases.low[i], cases.condition[i]);
  return tally.errors();
}

std::vector<Measured> jobs_of(const std::vector<RootContender>& contenders, RootJob job) {
  const auto stored = std::make_shared<const StoredRootCases>(random_root_cases(job, most));
  std::vector<Measured> all;
  for (const RootContender& contender : contenders) all.push_back(root_job(contender, job, stored));
  return all;
}

}  // namespace tribo::benchmarks
