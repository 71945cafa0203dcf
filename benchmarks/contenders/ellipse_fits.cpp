// SPDX-License-Identifier: Apache-2.0
// Fits to the axes' ratio and to the second elliptic integral, as programs take them in place of
// the root.
#include <array>
#include <string_view>

#include "contenders/ellipse_contender.hpp"

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

}  // namespace

std::vector<EllipseContender> ellipse_fits() {
  std::vector<EllipseContender> all;
  for (const EllipseFit& fit : fits)
    all.push_back({"published fit", std::string(fit.name), by_shape(fit.shape), {}});
  return all;
}

}  // namespace tribo::benchmarks
