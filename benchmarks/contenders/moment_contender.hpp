// SPDX-License-Identifier: Apache-2.0
// Methods that compute F_n(d), each as its users write it.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contenders/contender.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::benchmarks {

using MomentBatch = std::function<void(std::span<const double> d, std::span<double> moments)>;

// The range of d for which a contender claims to be valid. It is not judged outside.
struct Range {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  bool contains(double x) const { return from <= x && x <= to; }
};

struct MomentContender {
  std::string family;
  std::string name;
  Order order;
  MomentBatch run;
  MomentBatch counted{};  // counts integrand values in Counted; empty: there is no integrand
  Range claimed{};
  // CPU time of the last call, if another process did the work; empty: this process does it.
  std::function<double()> own_seconds{};
};

// Calls a function of one argument for each d in turn.
template <class Function>
MomentBatch point_by_point(Function function) {
  return [function](std::span<const double> d, std::span<double> moments) {
    for (std::size_t i = 0; i < d.size(); ++i) moments[i] = function(d[i]);
  };
}

template <class Function>
MomentContender closed_form(std::string family, std::string name, Order order, Function function,
                            Range claimed = {}) {
  return {
      std::move(family), std::move(name), order, point_by_point(std::move(function)), {}, claimed};
}

// Method<Count>(argument…) is a function of d that calls Count::one() for each value of its
// integrand.
template <template <class> class Method, class... Arguments>
MomentContender quadrature(std::string family, std::string name, Order order,
                           const Arguments&... arguments) {
  return {std::move(family), std::move(name), order,
          point_by_point(Method<Uncounted>{arguments...}),
          point_by_point(Method<Counted>{arguments...})};
}

// All contenders, family by family. Our own come last.
std::vector<MomentContender> moment_contenders(Settings settings = Settings::usual);

// The families.
std::vector<MomentContender> gsl_quadratures(Settings settings);
std::vector<MomentContender> gsl_special_functions();
std::vector<MomentContender> boost_quadratures(Settings settings);
std::vector<MomentContender> bessel_forms();
std::vector<MomentContender> gauss_laguerre_rules(Settings settings);
std::vector<MomentContender> splines(Settings settings);
std::vector<MomentContender> published_fits();
// SciPy's quad in a Python process of its own. That process measures its own time, so that its
// start is not counted.
std::vector<MomentContender> scipy_moments();

// F_{5/2}(d) = Γ(7/2)/√(2π) e^{−d²/4} U(3, d). Weber's functions U(0, d) and U(1, d) come from
// Bessel functions of d²/4 (DLMF 12.7.10 and following). Two steps of the recurrence give U(3, d).
double bessel_moment(double d);

// A fit from the literature, with the range of d that it claims. A fit that is a power of 4 − d is
// 0 beyond d = 4, as programs use it. The other fits are also evaluated outside their range.
struct PublishedFit {
  std::string_view name;
  Order order;
  Range claimed;
  double (*value)(double d);
};
const std::array<PublishedFit, 6>& all_published_fits();

}  // namespace tribo::benchmarks
