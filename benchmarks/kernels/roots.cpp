// SPDX-License-Identifier: Apache-2.0
// The film parameter of load sharing at 1024 cases, 256 for those that take long.
#include <memory>

#include "cases/root_cases.hpp"
#include "kernels/measured.hpp"

namespace tribo::benchmarks {
namespace {

constexpr std::size_t most = 1024;
constexpr std::size_t few = 256;

void register_root(const RootContender& contender, RootJob job,
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
  register_benchmark(std::move(measured));
}

}  // namespace

void register_roots() {
  describe_job("root_wide", "Film parameter: K 1e-6..10, delta 0..3, lambda0 1e-4..100");
  describe_job("root_one_surface", "Film parameter: K = 0.3, delta = 1.146, lambda0 1e-4..100");
  for (const RootJob job : {RootJob::wide, RootJob::one_surface}) {
    const auto stored = std::make_shared<const StoredRootCases>(random_root_cases(job, most));
    for (const RootContender& contender :
         job == RootJob::wide ? wide_root_contenders() : one_surface_root_contenders())
      register_root(contender, job, stored);
  }
}

}  // namespace tribo::benchmarks
