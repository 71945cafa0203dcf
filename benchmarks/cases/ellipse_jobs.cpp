// SPDX-License-Identifier: Apache-2.0
// Hertz' elliptical contact at 1024 ratios of its radii.
#include <memory>

#include "cases/ellipse_cases.hpp"
#include "cases/measured.hpp"

namespace tribo::benchmarks {

std::vector<Measured> jobs_of(const std::vector<EllipseContender>& contenders) {
  constexpr std::size_t count = 1024;
  const auto cases = std::make_shared<const std::vector<EllipseCase>>(random_ellipses(count));
  const auto answers = std::make_shared<std::vector<EllipseAnswer>>(count);
  std::vector<Measured> all;
  for (const EllipseContender& contender : contenders) {
    Measured measured{"hertz_ellipse",
                      contender.family,
                      contender.name,
                      count,
                      [=] { contender.run(*cases, *answers); },
                      [=] { return judge(contender); },
                      {},
                      {}};
    if (contender.counted)
      measured.evaluations = [=] {
        return evaluations_of([&] { contender.counted(*cases, *answers); }) /
               static_cast<double>(count);
      };
    all.push_back(std::move(measured));
  }
  return all;
}

std::vector<Measured> ellipse_jobs(Settings settings) {
  return jobs_of(ellipse_contenders(settings));
}

}  // namespace tribo::benchmarks
