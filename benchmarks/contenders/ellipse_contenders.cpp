// SPDX-License-Identifier: Apache-2.0
// All methods for a Hertz ellipse. Some are fits to the axes' ratio and to the elliptic integral of
// the second kind, which programs use in place of the root.
#include <array>
#include <string_view>

#include "contenders/ellipse_contender.hpp"
#include "tribo/hertz_ellipse.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double pi = std::numbers::pi;

struct EllipseFit {
  std::string_view name;
  AxesRatio (*shape)(double alpha);
};
constexpr std::array fits{
    EllipseFit{"1.0339 a^0.636",
               [](double alpha) {
                 return AxesRatio{1.0339 * std::pow(alpha, 0.636), 1.0003 + 0.5968 / alpha};
               }},
    EllipseFit{"a^(2/pi)",
               [](double alpha) {
                 return AxesRatio{std::pow(alpha, 2 / pi), 1 + (pi / 2 - 1) / alpha};
               }},
    EllipseFit{"1.03 a^0.64",
               [](double alpha) {
                 return AxesRatio{1.03 * std::pow(alpha, 0.64), 1 + (pi / 2 - 1) / alpha};
               }},
    EllipseFit{
        "logarithms",
        [](double alpha) {
          const double log_alpha = std::log(alpha);
          const double k = 1 + std::sqrt((std::log(16) + log_alpha) * alpha / 2) -
                           std::sqrt(std::log(4)) - 0.16 * log_alpha;
          return AxesRatio{k, pi / (2 * k * k) * (1 + 2 / pi * (k * k - 1) + 0.25 * std::log(k))};
        }},
};

std::vector<EllipseContender> ellipse_fits() {
  std::vector<EllipseContender> all;
  for (const EllipseFit& fit : fits)
    all.push_back({"published fit", std::string(fit.name), by_shape(fit.shape)});
  return all;
}

}  // namespace

std::vector<EllipseContender> ellipse_contenders(Settings settings) {
  std::vector<EllipseContender> all = ellipse_roots(settings);
  for (EllipseContender& fit : ellipse_fits()) all.push_back(std::move(fit));
  all.push_back({"tribocheck", "prepared as scenes are",
                 [](std::span<const EllipseCase> cases, std::span<EllipseAnswer> answers) {
                   for (std::size_t i = 0; i < cases.size(); ++i) {
                     const EllipseCase& c = cases[i];
                     const auto hertz = hertz_ellipse(c.load, c.effective_modulus, c.radius_x,
                                                      ellipse_of_circle(c.radius_x, c.radius_y));
                     answers[i] = {hertz.semi_axis_x, hertz.peak_pressure};
                   }
                 }});
  all.push_back({"tribocheck", "scalar",
                 [](std::span<const EllipseCase> cases, std::span<EllipseAnswer> answers) {
                   for (std::size_t i = 0; i < cases.size(); ++i) {
                     const EllipseCase& c = cases[i];
                     const HertzEllipse<double> hertz =
                         hertz_ellipse(c.load, c.effective_modulus, c.radius_x, c.radius_y);
                     answers[i] = {hertz.semi_axis_x, hertz.peak_pressure};
                   }
                 }});
  return all;
}

}  // namespace tribo::benchmarks
