// SPDX-License-Identifier: Apache-2.0
// Films of flooded, smooth contacts: laws that are rows of numbers.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "generators/film_laws.hpp"
#include "generators/load_sharing_root.hpp"
#include "generators/quantities.hpp"
#include "generators/sampler.hpp"

namespace tribo::reference {
namespace {

struct Contact {
  double speed, viscosity, alpha, load, modulus, radius, k;
};

// U, G and W of a contact: with E' = 2E*, and as a line's F/L is a point's F/R.
struct Groups {
  Ball u, g, w;
  Groups(const Law& law, const Contact& x) {
    const Ball e2 = 2 * Ball(x.modulus), r(x.radius);
    u = Ball(x.viscosity) * Ball(x.speed) / (e2 * r);
    g = Ball(x.alpha) * e2;
    w = Ball(x.load) / (law.is_of_lines ? e2 * r : e2 * r * r);
  }
};

Row row_of(const Law& law, const Contact& x, const std::string& id, const char* region) {
  const Groups groups(law, x);
  const Ball side = fraction(law.m, 100) * exp(-fraction(law.n, 100) * Ball(x.k));
  const Ball scale = fraction(law.constant, 1000) * (1 - side) * Ball(x.radius);
  const Ball power =
      pow(groups.u, Ball(law.a)) * pow(groups.g, Ball(law.b)) / pow(groups.w, Ball(-law.c));
  const Ball film = bisect(
      [&](const Ball& h) {
        const Ball excess = pow(h / scale, Ball(law.q)) - power;
        return excess < 0 ? -1 : excess > 0 ? 1 : 0;
      },
      Ball(1e-25), Ball(1e8));
  // The condition in u, eta0, alpha, F, E*, R and k.
  const int by_radius = law.q - law.a - (law.is_of_lines ? 1 : 2) * law.c;
  const Ball condition =
      fraction(2 * law.a + law.b - law.c + std::abs(law.b - law.a - law.c) + std::abs(by_radius),
               law.q) +
      fraction(law.n, 100) * Ball(x.k) * side / (1 - side);
  std::vector<std::string> inputs{hexfloat(x.speed), hexfloat(x.viscosity)};
  if (law.b != 0) inputs.push_back(hexfloat(x.alpha));
  for (const double input : {x.load, x.modulus, x.radius}) inputs.push_back(hexfloat(input));
  if (!law.is_of_lines) inputs.push_back(hexfloat(x.k));
  return {id,
          std::move(inputs),
          scale * pow(groups.u, fraction(law.a, law.q)) * pow(groups.g, fraction(law.b, law.q)) *
              pow(groups.w, fraction(law.c, law.q)),
          film,
          condition,
          region};
}

}  // namespace

std::vector<std::string> film_laws() {
  std::vector<std::string> names;
  for (const Law& law : laws) names.emplace_back(law.name);
  return names;
}

Table film_table(const std::string& name) {
  const Law& law = *std::find_if(std::begin(laws), std::end(laws),
                                 [&](const Law& one) { return one.name == name; });
  const bool is_soft = law.b == 0, is_first = law.rows == 120;
  Table table;
  table.header = {
      law.name,
      law.definition,
      "m",
      fmt::format(
          "speed [1e-6, 100] m/s, viscosity [1e-4, 100] Pa s, {}{}, modulus [1e5, 1e12] Pa, "
          "radius [1e-6, 10] m{}",
          is_soft ? "" : "pressure_viscosity [1e-9, 1e-7] 1/Pa, ",
          law.is_of_lines ? "load per length [1, 1e7] N/m" : "load [1e-3, 1e6] N",
          law.is_of_lines ? "" : ", k [0.1, 20]"),
      "powers",
      fmt::format("bisection on (h/(CR))^{} = U^{} G^{} W^{}, whole powers", law.q, law.a, law.b,
                  law.c),
      fmt::format("id,speed,viscosity,{}{},effective_modulus,{}{},value,high,low,condition,region",
                  is_soft ? "" : "pressure_viscosity,",
                  law.is_of_lines ? "load_per_length" : "load",
                  law.is_of_lines || is_first ? "reduced_radius" : "radius_x",
                  law.is_of_lines ? "" : ",ellipticity")};
  Sampler sampler(law.seed);
  for (int i = 0; i < law.rows; ++i) {
    const bool usual = i < (is_first ? 60 : 40);  // steel and oil, or rubber
    const auto pick = [&](double low, double high, double lowest, double highest) {
      return usual ? sampler.log_uniform(low, high) : sampler.log_uniform(lowest, highest);
    };
    Contact x{};
    x.speed = pick(1e-4, 30, 1e-6, 100);
    x.viscosity = pick(1e-3, 1, 1e-4, 100);
    x.alpha = is_soft ? 1 : pick(5e-9, 4e-8, 1e-9, 1e-7);
    x.load = law.is_of_lines ? pick(1e3, 2e6, 1, 1e7) : pick(0.1, 1e4, 1e-3, 1e6);
    x.modulus = is_soft ? pick(1e6, 1e9, 1e5, 1e12) : pick(1e10, 5e11, 1e5, 1e12);
    x.radius = pick(1e-3, 0.3, 1e-6, 10);
    x.k = law.is_of_lines || i % 3 == 0 ? 1
          : usual                       ? sampler.uniform(1, 8)
                                        : sampler.log_uniform(0.1, 20);
    table.rows.emplace_back([x, &law, usual, id = fmt::format("{}{:04}", law.id, i)] {
      return row_of(law, x, id, usual ? "ordinary" : "far");
    });
  }
  return table;
}

}  // namespace tribo::reference
