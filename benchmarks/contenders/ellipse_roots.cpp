// SPDX-License-Identifier: Apache-2.0
// The root k of α = (k²E − K)/(K − E) by Boost's and GSL's solvers with their elliptic integrals.
#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_sf_ellint.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "contenders/ellipse_contender.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int most_iterations = 200;
// For k below this number too many digits cancel in K − E, so the contact is treated as a circle
// (k = 1).
constexpr double least_ratio = 1 + 1e-6;
constexpr AxesRatio circle{1, std::numbers::pi / 2};

struct Integrals {
  double first, second;  // K, E of parameter 1 − 1/k²
};

template <class Count>
struct BoostIntegrals {
  static Integrals at(double k) {
    Count::one();
    const double modulus = std::sqrt(1 - 1 / (k * k));
    return {boost::math::ellint_1(modulus), boost::math::ellint_2(modulus)};
  }
};
template <class Count>
struct GslIntegrals {
  static Integrals at(double k) {
    Count::one();
    const double modulus = std::sqrt(1 - 1 / (k * k));
    return {gsl_sf_ellint_Kcomp(modulus, GSL_PREC_DOUBLE),
            gsl_sf_ellint_Ecomp(modulus, GSL_PREC_DOUBLE)};
  }
};

template <class Ways>
double ratio_at(double k) {
  const Integrals at = Ways::at(k);
  return (k * k * at.second - at.first) / (at.first - at.second);
}

template <class Count>
struct Toms748 {
  int bits;
  AxesRatio operator()(double alpha) const {
    using Ways = BoostIntegrals<Count>;
    const auto excess = [&](double k) { return ratio_at<Ways>(k) - alpha; };
    if (!(excess(least_ratio) < 0)) return circle;
    std::uintmax_t iterations = most_iterations;
    const auto [low, high] = boost::math::tools::toms748_solve(
        excess, least_ratio, alpha, boost::math::tools::eps_tolerance<double>(bits), iterations);
    const double k = low + (high - low) / 2;
    return {k, Ways::at(k).second};
  }
};

// Carlson's integrals: α = R_D(0, 1, 1/k²)/R_D(0, 1/k², 1), in which nothing cancels.
template <class Count>
struct Toms748Carlson {
  int bits;
  AxesRatio operator()(double alpha) const {
    using boost::math::ellint_rd;
    const auto integrals = [](double k) {
      Count::one();
      const double complement = 1 / (k * k);
      return Integrals{ellint_rd(0.0, 1.0, complement), ellint_rd(0.0, complement, 1.0)};
    };
    const auto excess = [&](double k) {
      const Integrals at = integrals(k);
      return at.first / at.second - alpha;
    };
    if (!(alpha > 1)) return circle;
    std::uintmax_t iterations = most_iterations;
    const auto [low, high] = boost::math::tools::toms748_solve(
        excess, 1.0, alpha, boost::math::tools::eps_tolerance<double>(bits), iterations);
    const double k = low + (high - low) / 2;
    const Integrals at = integrals(k);
    return {k, (at.first + at.second) / (3 * k * k)};
  }
};

template <class Count>
struct BoostNewton {
  int bits;
  AxesRatio operator()(double alpha) const {
    if (!(alpha > 1.5 * least_ratio - 0.5)) return circle;  // α ≈ k^{3/2} near the circle
    const auto excess_and_slope = [&](double k) {
      const auto [first, second] = BoostIntegrals<Count>::at(k);
      const double q = 1 - 1 / (k * k), dq = 2 / (k * k * k);
      const double first_slope = (second - (1 - q) * first) / (2 * q * (1 - q)) * dq;
      const double second_slope = (second - first) / (2 * q) * dq;
      const double above = k * k * second - first, below = first - second;
      const double slope = (2 * k * second + k * k * second_slope - first_slope -
                            above / below * (first_slope - second_slope)) /
                           below;
      return std::pair{above / below - alpha, slope};
    };
    std::uintmax_t iterations = most_iterations;
    const double guess = std::min(std::max(std::pow(alpha, 0.636), least_ratio), alpha);
    const double k = boost::math::tools::newton_raphson_iterate(
        excess_and_slope, guess, least_ratio, alpha, bits, iterations);
    return {k, BoostIntegrals<Count>::at(k).second};
  }
};

template <class Count>
struct GslBrent {
  double tolerance;
  std::shared_ptr<gsl_root_fsolver> solver{gsl_root_fsolver_alloc(gsl_root_fsolver_brent),
                                           gsl_root_fsolver_free};
  AxesRatio operator()(double alpha) const {
    using Ways = GslIntegrals<Count>;
    if (!(ratio_at<Ways>(least_ratio) < alpha)) return circle;
    gsl_function f{[](double k, void* wanted) {
                     return ratio_at<Ways>(k) - *static_cast<const double*>(wanted);
                   },
                   &alpha};
    gsl_root_fsolver* const s = solver.get();
    if (gsl_root_fsolver_set(s, &f, least_ratio, alpha) != GSL_SUCCESS) return {nan, nan};
    for (int i = 0; i < most_iterations; ++i) {
      if (gsl_root_fsolver_iterate(s) != GSL_SUCCESS) break;
      if (gsl_root_test_interval(gsl_root_fsolver_x_lower(s), gsl_root_fsolver_x_upper(s), 0,
                                 tolerance) != GSL_SUCCESS)
        continue;
      const double k = gsl_root_fsolver_root(s);
      return {k, Ways::at(k).second};
    }
    return {nan, nan};
  }
};

template <template <class> class Method, class Setting>
EllipseContender counted_too(std::string family, std::string name, Setting setting) {
  return {std::move(family), std::move(name), by_shape(Method<Uncounted>{setting}),
          by_shape(Method<Counted>{setting})};
}

}  // namespace

std::vector<EllipseContender> ellipse_roots(Settings settings) {
  gsl_set_error_handler_off();  // the default handler ends the program
  std::vector<EllipseContender> all;
  for (const double tolerance : chosen(settings, {1e-12}, {1e-3, 1e-5, 1e-7, 1e-9, 1e-12, 1e-14}))
    all.push_back(counted_too<GslBrent>(
        "GSL", fmt::format("Brent + Kcomp, Ecomp {:.0e}", tolerance), tolerance));
  for (const int bits : chosen(settings, {50}, {10, 20, 30, 40, 50}))
    all.push_back(counted_too<Toms748>(
        "Boost", fmt::format("TOMS 748 + ellint_1, ellint_2 {} bits", bits), bits));
  for (const int bits : chosen(settings, {50}, {10, 20, 30, 40, 50}))
    all.push_back(counted_too<Toms748Carlson>(
        "Boost", fmt::format("TOMS 748 + ellint_rd {} bits", bits), bits));
  for (const int bits : chosen(settings, {40}, {5, 10, 20, 40}))
    all.push_back(counted_too<BoostNewton>(
        "Boost", fmt::format("Newton + ellint_1, ellint_2 {} bits", bits), bits));
  return all;
}

}  // namespace tribo::benchmarks
