// SPDX-License-Identifier: Apache-2.0
// Films of flooded, smooth contacts by the laws of film_laws.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "generators/film_laws.hpp"
#include "generators/sampler.hpp"
#include "generators/table.hpp"
#include "generators/zeros.hpp"

namespace tribo::reference {
namespace {

struct Contact {
  double speed, viscosity, alpha, load, modulus, radius, k;
};

// U, G and W of a contact, with E' = 2E*. A line has F/L where a point has F/R.
struct Groups {
  Ball u, g, w;
  Groups(const Law& law, const Contact& x) {
    const Ball e2 = 2 * Ball(x.modulus), r(x.radius);
    u = Ball(x.viscosity) * Ball(x.speed) / (e2 * r);
    g = Ball(x.alpha) * e2;
    w = Ball(x.load) / (law.is_of_lines ? e2 * r : e2 * r * r);
  }
};

Row row_of(const Law& law, const Contact& x, const char* region) {
  const Groups groups(law, x);
  const Ball side = fraction(law.m, 100) * exp(-fraction(law.n, 100) * Ball(x.k));
  const Ball scale = fraction(law.constant, 1000) * (1 - side) * Ball(x.radius);
  const Ball power =
      pow(groups.u, Ball(law.a)) * pow(groups.g, Ball(law.b)) / pow(groups.w, Ball(-law.c));
  const Ball film = zero_between([&](const Ball& h) { return pow(h / scale, Ball(law.q)) - power; },
                                 Ball(1e-25), Ball(1e8));
  // The sum of |d ln h/d ln input| over u, eta0, alpha, F, E*, R and k.
  const int by_radius = law.q - law.a - (law.is_of_lines ? 1 : 2) * law.c;
  const Ball condition =
      fraction(2 * law.a + law.b - law.c + std::abs(law.b - law.a - law.c) + std::abs(by_radius),
               law.q) +
      fraction(law.n, 100) * Ball(x.k) * side / (1 - side);
  std::vector<double> inputs{x.speed, x.viscosity};
  if (law.b != 0) inputs.push_back(x.alpha);
  inputs.insert(inputs.end(), {x.load, x.modulus, x.radius});
  if (!law.is_of_lines) inputs.push_back(x.k);
  return {{},
          std::move(inputs),
          scale * pow(groups.u, fraction(law.a, law.q)) * pow(groups.g, fraction(law.b, law.q)) *
              pow(groups.w, fraction(law.c, law.q)),
          film,
          condition,
          region};
}

// A contact at each end of each input and of U, G and W. The other inputs are as usual where
// possible. Where the load, the modulus or the radius is at an end, the load or the radius is
// changed, too, so that bodies can bear the pressure.
std::vector<Contact> contacts_at_ends(const Law& law, const Contact& usual) {
  const double power = law.is_of_lines ? 1 : 2;
  const auto load_number = [&](const Contact& x) {
    return x.load / (2 * x.modulus * std::pow(x.radius, power));
  };
  const double number = load_number(usual), greatest_load = law.is_of_lines ? 1e8 : 1e6;
  const auto with_load = [&](Contact x) {
    x.load = std::clamp(x.load * number / load_number(x), 1e-3, greatest_load);
    return x;
  };
  std::vector<Contact> all;
  const auto add = [&](double Contact::*input, double end) {
    all.push_back(usual);
    all.back().*input = end;
    if (input == &Contact::load)
      all.back().radius =
          std::clamp(usual.radius * std::pow(end / usual.load, 1 / power), 1e-4, 1.0);
    // These speeds keep U in its reach.
    if (input == &Contact::viscosity && end > 1) all.back().speed = 0.01;
    if (input == &Contact::radius && end < 1e-4) all.back().speed = 1e-3;
    if (input == &Contact::modulus || input == &Contact::radius) all.back() = with_load(all.back());
  };
  const auto add_both = [&](double Contact::*input, double least, double greatest) {
    add(input, least);
    add(input, greatest);
  };
  add_both(&Contact::speed, 1e-6, 100);
  add_both(&Contact::viscosity, 1e-4, 100);
  if (law.b != 0) add_both(&Contact::alpha, 1e-9, 1e-7);
  add_both(&Contact::load, 1e-3, greatest_load);
  add_both(&Contact::modulus, 1e5, 1e12);
  const bool is_of_radius_x = !law.is_of_lines && law.rows != 120;
  add_both(&Contact::radius, 1e-6, is_of_radius_x ? 1e3 : 10);
  if (!law.is_of_lines) add_both(&Contact::k, 0.1, 20);
  // U, by speed, viscosity and radius together
  for (const auto& [end, speed, radius] : {std::array{1e-18 / next_to_end, 3e-6, usual.radius},
                                           std::array{1e-4 * next_to_end, 20.0, 1e-5}}) {
    Contact x = usual;
    x.radius = radius;
    if (end < 1e-10) x.modulus = 1.1e11;
    x.speed = speed;
    x.viscosity = end * 2 * x.modulus * radius / speed;
    all.push_back(with_load(x));
  }
  if (law.b != 0)  // G, by both factors
    for (const auto& [alpha, product] :
         {std::pair{1e-9, 1e-3 / next_to_end}, std::pair{1e-7, 1e5 * next_to_end}}) {
      Contact x = usual;
      x.alpha = alpha;
      x.modulus = product / (2 * alpha);
      all.push_back(with_load(x));
    }
  for (const auto& [load, end] : {std::pair{2e-3, (law.is_of_lines ? 1e-13 : 1e-12) / next_to_end},
                                  std::pair{1e5, 100 * next_to_end}}) {  // W
    Contact x = usual;
    x.load = load;
    x.radius = std::pow(load / (2 * x.modulus * end), 1 / power);
    if (x.radius < 1e-6) {  // a line at the greatest W: more load
      x.radius = 2e-6;
      x.load = end * 2 * x.modulus * x.radius;
    }
    all.push_back(x);
  }
  return all;
}

Table film_table(const Law& law) {
  const bool is_soft = law.b == 0, is_first = law.rows == 120;
  Table table{
      {law.name, law.definition, "m",
       fmt::format(
           "speed [1e-6, 100] m/s, viscosity [1e-4, 100] Pa s, {}{}, modulus [1e5, 1e12] Pa, "
           "radius [1e-6, 10] m{}",
           is_soft ? "" : "pressure_viscosity [1e-9, 1e-7] 1/Pa, ",
           law.is_of_lines ? "load per length [1, 1e7] N/m" : "load [1e-3, 1e6] N",
           law.is_of_lines ? "" : ", k [0.1, 20]"),
       "powers",
       fmt::format("bisection on (h/(CR))^{} = U^{} G^{} W^{}, whole powers", law.q, law.a, law.b,
                   law.c),
       fmt::format("speed,viscosity,{}{},effective_modulus,{}{}",
                   is_soft ? "" : "pressure_viscosity,",
                   law.is_of_lines ? "load_per_length" : "load",
                   law.is_of_lines || is_first ? "reduced_radius" : "radius_x",
                   law.is_of_lines ? "" : ",ellipticity")},
      law.id};
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
    table.add([x, &law, usual] { return row_of(law, x, usual ? "ordinary" : "far"); });
  }
  const double first_load = law.is_of_lines ? 1e5 : 40, second_load = law.is_of_lines ? 3e5 : 250;
  const double scale = is_soft ? 1e-4 : 1;
  for (const Numbers& x : steps({0.7, 0.02, 2e-8, first_load, scale * 1.1e11, 0.01, 1},
                                {2, 0.09, is_soft ? 2e-8 : 1.2e-8, second_load, scale * 1.6e11,
                                 0.025, law.is_of_lines ? 1.0 : 4.0}))
    table.add([contact = Contact{x[0], x[1], x[2], x[3], x[4], x[5], x[6]}, &law] {
      return row_of(law, contact, "ordinary");
    });
  const Contact first{0.7, 0.02, 2e-8, first_load, scale * 1.1e11, 0.01, 1};
  for (const Contact& x : contacts_at_ends(law, first))
    table.add([x, &law] { return row_of(law, x, "end"); });
  return table;
}

}  // namespace

std::vector<Table> film_laws() {
  std::vector<Table> tables;
  for (const Law& law : laws) tables.push_back(film_table(law));
  return tables;
}

}  // namespace tribo::reference
