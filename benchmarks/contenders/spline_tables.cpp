// SPDX-License-Identifier: Apache-2.0
// Splines through tables: ln F_{5/2} over d, made once with GSL's quadrature; and, for one surface,
// ln λ over ln λ₀, with knots at chosen λ.
#include <fmt/format.h>
#include <gsl/gsl_spline.h>

#include <cmath>
#include <memory>
#include <vector>

#include "contenders/gsl_quadrature.hpp"
#include "contenders/moment_contender.hpp"
#include "contenders/root_contender.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::benchmarks {
namespace {

// GSL's natural cubic spline, with its accelerator for the search of the interval.
class SplineTable {
 public:
  SplineTable(const std::vector<double>& x, const std::vector<double>& y)
      : spline_(gsl_spline_alloc(gsl_interp_cspline, x.size()), gsl_spline_free),
        place_(gsl_interp_accel_alloc(), gsl_interp_accel_free) {
    gsl_spline_init(spline_.get(), x.data(), y.data(), x.size());
  }
  double operator()(double x) const { return gsl_spline_eval(spline_.get(), x, place_.get()); }

 private:
  std::shared_ptr<gsl_spline> spline_;
  std::shared_ptr<gsl_interp_accel> place_;
};

constexpr Range knots_range{-5, 12};

SplineTable log_table(int knots) {
  const Qagiu<PowIntegrand>::Method<Uncounted> moment{2.5, 1e-13};
  std::vector<double> d;
  std::vector<double> logarithm;
  for (int i = 0; i < knots; ++i) {
    d.push_back(knots_range.from + (knots_range.to - knots_range.from) * i / (knots - 1));
    logarithm.push_back(std::log(moment(d.back())));
  }
  return {d, logarithm};
}

constexpr double lowest = 1e-5;  // λ₀
constexpr double highest = 1000;

SplineTable inverse_table(const LoadSharing<double>& sharing, int knots) {
  // Near the floor λ_b, λ₀ = λ(1−A)^0.14 equals `lowest` if 1 − A is about (lowest/λ_b)^{1/0.14}.
  double nearest = lowest / 10;
  if (sharing.has_floor())
    nearest = std::exp(std::log(lowest / sharing.floor()) / sharing.film().sharing_power.value -
                       std::log(sharing.surface().hazard));
  std::vector<double> log_flooded;
  std::vector<double> log_film;
  for (int i = 0; i < knots; ++i) {
    const double distance = nearest * std::pow(highest / nearest, i / (knots - 1.0));
    const LoadShares<double> at = sharing.shares_above_floor(distance);
    log_flooded.push_back(std::log(sharing.flooded_film_parameter(at.film_parameter, at.fluid)));
    log_film.push_back(std::log(at.film_parameter));
  }
  return {log_flooded, log_film};
}

}  // namespace

std::vector<MomentContender> splines(Settings settings) {
  std::vector<MomentContender> all;
  for (const int knots : chosen(settings, {400}, {25, 50, 100, 200, 400, 800, 1600, 6400}))
    all.push_back(closed_form(
        "table", fmt::format("spline of ln F {} knots", knots), Order::five_halves,
        [table = log_table(knots)](double d) { return std::exp(table(d)); }, knots_range));
  return all;
}

std::vector<RootContender> inverse_tables(Settings settings) {
  std::vector<RootContender> all;
  for (const int knots : chosen(settings, {400}, {50, 100, 200, 400, 800, 1600, 6400})) {
    const auto prepare = [knots](const RootCases& surface) -> RootRun {
      const LoadSharing<double> sharing(AsperityModel::greenwood_tripp, surface.stiffness[0],
                                        surface.offset[0]);
      return
          [table = inverse_table(sharing, knots)](const RootCases& cases, std::span<double> film) {
            for (std::size_t i = 0; i < cases.size(); ++i)
              film[i] = std::exp(table(std::log(cases.flooded[i])));
          };
    };
    all.push_back({"table", fmt::format("inverse spline {} knots", knots), prepare});
  }
  return all;
}

}  // namespace tribo::benchmarks
