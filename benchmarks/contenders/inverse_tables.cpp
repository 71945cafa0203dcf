// SPDX-License-Identifier: Apache-2.0
// ln λ as a spline of ln λ₀ for one surface; the knots are found by walking λ.
#include <fmt/format.h>

#include <cmath>

#include "contenders/gsl_spline_table.hpp"
#include "contenders/root_families.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double lowest = 1e-5;  // λ₀
constexpr double highest = 1000;

SplineTable inverse_table(const LoadSharing<double>& sharing, int knots) {
  // λ₀ = λ(1−A)^0.14 is lowest where 1 − A is about (lowest/λ_b)^{1/0.14}.
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
    all.push_back({"table", fmt::format("inverse spline {} knots", knots), prepare, {}});
  }
  return all;
}

}  // namespace tribo::benchmarks
