// SPDX-License-Identifier: Apache-2.0
// The film parameter of load sharing at 1024 cases, 256 for those that take long.
#include <iterator>
#include <memory>

#include "cases/measured.hpp"
#include "cases/root_cases.hpp"

namespace tribo::benchmarks {
namespace {

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
                      (void)stored;  // keeps the cases
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

std::vector<Measured> jobs_of(const std::vector<RootContender>& contenders, RootJob job) {
  const auto stored = std::make_shared<const StoredRootCases>(random_root_cases(job, most));
  std::vector<Measured> all;
  for (const RootContender& contender : contenders) all.push_back(root_job(contender, job, stored));
  return all;
}

std::vector<Measured> root_jobs(Settings settings) {
  std::vector<Measured> all = jobs_of(wide_root_contenders(settings), RootJob::wide);
  std::vector<Measured> one = jobs_of(one_surface_root_contenders(settings), RootJob::one_surface);
  std::move(one.begin(), one.end(), std::back_inserter(all));
  return all;
}

}  // namespace tribo::benchmarks
