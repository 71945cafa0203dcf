// SPDX-License-Identifier: Apache-2.0
// All contenders that compute F_n, this project's own among them. The control is std::exp on the
// same arguments.
#include <cmath>

#include "contenders/moment_contender.hpp"
#include "tribo/batch.hpp"

namespace tribo::benchmarks {
namespace {

void batch(Order order, std::string_view set, std::span<const double> d,
           std::span<double> moments) {
  const std::string_view usual = instruction_set();
  use_instruction_set(set);
  gaussian_moment(order, d, moments);
  use_instruction_set(usual);
}

std::vector<MomentContender> own_moments() {
  std::vector<MomentContender> all;
  for (const Order order : {Order::five_halves, Order::two}) {
    all.push_back(closed_form("tribocheck", "scalar", order,
                              [order](double d) { return gaussian_moment(order, d); }));
    for (const std::string_view set : instruction_sets())
      all.push_back({"tribocheck", "batch " + std::string(set), order,
                     [order, set](std::span<const double> d, std::span<double> moments) {
                       batch(order, set, d, moments);
                     }});
  }
  all.push_back(
      closed_form("tribocheck", "template in long double", Order::five_halves, [](double d) {
        return static_cast<double>(
            gaussian_moment(Order::five_halves, static_cast<long double>(d)));
      }));
  constexpr Range nowhere{1, 0};  // so that no answer of the control is judged
  all.push_back(closed_form(
      "control", "std::exp", Order::five_halves, [](double d) { return std::exp(d); }, nowhere));
  return all;
}

}  // namespace

std::vector<MomentContender> moment_contenders(Settings settings) {
  return joined<MomentContender>({gsl_quadratures(settings), gsl_special_functions(),
                                  boost_quadratures(settings), bessel_forms(),
                                  gauss_laguerre_rules(settings), splines(settings),
                                  published_fits(), scipy_moments(), own_moments()});
}

}  // namespace tribo::benchmarks
