// SPDX-License-Identifier: Apache-2.0
// Newton's and Halley's methods of Boost on the load balance, with our moments: A = √(K F),
// A′ = A F′/2F, A″ = A (F″/2F − (F′/2F)²), F′ = −(5/2)F_{3/2}, F″ = (15/4)F_{1/2}.
#include <fmt/format.h>

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <tuple>

#include "contenders/root_equation.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::benchmarks {
namespace {

struct Derivatives {
  double residual, slope, curvature;
};

// Each call is one evaluation of F with its derivatives.
template <class Count>
Derivatives derivatives(const RootCase& c, double film, bool with_curvature) {
  Count::one();
  const double d = film - c.offset;
  const double moment = gaussian_moment(Order::five_halves, d);
  const double first = -2.5 * gaussian_moment(Order::three_halves, d);
  const double asperity = std::sqrt(c.stiffness * moment);
  const double fluid = std::pow(c.flooded / film, 1 / film_exponent);
  const double p = 1 / film_exponent;
  const double relative = moment > 0 ? first / (2 * moment) : 0;
  Derivatives at{asperity + fluid - 1, asperity * relative - p * fluid / film, 0};
  if (with_curvature) {
    const double second = 3.75 * gaussian_moment(Order::half, d);
    const double bend = moment > 0 ? second / (2 * moment) - relative * relative : 0;
    at.curvature = asperity * bend + p * (p + 1) * fluid / (film * film);
  }
  return at;
}

constexpr double highest = 200;

template <class Count>
struct Newton {
  int bits;
  double operator()(const RootCase& c) const {
    return value_or_nan([&] {
      std::uintmax_t iterations = 200;
      return boost::math::tools::newton_raphson_iterate(
          [&](double film) {
            const Derivatives at = derivatives<Count>(c, film, false);
            return std::pair(at.residual, at.slope);
          },
          c.flooded, c.flooded, highest, bits, iterations);
    });
  }
};

template <class Count>
struct Halley {
  int bits;
  double operator()(const RootCase& c) const {
    return value_or_nan([&] {
      std::uintmax_t iterations = 200;
      return boost::math::tools::halley_iterate(
          [&](double film) {
            const Derivatives at = derivatives<Count>(c, film, true);
            return std::tuple(at.residual, at.slope, at.curvature);
          },
          c.flooded, c.flooded, highest, bits, iterations);
    });
  }
};

}  // namespace

std::vector<RootContender> derivative_roots(Settings settings) {
  std::vector<RootContender> all;
  for (const int bits : chosen(settings, {49}, {6, 12, 24, 49}))
    all.push_back(one_by_one("Boost", fmt::format("Newton {} bits + our F", bits),
                             Newton<Uncounted>{bits}, Newton<Counted>{bits}));
  // Boost's iteration ends when a step is below 2^(1−bits) of the root. Halley's method is of third
  // order: the remaining error is of the order of that step's cube. Therefore 26 bits are enough.
  for (const int bits : chosen(settings, {26}, {4, 8, 16, 26}))
    all.push_back(one_by_one("Boost", fmt::format("Halley {} bits + our F", bits),
                             Halley<Uncounted>{bits}, Halley<Counted>{bits}));
  return all;
}

}  // namespace tribo::benchmarks
