// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "contenders/ellipse_contender.hpp"
#include "tribo/hertz_ellipse.hpp"

namespace tribo::benchmarks {

std::vector<EllipseContender> ellipse_contenders(Settings settings) {
  std::vector<EllipseContender> all = ellipse_roots(settings);
  for (EllipseContender& fit : ellipse_fits()) all.push_back(std::move(fit));
  all.push_back({"tribocheck",
                 "scalar",
                 [](std::span<const EllipseCase> cases, std::span<EllipseAnswer> answers) {
                   for (std::size_t i = 0; i < cases.size(); ++i) {
                     const EllipseCase& c = cases[i];
                     const HertzEllipse<double> hertz =
                         hertz_ellipse(c.load, c.effective_modulus, c.radius_x, c.radius_y);
                     answers[i] = {hertz.semi_axis_x, hertz.peak_pressure};
                   }
                 },
                 {}});
  return all;
}

}  // namespace tribo::benchmarks
