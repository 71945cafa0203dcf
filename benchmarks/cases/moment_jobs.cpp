// SPDX-License-Identifier: Apache-2.0
// F_{5/2} and F_2 at 2048 arguments in (0, 6).
#include <memory>

#include "cases/measured.hpp"
#include "cases/moment_cases.hpp"

namespace tribo::benchmarks {
namespace {

constexpr std::size_t count = 2048;

double evaluations_a_point(const MomentContender& contender, const std::vector<double>& d) {
  std::vector<double> moments(d.size());
  return evaluations_of([&] { contender.counted(d, moments); }) / static_cast<double>(d.size());
}

}  // namespace

std::vector<Measured> jobs_of(const std::vector<MomentContender>& contenders) {
  std::vector<Measured> all;
  const auto d = std::make_shared<const std::vector<double>>(moment_arguments(count));
  const auto moments = std::make_shared<std::vector<double>>(count);
  for (const MomentContender& contender : contenders) {
    Measured measured{contender.order == Order::two ? "moment_2" : "moment_5_2",
                      contender.family,
                      contender.name,
                      count,
                      [=] { contender.run(*d, *moments); },
                      [=] { return judge(contender); },
                      {},
                      contender.own_seconds};
    if (contender.counted)
      measured.evaluations = [=] { return evaluations_a_point(contender, *d); };
    all.push_back(std::move(measured));
  }
  return all;
}

std::vector<Measured> moment_jobs(Settings settings) {
  return jobs_of(moment_contenders(settings));
}

}  // namespace tribo::benchmarks
