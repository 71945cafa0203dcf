// SPDX-License-Identifier: Apache-2.0
// Films by formulas that do not have the form of film_laws.hpp, and the reduction of a film by
// heat.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "generators/sampler.hpp"
#include "generators/table.hpp"
#include "generators/zeros.hpp"

namespace tribo::reference {
namespace {

// h from Moes' film number H, which depends on M and L.
Ball moes_film(const Balls& x) {
  const Ball &speed = x[0], &viscosity = x[1], &alpha = x[2], &load = x[3], &modulus = x[4],
             &radius = x[5];
  const Ball e2 = 2 * modulus, u = viscosity * speed / (e2 * radius);
  const Ball m = load / (e2 * radius) / sqrt(2 * u), l = alpha * e2 * pow(2 * u, fraction(1, 4));
  const Ball ri = 3 / m, ei = fraction(2621, 1000) * pow(m, -fraction(1, 5));
  const Ball rp = fraction(1287, 1000) * pow(l, fraction(2, 3));
  const Ball ep = fraction(1311, 1000) * pow(m, -fraction(1, 8)) * pow(l, fraction(3, 4));
  const Ball s = (7 + 8 * exp(-2 * ei / ri)) / 5;
  const Ball isoviscous = pow(pow(ri, fraction(7, 3)) + pow(ei, fraction(7, 3)), 3 * s / 7);
  const Ball piezoviscous = pow(pow(rp, -fraction(7, 2)) + pow(ep, -fraction(7, 2)), -2 * s / 7);
  return radius * sqrt(2 * u) * pow(isoviscous + piezoviscous, 1 / s);
}
// The same by logarithms of the inputs. Bisection solves the last equation for H.
Ball moes_film_by_logarithms(const Balls& x) {
  const Ball ln_2u = log(x[0]) + log(x[1]) - log(x[4]) - log(x[5]);
  const Ball ln_m = log(x[3]) - log(Ball(2)) - log(x[4]) - log(x[5]) - ln_2u / 2;
  const Ball ln_l = log(Ball(2)) + log(x[2]) + log(x[4]) + ln_2u / 4;
  const Ball ln_ri = log(Ball(3)) - ln_m, ln_ei = log(fraction(2621, 1000)) - ln_m / 5;
  const Ball ln_rp = log(fraction(1287, 1000)) + 2 * ln_l / 3;
  const Ball ln_ep = log(fraction(1311, 1000)) - ln_m / 8 + 3 * ln_l / 4;
  const Ball s = fraction(7, 5) + fraction(8, 5) * exp(-2 * exp(ln_ei - ln_ri));
  const auto sum = [](const Ball& p, const Ball& a, const Ball& b) {  // ln of the p-norm
    return log(exp(p * a) + exp(p * b)) / p;
  };
  const Ball isoviscous = sum(fraction(7, 3), ln_ri, ln_ei);
  const Ball piezoviscous = sum(-fraction(7, 2), ln_rp, ln_ep);
  const Ball total = exp(s * isoviscous) + exp(s * piezoviscous);
  const Ball film =
      zero_between([&](const Ball& h) { return exp(s * log(h)) - total; }, Ball(1e-40), Ball(1e40));
  return film * x[5] * exp(ln_2u / 2);
}

// h from the film number H, which depends on M, L and D. Public transcriptions of the formula
// differ in the exponent within s and in the first bracket. A reading chooses form 0 or 1 of each.
struct MoesReading {
  std::size_t exponent, bracket;
};
Ball ellipse_film(MoesReading reading, const Balls& x) {
  const Ball &speed = x[0], &viscosity = x[1], &alpha = x[2], &load = x[3], &modulus = x[4],
             &radius = x[5];
  const Ball e2 = 2 * modulus, two_u = viscosity * speed / (modulus * radius), d = radius / x[6];
  const Ball m = load / (e2 * radius * radius) / pow(two_u, fraction(3, 4));
  const Ball l = alpha * e2 * pow(two_u, fraction(1, 4));
  const Ball q = 1 + fraction(6, 1000) * log(d) + fraction(63, 100) * pow(d, fraction(4, 7));
  const Ball ri =
      145 * pow(1 + fraction(796, 1000) * pow(d, fraction(14, 15)), -fraction(15, 7)) / (d * m * m);
  const Ball ei = fraction(318, 100) * pow(q, -fraction(14, 25)) * pow(d, -fraction(1, 15)) *
                  pow(m, -fraction(2, 15));
  const Ball rp = fraction(129, 100) * pow(1 + fraction(691, 1000) * d, -fraction(2, 3)) *
                  pow(l, fraction(2, 3));
  const Ball ep = fraction(148, 100) * pow(q, -fraction(7, 20)) * pow(d, -fraction(1, 24)) *
                  pow(m, -fraction(1, 12)) * pow(l, fraction(3, 4));
  const Ball h00 = fraction(18, 10) / d;
  const Ball s =
      fraction(3, 2) * (1 + exp(-fraction(6, 5) * ei / (reading.exponent == 0 ? ri : ep)));
  const Ball limited = pow(ei, Ball(-4)) + pow(h00, Ball(-4));
  const Ball first = reading.bracket == 0
                         ? pow(pow(ri, fraction(3, 2)) + pow(limited, -fraction(3, 8)), 2 * s / 3)
                         : pow(pow(ri, 3 * s / 2) + pow(limited, -3 * s / 8), 2 / (3 * s));
  const Ball second = pow(pow(rp, Ball(-8)) + pow(ep, Ball(-8)), -s / 8);
  return radius * sqrt(two_u) * pow(first + second, 1 / s);
}
// The same by logarithms of the inputs. Bisection solves the last equation for H.
Ball ellipse_film_by_logarithms(MoesReading reading, const Balls& x) {
  const Ball ln_2u = log(x[0]) + log(x[1]) - log(x[4]) - log(x[5]), ln_d = log(x[5]) - log(x[6]);
  const Ball ln_m = log(x[3]) - log(Ball(2)) - log(x[4]) - 2 * log(x[5]) - 3 * ln_2u / 4;
  const Ball ln_l = log(Ball(2)) + log(x[2]) + log(x[4]) + ln_2u / 4;
  const Ball ln_q = log1p(fraction(6, 1000) * ln_d + fraction(63, 100) * exp(4 * ln_d / 7));
  const Ball ln_ri =
      log(Ball(145)) - ln_d - 2 * ln_m - 15 * log1p(fraction(796, 1000) * exp(14 * ln_d / 15)) / 7;
  const Ball ln_ei = log(fraction(318, 100)) - 14 * ln_q / 25 - ln_d / 15 - 2 * ln_m / 15;
  const Ball ln_rp =
      log(fraction(129, 100)) + 2 * (ln_l - log1p(fraction(691, 1000) * exp(ln_d))) / 3;
  const Ball ln_ep = log(fraction(148, 100)) - 7 * ln_q / 20 - ln_d / 24 - ln_m / 12 + 3 * ln_l / 4;
  const Ball rise = exp(ln_ei - (reading.exponent == 0 ? ln_ri : ln_ep));
  const Ball s = fraction(3, 2) + fraction(3, 2) * exp(-6 * rise / 5);
  const auto sum = [](const Ball& p, const Ball& a, const Ball& b) {  // ln of the p-norm
    return log(exp(p * a) + exp(p * b)) / p;
  };
  const Ball limited = sum(Ball(-4), ln_ei, log(fraction(18, 10)) - ln_d);
  const Ball first = reading.bracket == 0 ? s * sum(fraction(3, 2), ln_ri, limited)
                                          : sum(3 * s / 2, ln_ri, limited);
  const Ball total = exp(first) + exp(s * sum(Ball(-8), ln_rp, ln_ep));
  const Ball film =
      zero_between([&](const Ball& h) { return exp(s * log(h)) - total; }, Ball(1e-40), Ball(1e40));
  return film * x[5] * exp(ln_2u / 2);
}

// The number x > 0 with x^q = power: by bisection on whole powers.
Ball root_of_power(const Ball& power, int q) {
  return zero_between([&](const Ball& x) { return pow(x, Ball(q)) - power; },
                      pow(Ball(2), Ball(-2000)), pow(Ball(2), Ball(2000)));
}

constexpr std::array regimes{"isoviscous_rigid", "viscous_rigid_barus", "viscous_rigid_roelands",
                             "isoviscous_elastic", "viscous_elastic"};

// Inputs: g_V, g_E, alpha and k.
Ball regime_film(std::size_t regime, const Balls& x) {
  const auto bracket = [](int n, const Ball& of) { return 1 - exp(-fraction(n, 10000) * of); };
  if (regime == 0)
    return 128 * x[2] / pow(1 + 2 / (3 * x[2]), Ball(2)) *
           pow(fraction(131, 1000) * atan(x[2] / 2) + fraction(1683, 1000), Ball(2));
  if (regime == 1) return fraction(166, 100) * pow(x[0], fraction(2, 3)) * bracket(6800, x[3]);
  if (regime == 2) return 141 * pow(x[0], fraction(375, 1000)) * bracket(387, x[2]);
  if (regime == 3)
    return fraction(87, 10) * pow(x[1], fraction(67, 100)) *
           (1 - fraction(85, 100) * exp(-fraction(31, 100) * x[3]));
  return fraction(342, 100) * pow(x[0], fraction(49, 100)) * pow(x[1], fraction(17, 100)) *
         bracket(6800, x[3]);
}
// The same by bisection on whole powers, and with an arccosine.
Ball regime_film_by_roots(std::size_t regime, const Balls& x) {
  const auto bracket = [](int n, const Ball& of) { return -expm1(-of * n / 10000); };
  if (regime == 0) {
    const Ball arc = acos(1 / sqrt(1 + x[2] * x[2] / 4));
    const Ball root = (131 * arc + 1683) * 3 * x[2] / (1000 * (3 * x[2] + 2));
    return 128 * x[2] * root * root;
  }
  const auto powers = [&](int a, int b, int q) {
    return root_of_power(pow(x[0], Ball(a)) * pow(x[1], Ball(b)), q);
  };
  if (regime == 1) return powers(2, 0, 3) * bracket(6800, x[3]) * 166 / 100;
  if (regime == 2) return powers(3, 0, 8) * bracket(387, x[2]) * 141;
  if (regime == 3) return powers(0, 67, 100) * (15 - 85 * expm1(-x[3] * 31 / 100)) * 87 / 1000;
  return powers(49, 17, 100) * bracket(6800, x[3]) * 342 / 100;
}

// Inputs: p0, E*, S, beta, eta0, u and k_f.
Ball thermal(const Balls& x) {
  const Ball l = x[3] * x[4] * x[5] * x[5] / x[6];
  const Ball sliding = x[2] == 0 ? Ball(1) : 1 + fraction(223, 100) * pow(x[2], fraction(83, 100));
  return (1 - fraction(132, 10) * x[0] / (2 * x[1]) * pow(l, fraction(42, 100))) /
         (1 + fraction(213, 1000) * sliding * pow(l, fraction(64, 100)));
}
Ball thermal_by_roots(const Balls& x) {
  const Ball l = x[3] * x[4] / x[6] * pow(x[5], Ball(2));
  const Ball heated = root_of_power(pow(l, Ball(21)), 50);
  const Ball sheared = root_of_power(pow(l, Ball(16)), 25);
  const Ball slid = x[2] == 0 ? Ball(0) : root_of_power(pow(x[2], Ball(83)), 100);
  return (x[1] - fraction(66, 10) * x[0] * heated) * 100000 /
         (x[1] * (100000 + 213 * sheared * (100 + 223 * slid)));
}

// Inputs: beta, eta0, u and k_f.
Ball rolling(const Balls& x) {
  const Ball l = x[0] * x[1] * x[2] * x[2] / x[3];
  return fraction(394, 100) / (fraction(394, 100) + pow(l, fraction(62, 100)));
}
Ball rolling_by_roots(const Balls& x) {
  const Ball l = x[0] * x[1] / x[3] * pow(x[2], Ball(2));
  return 1 - 1 / (1 + fraction(197, 50) / root_of_power(pow(l, Ball(31)), 50));
}

Table moes_lines() {
  Table table{
      {"moes_line", "H = {(RI^(7/3) + EI^(7/3))^(3s/7) + (RP^(-7/2) + EP^(-7/2))^(-2s/7)}^(1/s)",
       "m",
       "speed [1e-6, 100] m/s, viscosity [1e-4, 100] Pa s, pressure_viscosity [1e-9, "
       "1e-7] 1/Pa, load per length [1, 1e7] N/m, modulus [1e5, 1e12] Pa, radius [1e-6, "
       "10] m",
       "powers of M and L", "logarithms of the inputs; bisection on the last equation",
       "speed,viscosity,pressure_viscosity,load_per_length,effective_modulus,reduced_radius"},
      "fl"};
  Sampler sampler(1520);
  for (int i = 0; i < 90; ++i) {
    const bool usual = i < 60;
    const auto pick = [&](double low, double high, double lowest, double highest) {
      return usual ? sampler.log_uniform(low, high) : sampler.log_uniform(lowest, highest);
    };
    const double speed = pick(1e-4, 30, 1e-6, 100), viscosity = pick(1e-3, 1, 1e-4, 100);
    const double alpha = pick(5e-9, 4e-8, 1e-9, 1e-7);
    // One case in three has nearly rigid bodies.
    const double load = i % 3 == 1 ? pick(1, 1e3, 1e-3, 1e3) : pick(1e3, 2e6, 1, 1e7);
    const double modulus = i % 3 == 2 ? pick(1e6, 1e9, 1e5, 1e9) : pick(1e10, 5e11, 1e5, 1e12);
    const double radius = pick(1e-3, 0.3, 1e-6, 10);
    table.add({}, {speed, viscosity, alpha, load, modulus, radius}, moes_film,
              moes_film_by_logarithms, usual ? "ordinary" : "far");
  }
  for (const Numbers& x :
       steps({0.7, 0.02, 2e-8, 1e5, 1.1e11, 0.01}, {2, 0.09, 1.2e-8, 3e5, 1.6e11, 0.025}))
    table.add({}, x, moes_film, moes_film_by_logarithms, "ordinary");
  std::vector<Numbers> ends = at_ends({0.7, 0.02, 2e-8, 1e5, 1.1e11, 0.01}, {{0, 1e-6, 100},
                                                                             {1, 1e-4, 100},
                                                                             {2, 1e-9, 1e-7},
                                                                             {3, 1e-3, 1e8},
                                                                             {4, 1e5, 1e12},
                                                                             {5, 1e-6, 10}});
  ends[6][5] = 1e-5;               // the least load is on a thin roller
  ends[8][3] = ends[10][3] = 100;  // the least modulus and the least radius have small loads
  for (Numbers& x : ends) table.add({}, x, moes_film, moes_film_by_logarithms, "end");
  // M at both ends, and L at its upper end. At its lower end L has no effect on the film.
  struct Groups {
    double speed, radius, m, l;
  };
  for (const Groups& x : {Groups{0.7, 0.01, 1e-6 / next_to_end, 1},
                          {5e-6, 0.001, 1e7 * next_to_end, 1},
                          {40, 0.01, 10, 100 * next_to_end}}) {
    constexpr double viscosity = 0.02, twice = 2.2e11;  // 2E*
    const double u = viscosity * x.speed / (twice * x.radius);
    const double alpha = x.l / (twice * std::pow(2 * u, 0.25));
    const double load = x.m * std::sqrt(2 * u) * twice * x.radius;
    table.add({}, {x.speed, viscosity, alpha, load, twice / 2, x.radius}, moes_film,
              moes_film_by_logarithms, "end");
  }
  return table;
}

constexpr std::array moes_exponents{"ei_over_ri", "ei_over_ep"};
constexpr std::array moes_brackets{"three_halves", "three_halves_of_s"};

Table ellipse_films() {
  Table table{
      {"nijenbanning_venner_moes",
       "H = {[RI^(3/2) + (EI^(-4) + H00^(-4))^(-3/8)]^(2s/3) + [RP^(-8) + EP^(-8)]^(-s/8)}^(1/s), "
       "and its other readings",
       "m",
       "speed [1e-6, 100] m/s, viscosity [1e-4, 100] Pa s, pressure_viscosity [1e-9, 1e-7] 1/Pa, "
       "load [1e-3, 1e6] N, modulus [1e5, 1e12] Pa, radii [1e-6, 10] m, ratio [1e-4, 1e4]",
       "powers of M, L and D", "logarithms of the inputs; bisection on the last equation",
       "exponent,bracket,speed,viscosity,pressure_viscosity,load,effective_modulus,radius_x,"
       "radius_y"},
      "fn"};
  const auto add = [&table](const Numbers& x, MoesReading reading, const char* region) {
    table.add(
        {moes_exponents[reading.exponent], moes_brackets[reading.bracket]}, x,
        [=](const Balls& of) { return ellipse_film(reading, of); },
        [=](const Balls& of) { return ellipse_film_by_logarithms(reading, of); }, region);
  };
  constexpr std::array<MoesReading, 4> readings{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
  Sampler sampler(1524);
  for (std::size_t i = 0; i < 96; ++i) {
    const bool usual = i < 72;
    const auto pick = [&](double low, double high, double lowest, double highest) {
      return usual ? sampler.log_uniform(low, high) : sampler.log_uniform(lowest, highest);
    };
    const double speed = pick(1e-4, 30, 1e-6, 100), viscosity = pick(1e-3, 1, 1e-4, 100);
    const double alpha = pick(5e-9, 4e-8, 1e-9, 1e-7);
    // One case in three has nearly rigid bodies, and another one in three has soft bodies.
    const double load = i % 3 == 1 ? pick(1e-2, 1, 1e-3, 10) : pick(1, 1e4, 1e-3, 1e6);
    const double modulus = i % 3 == 2 ? pick(1e6, 1e9, 1e5, 1e9) : pick(1e10, 5e11, 1e9, 1e12);
    const double radius = pick(1e-3, 0.3, 1e-4, 1);
    const double across = i % 6 == 0 ? radius : radius * pick(0.1, 100, 1e-3, 1e3);
    // Every second case has the default reading.
    add({speed, viscosity, alpha, load, modulus, radius, across}, readings[i % 2 ? i / 2 % 4 : 0],
        usual ? "ordinary" : "far");
  }
  const Numbers one{0.7, 0.02, 2e-8, 50, 1.1e11, 0.01, 0.02};
  for (const MoesReading& reading : readings)
    for (const Numbers& x : steps(one, {2, 0.09, 1.2e-8, 300, 1.6e11, 0.025, 0.04}))
      add(x, reading, "ordinary");
  std::vector<Numbers> ends = at_ends(one, {{0, 1e-6, 100},
                                            {1, 1e-4, 100},
                                            {2, 1e-9, 1e-7},
                                            {3, 1e-3, 1e6},
                                            {4, 1e5, 1e12},
                                            {5, 1e-6, 1e3},
                                            {6, 1e-6, 1e3}});
  // Where one radius is great, both are, so that R_x/R_y is in its range.
  for (Numbers& x : ends)
    if (x[5] > 500 || x[6] > 500)
      x[3] = 1e4, x[5] = std::max(x[5], 500.), x[6] = std::max(x[6], 500.);
  // Successive readings differ in one word.
  constexpr std::array<MoesReading, 4> by_steps{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (const Numbers& x : ends)
    for (const MoesReading& reading : by_steps) add(x, reading, "end");
  // M, L and D at their ends. The least L has an effect on the film only where D is great.
  struct Groups {
    double speed, radius, modulus, m, l, d;
  };
  for (const Groups& x : {Groups{50, 1, 1.1e11, 1e-6 / next_to_end, 1, 1},
                          {1e-3, 0.001, 1.1e11, 1e7 * next_to_end, 1, 1},
                          {40, 0.01, 1.1e11, 10, 100 * next_to_end, 1},
                          {3, 0.01, 1e6, 100, 1e-4 / next_to_end, 5e3},
                          {0.7, 0.01, 1.1e11, 100, 5, 1e-4 / next_to_end},
                          {0.7, 0.01, 1.1e11, 100, 5, 1e4 * next_to_end}}) {
    constexpr double viscosity = 0.02;
    const double modulus = x.modulus;
    const double two_u = viscosity * x.speed / (modulus * x.radius);
    const double alpha = x.l / (2 * modulus * std::pow(two_u, 0.25));
    const double load = x.m * std::pow(two_u, 0.75) * 2 * modulus * x.radius * x.radius;
    for (const MoesReading& reading : by_steps)
      add({x.speed, viscosity, alpha, load, modulus, x.radius, x.radius / x.d}, reading, "end");
  }
  return table;
}

Table regime_films() {
  Table table{{"regime_film", "H = (hmin/R_x)(W/U)^2 of one of five regimes", "dimensionless",
               "g_V and g_E [1, 1e10], radius ratio [0.1, 80], k [0.1, 20]; far: [1e-12, 1e20]",
               "powers", "bisection on whole powers; the arc of a cosine",
               "regime,viscosity_parameter,elasticity_parameter,radius_ratio,ellipticity"},
              "fr"};
  const auto add = [&table](std::size_t regime, const Numbers& numbers, const char* region) {
    table.add(
        {regimes[regime]}, numbers, [=](const Balls& x) { return regime_film(regime, x); },
        [=](const Balls& x) { return regime_film_by_roots(regime, x); }, region);
  };
  Sampler sampler(1521);
  for (std::size_t regime = 0; regime < regimes.size(); ++regime)
    for (int i = 0; i < 24; ++i) {
      const bool usual = i < 18;
      const auto group = [&] {
        return usual ? sampler.log_uniform(1, 1e10) : sampler.log_uniform(1e-12, 1e20);
      };
      const double viscosity = group(), elasticity = group();
      const double ratio = i % 6 == 0 ? 1 : sampler.log_uniform(0.1, 80);
      const double k = i % 6 == 0 ? 1 : sampler.log_uniform(0.1, 20);
      add(regime, {viscosity, elasticity, ratio, k}, usual ? "ordinary" : "far");
    }
  // Every second regime takes the steps backwards, so that each begins where the last one ends.
  const Numbers one{2e4, 300, 3, 2}, other{9e5, 4000, 12, 5};
  for (std::size_t regime = 0; regime < regimes.size(); ++regime)
    for (const Numbers& x : regime % 2 == 0 ? steps(one, other) : steps(other, one))
      add(regime, x, "ordinary");
  // Each regime at the ends of the inputs that it depends on.
  const Reach viscous{0, 1e-3, 1e12}, elastic{1, 1e-3, 1e12}, ratio{2, 0.05, 100}, k{3, 0.1, 20};
  const std::array<std::vector<Reach>, regimes.size()> reaches{
      {{ratio}, {viscous, k}, {viscous, ratio}, {elastic, k}, {viscous, elastic, k}}};
  for (std::size_t regime = 0; regime < regimes.size(); ++regime)
    for (const Numbers& x : at_ends(one, reaches[regime])) add(regime, x, "end");
  return table;
}

Table thermal_reductions() {
  Table table{
      {"gupta_thermal_reduction",
       "(1 - 13.2 (p0/E') L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64), E' = 2E*", "dimensionless",
       "p0 [1e8, 3e9] Pa, E* [1e10, 5e11] Pa, S 0 or [1e-3, 2], beta [0.01, 0.1] 1/K, "
       "viscosity [1e-3, 1] Pa s, speed [0.01, 30] m/s, k_f [0.05, 0.3] W/(m K), where "
       "the numerator is above 0; far: numerators down to 1e-9",
       "powers", "bisection on whole powers",
       "peak_pressure,effective_modulus,slide_roll_ratio,temperature_viscosity,"
       "viscosity,speed,thermal_conductivity"},
      "th"};
  Sampler sampler(1522);
  while (table.rows.size() < 72) {
    const bool usual = table.rows.size() < 60;
    double pressure = sampler.log_uniform(1e8, 3e9);
    const double modulus = sampler.log_uniform(1e10, 5e11);
    const double sliding = table.rows.size() % 6 == 0 ? 0 : sampler.log_uniform(1e-3, 2);
    const double beta = sampler.uniform(0.01, 0.1), viscosity = sampler.log_uniform(1e-3, 1);
    const double speed = sampler.log_uniform(0.01, 30), conductivity = sampler.uniform(0.05, 0.3);
    const double heating = beta * viscosity * speed * speed / conductivity;
    const double limit = 2 * modulus / (13.2 * std::pow(heating, 0.42));
    if (usual && pressure > 0.9 * limit) continue;
    if (!usual) pressure = limit * (1 - sampler.log_uniform(1e-9, 0.1));  // just allowed
    table.add({}, {pressure, modulus, sliding, beta, viscosity, speed, conductivity}, thermal,
              thermal_by_roots, usual ? "ordinary" : "far");
  }
  for (const Numbers& x :
       steps({6e8, 1.1e11, 0.1, 0.03, 0.02, 2, 0.12}, {9e8, 1.6e11, 0.5, 0.05, 0.09, 5, 0.15}))
    table.add({}, x, thermal, thermal_by_roots, "ordinary");
  std::vector<Numbers> ends = at_ends({6e8, 1.1e11, 0.1, 0.03, 0.02, 1.5, 0.12}, {{0, 1e6, 5e9},
                                                                                  {1, 1e5, 1e12},
                                                                                  {2, 0, 10},
                                                                                  {3, 1e-3, 0.2},
                                                                                  {4, 1e-4, 100},
                                                                                  {5, 1e-6, 100},
                                                                                  {6, 0.01, 10}});
  ends[2] = {1e6, 1e5, 0.1, 0.03, 0.02, 0.05, 0.12};            // else the numerator is below 0
  ends.push_back({6e8, 1.1e11, 0.1, 0.03, 0.04, 99.9, 0.12});   // L next to 100
  ends.push_back({7.3e8, 1.1e11, 10, 0.03, 0.04, 99.9, 0.12});  // the factor next to 0.01
  for (const Numbers& x : ends) table.add({}, x, thermal, thermal_by_roots, "end");
  return table;
}

Table rolling_reductions() {
  Table table{{"murch_wilson_thermal_reduction", "3.94/(3.94 + L^0.62), L = beta eta0 u^2/k_f",
               "dimensionless",
               "beta [0.01, 0.1] 1/K, viscosity [1e-3, 1] Pa s, speed [0.01, 30] m/s, k_f [0.05, "
               "0.3] W/(m K); far: speed [1e-100, 1e100] m/s",
               "powers", "bisection on whole powers",
               "temperature_viscosity,viscosity,speed,thermal_conductivity"},
              "tm"};
  const auto add = [&table](const Numbers& x, const char* region) {
    table.add({}, x, rolling, rolling_by_roots, region);
  };
  Sampler sampler(1523);
  for (int i = 0; i < 50; ++i) {
    const bool usual = i < 42;
    const double beta = sampler.uniform(0.01, 0.1), viscosity = sampler.log_uniform(1e-3, 1);
    const double speed = usual ? sampler.log_uniform(0.01, 30) : sampler.log_uniform(1e-100, 1e100);
    add({beta, viscosity, speed, sampler.uniform(0.05, 0.3)}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({0.03, 0.02, 2, 0.12}, {0.05, 0.09, 5, 0.15})) add(x, "ordinary");
  for (const Numbers& x : at_ends({0.03, 0.02, 1.5, 0.12},
                                  {{0, 1e-3, 0.2}, {1, 1e-4, 100}, {2, 1e-6, 100}, {3, 0.01, 10}}))
    add(x, "end");
  add({0.03, 0.04, 99.9, 0.12}, "end");  // L next to 100
  return table;
}

}  // namespace

std::vector<Table> film_formulas() {
  return {moes_lines(), ellipse_films(), regime_films(), thermal_reductions(),
          rolling_reductions()};
}

}  // namespace tribo::reference
