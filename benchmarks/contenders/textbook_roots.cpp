// SPDX-License-Identifier: Apache-2.0
// Two methods of textbooks: the fixed point of λ = λ₀(1−A)^−0.14, and Newton's method for the root
// of λ − λ₀(1−A)^−0.14. Neither method has a safeguard.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/moment_contender.hpp"
#include "contenders/root_equation.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::benchmarks {
namespace {

constexpr int most_iterations = 200;

struct FixedPoint {
  double tolerance;
  template <class Balance>
  double operator()(const RootCase& c, const Balance& balance) const {
    double film = c.flooded;
    for (int i = 0; i < most_iterations; ++i) {
      const double next = c.flooded * std::pow(1 - balance.asperity_share(film), -film_exponent);
      if (!(std::abs(next - film) > tolerance * next)) return next;  // true for NaN, too
      film = next;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
};

template <class Count>
struct NewtonOnFilm {
  double tolerance;
  double operator()(const RootCase& c) const {
    double film = c.flooded;
    for (int i = 0; i < most_iterations; ++i) {
      Count::one();
      const double d = film - c.offset;
      const double moment = gaussian_moment(Order::five_halves, d);
      const double asperity = std::sqrt(c.stiffness * moment);
      const double asperity_slope =
          moment > 0 ? -1.25 * asperity * gaussian_moment(Order::three_halves, d) / moment : 0;
      const double thicker = c.flooded * std::pow(1 - asperity, -film_exponent);
      const double slope = 1 - film_exponent * thicker * asperity_slope / (1 - asperity);
      const double step = (film - thicker) / slope;
      film -= step;
      if (!(std::abs(step) > tolerance * film)) return film;  // true for NaN, too
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace

std::vector<RootContender> textbook_roots(Settings settings) {
  std::vector<RootContender> all;
  for (const double tolerance : chosen(settings, {1e-10}, {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13})) {
    const Qagiu<PowIntegrand>::Method<Uncounted> by_pow{2.5, std::min(tolerance, 1e-8)};
    const auto name = [&](const char* method, const char* moment) {
      return fmt::format("{} {:.0e} + {}", method, tolerance, moment);
    };
    all.push_back(on_load_balance("textbook", name("fixed point", "QAGIU pow"), by_pow,
                                  FixedPoint{tolerance}));
    all.back().is_slow = true;
    all.push_back(on_load_balance("textbook", name("fixed point", "fit 4.4086e-5"),
                                  all_published_fits()[0].value, FixedPoint{tolerance}));
    all.push_back(on_load_balance("textbook", name("fixed point", "our F"), fast_moment,
                                  FixedPoint{tolerance}));
    all.push_back(one_by_one("textbook", name("Newton on the film", "our F"),
                             NewtonOnFilm<Uncounted>{tolerance}, NewtonOnFilm<Counted>{tolerance}));
  }
  return all;
}

}  // namespace tribo::benchmarks
