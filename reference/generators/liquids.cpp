// SPDX-License-Identifier: Apache-2.0
// Liquids under pressure and temperature; summits of a rough face from its spectral moments.
#include <algorithm>
#include <array>
#include <utility>

#include "generators/sampler.hpp"
#include "generators/table.hpp"
#include "generators/zeros.hpp"

namespace tribo::reference {
namespace {

// Inputs: eta0, alpha and p.
Ball barus(const Balls& x) { return x[0] * exp(x[1] * x[2]); }
Ball barus_by_logarithm(const Balls& x) {
  return zero_between([&](const Ball& y) { return log(y / x[0]) - x[1] * x[2]; }, x[0] / 2,
                      x[0] * exp(x[1] * x[2] + 1));
}
Ball roelands(const Balls& x) {
  const Ball scale = log(x[0]) + fraction(967, 100), pressure(196000000);
  const Ball z = x[1] * pressure / scale;
  return x[0] * exp(scale * (pow(1 + x[2] / pressure, z) - 1));
}
// Roelands' law by eta0 over 6.315e-5 Pa s, the viscosity at which all isotherms meet.
Ball roelands_by_pole(const Balls& x) {
  const Ball over_pole = x[0] * exp(fraction(967, 100));
  const Ball power = exp(x[1] * 196000000 * log((x[2] + 196000000) / 196000000) / log(over_pole));
  return pow(over_pole, power) * exp(-fraction(967, 100));
}

// Inputs: T1, nu1, T2, nu2 and T. The second way takes A and B with decimal logarithms.
Ball astm_d341(const Balls& x) {
  const auto z = [](const Ball& viscosity) {
    return log(log(1000000 * viscosity + fraction(7, 10)));
  };
  const Ball slope = (z(x[3]) - z(x[1])) / (log(x[2]) - log(x[0]));
  return (exp(exp(z(x[1]) + slope * (log(x[4]) - log(x[0])))) - fraction(7, 10)) / 1000000;
}
Ball astm_d341_in_decimals(const Balls& x) {
  const Ball ten = log(Ball(10));
  const auto log10 = [&](const Ball& y) { return log(y) / ten; };
  const auto z = [&](const Ball& viscosity) {
    return log10(log10(viscosity / fraction(1, 1000000) + fraction(7, 10)));
  };
  const Ball b = (z(x[1]) - z(x[3])) / log10(x[2] / x[0]);
  const Ball a = z(x[3]) + b * log10(x[2]);
  const Ball of_log = pow(Ball(10), a - b * log10(x[4]));
  return (pow(Ball(10), of_log) - fraction(7, 10)) * fraction(1, 1000000);
}

// Table X2.1 of ASTM D2270: L = aY^2 + bY + c and H = dY^2 + eY + f up to Y = `end` in m2/s, the
// end included. The coefficients are in 10^-5.
struct IndexOil {
  std::array<int, 3> zero, hundred;  // a, b, c of L; d, e, f of H
  double end;
};
constexpr std::array<IndexOil, 16> index_oils{{
    {{114673, 175760, -10900}, {84155, 155210, -7700}, 3.8e-6},
    {{338095, -1549520, 3319600}, {78571, 179290, -18300}, 4.4e-6},
    {{250000, -721430, 1381200}, {82143, 156790, 11900}, 5e-6},
    {{10100, 1663500, -4546900}, {4985, 916130, -1855700}, 6.4e-6},
    {{335714, -2356430, 7846600}, {22619, 773690, -1665600}, 7e-6},
    {{1191, 2147500, -7287000}, {79762, -73210, 1461000}, 7.7e-6},
    {{41858, 1615580, -5604000}, {5794, 1051560, -2824000}, 9e-6},
    {{88779, 755270, -1660000}, {26665, 670150, -1081000}, 12e-6},
    {{76720, 1079720, -3818000}, {20073, 846580, -2249000}, 15e-6},
    {{97305, 531350, -220000}, {28889, 597410, -493000}, 18e-6},
    {{97256, 525000, -98000}, {24504, 741600, -1673000}, 22e-6},
    {{91413, 747590, -2182000}, {20323, 912670, -3423000}, 28e-6},
    {{87031, 971570, -5077000}, {18411, 1010150, -4675000}, 40e-6},
    {{84703, 1267520, -13331000}, {17029, 1148660, -8062000}, 55e-6},
    {{85921, 1110090, -8319000}, {17130, 1136800, -7694000}, 70e-6},
    {{83531, 1467310, -21624600}, {16841, 1184930, -9694700}, 1e300},
}};
const IndexOil& index_oil(double at_100) {
  const IndexOil* oil = index_oils.data();
  while (at_100 > oil->end) ++oil;
  return *oil;
}
// L or H in mm2/s: by the powers of Y, and by those of Y - 10.
Ball oil_at_40(const std::array<int, 3>& k, const Ball& y) {
  return (k[0] * y * y + k[1] * y + k[2]) / 100000;
}
Ball oil_at_40_from_ten(const std::array<int, 3>& k, const Ball& y) {
  const Ball step = y - 10;
  const Ball value = Ball(k[0]) * 100 + Ball(k[1]) * 10 + k[2], slope = Ball(k[0]) * 20 + k[1];
  return fraction(1, 100000) * (value + step * (slope + step * k[0]));
}
// Inputs: nu at 40 C and at 100 C. The first way takes logarithms, the second one a root of H/U.
Ball viscosity_index(const IndexOil& oil, const Balls& x) {
  const Ball u = 1000000 * x[0], y = 1000000 * x[1];
  const Ball zero = oil_at_40(oil.zero, y), hundred = oil_at_40(oil.hundred, y);
  if (u >= hundred) return 100 * (zero - u) / (zero - hundred);
  const Ball ten = log(Ball(10)), n = (log(hundred) - log(u)) / log(y);
  return (exp(n * ten) - 1) / fraction(715, 100000) + 100;
}
Ball viscosity_index_by_root(const IndexOil& oil, const Balls& x) {
  const Ball u = x[0] / fraction(1, 1000000), y = x[1] / fraction(1, 1000000);
  const Ball zero = oil_at_40_from_ten(oil.zero, y), hundred = oil_at_40_from_ten(oil.hundred, y);
  if (u > hundred) return 100 - 100 * (u - hundred) / (zero - hundred);
  const Ball antilog = pow(hundred / u, log(Ball(10)) / log(y));
  return (antilog - fraction(28500, 100000)) * 100000 / 715;
}

// Inputs: m0, m2 and m4.
Ball summits(std::size_t k, const Balls& x) {
  const Ball alpha = x[0] * x[2] / (x[1] * x[1]), limit = fraction(8968, 10000);
  const Ball height_sd = sqrt((1 - limit / alpha) * x[0]);
  if (k == 0) return alpha;
  if (k == 1) return x[2] / (6 * ball_pi() * sqrt(Ball(3)) * x[1]);
  if (k == 2) return fraction(3, 8) * sqrt(ball_pi() / x[2]);
  if (k == 3) return height_sd;
  return 4 * sqrt(x[0] / (ball_pi() * alpha)) / height_sd;
}
Ball summits_by_squares(std::size_t k, const Balls& x) {
  const Ball narrow = x[1] * x[1] / x[2];  // the m0 of bandwidth 1
  const Ball variance = x[0] - fraction(8968, 10000) * narrow;
  if (k == 0) return x[0] / narrow;
  if (k == 1) return sqrt(pow(x[2] / x[1] / ball_pi(), Ball(2)) / 108);
  if (k == 2) return sqrt(9 * ball_pi() / (64 * x[2]));
  if (k == 3) return sqrt(variance);
  return sqrt(16 * narrow / (ball_pi() * variance));
}

Table densities() {
  Table table{{"dowson_higginson_density", "rho/rho0 = (5.9e8 + 1.34p)/(5.9e8 + p)",
               "dimensionless", "p 0 or [1e5, 4e9] Pa; far: [1e-300, 1e300] Pa", "the quotient",
               "1.34 less what is lacking at a finite pressure", "pressure"},
              "ld"};
  const auto add = [&table](double pressure, const char* region) {
    table.add(
        {}, {pressure},
        [](const Balls& x) {
          return (Ball(590000000) + fraction(134, 100) * x[0]) / (Ball(590000000) + x[0]);
        },
        [](const Balls& x) {
          return fraction(134, 100) - fraction(34, 100) / (1 + x[0] / 590000000);
        },
        region);
  };
  Sampler sampler(1530);
  for (int i = 0; i < 40; ++i) {
    const bool usual = i < 30;
    const double p = i == 0  ? 0
                     : usual ? sampler.log_uniform(1e5, 4e9)
                             : sampler.log_uniform(1e-300, 1e300);
    add(p, usual ? "ordinary" : "far");
  }
  add(4e9, "end");
  std::swap(table.rows[0], table.rows[1]);  // the first row has a pressure above 0
  return table;
}

Table pressure_viscosities(bool is_barus) {
  Table table{{is_barus ? "barus_viscosity" : "roelands_viscosity",
               is_barus ? "eta0 exp(alpha p)"
                        : "eta0 exp((ln eta0 + 9.67)((1 + p/0.196e9)^z - 1)), z = alpha "
                          "0.196e9/(ln eta0 + 9.67)",
               "Pa s",
               "viscosity [1e-3, 10] Pa s, pressure_viscosity [1e-9, 5e-8] 1/Pa, p 0 or [1e5, "
               "4e9] Pa, alpha p below 40; end: viscosity [1e-4, 100] Pa s, pressure_viscosity "
               "[1e-9, 1e-7] 1/Pa, exponent below 70; far: viscosity from 7e-5 Pa s, alpha p below "
               "200",
               is_barus ? "exponential" : "exponential of a power",
               is_barus ? "bisection on the logarithm" : "a power of eta0 over 6.315e-5 Pa s",
               "viscosity,pressure_viscosity,pressure"},
              is_barus ? "lb" : "lr"};
  const auto add = [&](const Numbers& numbers, const char* region) {
    table.add({}, numbers, is_barus ? barus : roelands,
              is_barus ? barus_by_logarithm : roelands_by_pole, region);
  };
  Sampler sampler(is_barus ? 1531 : 1532);
  while (table.rows.size() < 60) {
    const bool usual = table.rows.size() < 48;
    const double viscosity = usual ? sampler.log_uniform(1e-3, 10) : sampler.log_uniform(7e-5, 1e3);
    const double alpha = sampler.log_uniform(1e-9, 5e-8);
    const double p = table.rows.size() % 12 == 0 ? 0 : sampler.log_uniform(1e5, 4e9);
    if (alpha * p > (usual ? 40 : 200)) continue;
    add({viscosity, alpha, p}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({0.02, 2e-8, 3e8}, {0.09, 1.2e-8, 7e8})) add(x, "ordinary");
  // The exponent is at most 70. By Roelands' law the thinnest oil and the greatest alpha reach it
  // at low pressures.
  std::vector<Numbers> ends = at_ends({0.02, 1e-8, 3e8}, {{0, 1e-4, 100}, {1, 1e-9, 1e-7}});
  if (!is_barus) {
    ends[0] = {1e-4, 1e-8, 1e8};
    ends[3] = {0.02, 1e-7, 1e8};
  }
  ends.push_back({0.02, 1e-8, 4e9});
  ends.push_back(is_barus ? Numbers{0.02, 2e-8, next_to_end * 3.5e9} : Numbers{1, 4.304e-8, 2e9});
  for (const Numbers& x : ends) add(x, "end");
  std::swap(table.rows[0], table.rows[1]);  // the first row has a pressure above 0
  return table;
}

Table barus_viscosities() { return pressure_viscosities(true); }
Table roelands_viscosities() { return pressure_viscosities(false); }

Table temperature_viscosities() {
  Table table{
      {"astm_d341_viscosity", "log log(nu + 0.7) = A - B log T through two points, nu in mm2/s",
       "m2/s",
       "temperatures [250, 450] K, viscosities [4e-6, 2e-3] m2/s; end: [200, 600] K, [4e-6, "
       "1] m2/s; far: next to each other, thinner, and beyond the two points",
       "natural logarithms", "A and B in decimal logarithms",
       "first_temperature,first_viscosity,second_temperature,second_viscosity,temperature"},
      "lt"};
  // Below some 4 mm2/s a further term of the standard matters: such rows are far.
  const auto add = [&table](const Numbers& numbers, const char* region) {
    table.add([=] {
      const Balls x(numbers.begin(), numbers.end());
      const Ball value = astm_d341(x);
      const bool is_thin = std::min({x[1].nearest(), x[3].nearest(), value.nearest()}) < 4e-6;
      return Row{{},
                 numbers,
                 value,
                 astm_d341_in_decimals(x),
                 condition_of(astm_d341, x),
                 is_thin ? "far" : region};
    });
  };
  Sampler sampler(1533);
  for (int i = 0; i < 60; ++i) {
    const bool usual = i < 44;
    const double first = i % 3 == 0 ? 313.15 : sampler.uniform(280, 340);
    const double second = i % 3 == 0 ? 373.15 : first + sampler.uniform(usual ? 20 : 0.01, 60);
    const double thin = usual ? sampler.log_uniform(2e-6, 4e-5) : sampler.log_uniform(4e-7, 4e-5);
    const double thick = thin * sampler.log_uniform(1.5, 20);
    const double at = usual ? sampler.uniform(260, 430) : sampler.uniform(200, 600);
    add({first, thick, second, thin, at}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x :
       steps({313.15, 68e-6, 373.15, 8.7e-6, 330}, {303.15, 120e-6, 363.15, 10.5e-6, 350}))
    add(x, "ordinary");
  // Each temperature and viscosity at its ends, with either point as the warmer one.
  for (const Numbers& x : {Numbers{200, 0.05, 373.15, 8.7e-6, 330},
                           {600, 4.5e-6, 313.15, 68e-6, 330},
                           {313.15, 68e-6, 200, 0.05, 280},
                           {313.15, 68e-6, 600, 4.5e-6, 330},
                           {373.15, 4e-6, 313.15, 20e-6, 330},
                           {263.15, 1, 373.15, 40e-6, 330},
                           {313.15, 20e-6, 373.15, 4e-6, 330},
                           {373.15, 40e-6, 263.15, 1, 330},
                           {313.15, 15e-6, 373.15, 4.2e-6, 200},
                           {313.15, 2e-3, 373.15, 2e-4, 600},
                           {373.15, 8.7e-6, 313.15, 68e-6, 413.2},
                           {373.15, 8.7e-6, 313.15, 68e-6, 225.91}})
    add(x, "end");
  return table;
}

// Inputs: eta0, eta_inf, lambda, the shear rate, a and n.
Ball carreau_yasuda(const Balls& x) {
  if (x[3] == 0) return x[0];
  const Ball stretched = 1 + pow(x[2] * x[3], x[4]);
  return x[1] + (x[0] - x[1]) * pow(stretched, (x[5] - 1) / x[4]);
}
// The same by logarithms, as eta0 less what shear thinning takes away.
Ball carreau_yasuda_by_loss(const Balls& x) {
  if (x[3] == 0) return x[0];
  const Ball stretched = log1p(exp(x[4] * (log(x[2]) + log(x[3]))));
  return x[0] + (x[0] - x[1]) * expm1(-stretched * (1 - x[5]) / x[4]);
}

Table thinning_viscosities() {
  Table table{
      {"carreau_yasuda_viscosity", "eta_inf + (eta0 - eta_inf) (1 + (lambda rate)^a)^((n - 1)/a)",
       "Pa s",
       "viscosity [1e-3, 1e4] Pa s, viscosity at high shear 0 or up to a half of it, "
       "relaxation time [1e-9, 1] s, rate 0 or such that lambda rate is in [1e-3, 1e5], a "
       "[0.5, 4], n [0.1, 1]; end: a [0.2, 10], lambda rate to 1e6; far: lambda rate [1e-12, "
       "1e12]",
       "powers", "logarithms, and eta0 less what is lost",
       "viscosity,high_shear_viscosity,relaxation_time,shear_rate,transition_exponent,"
       "power_law_index"},
      "lc"};
  const auto add = [&table](const Numbers& x, const char* region) {
    table.add({}, x, carreau_yasuda, carreau_yasuda_by_loss, region);
  };
  Sampler sampler(1536);
  for (int i = 0; i < 60; ++i) {
    const bool usual = i < 48;
    const double viscosity = sampler.log_uniform(1e-3, 1e4);
    const double high = i % 4 == 1 ? 0 : viscosity * sampler.log_uniform(1e-4, 0.5);
    const double time = sampler.log_uniform(1e-9, 1);
    const double number = usual ? sampler.log_uniform(1e-3, 1e5) : sampler.log_uniform(1e-12, 1e12);
    const double rate = i % 12 == 2 ? 0 : number / time;
    const double a = i % 3 == 0 ? 2 : sampler.uniform(0.5, 4);
    add({viscosity, high, time, rate, a, sampler.uniform(0.1, 1)}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({0.4, 0.02, 1e-5, 1e6, 2, 0.5}, {0.9, 0.07, 3e-5, 2e6, 1.4, 0.35}))
    add(x, "ordinary");
  for (const Numbers& x : at_ends(
           {0.4, 0.02, 1e-5, 1e6, 2, 0.5},
           {{0, 1e-4, 1e6}, {1, 0, 100}, {2, 1e-12, 100}, {3, 0, 1e10}, {4, 0.2, 10}, {5, 0.1, 1}}))
    add(x, "end");
  for (const Numbers& x : {Numbers{0.4, 0.02, 1e-12, 1e10, 0.5, 0.5},
                           {1e3, 0.02, 100, 1e3, 2, 0.5},
                           {1e3, 0, 1e-4, 1e10, 2, 0.5},
                           {0.4, 0, 1e-5, next_to_end * 1e11, 2, 0.8},
                           {0.4, 0.02, 1e-5, 2e5, 10, 0.5},
                           {0.4, 0.02, 1e-5, 1.1e5, 10, 0.5}})
    add(x, "end");
  return table;
}

Table viscosity_indices() {
  Table table{{"viscosity_index",
               "VI = 100 (L - U)/(L - H); where U is below H, 100 + (10^N - 1)/0.00715 with N = "
               "log(H/U)/log Y; U and Y = nu at 40 and 100 C in mm2/s, L and H from table X2.1 of "
               "ASTM D2270, at the end of a range by its lower one",
               "1",
               "Y [2, 70] mm2/s, index [0, 300]; both sides of each end of a range of table X2.1, "
               "and of index 100; end: index [-99, 394]; far: Y up to 1e4 mm2/s, index below 0 "
               "and above 300",
               "powers of Y, decimal logarithms", "powers of Y - 10, a root of H/U",
               "kinematic_viscosity_40,kinematic_viscosity_100"},
              "li"};
  const auto add = [&](double at_40, double at_100, const char* region) {
    const IndexOil& oil = index_oil(at_100);
    table.add(
        {}, {at_40, at_100}, [&oil](const Balls& x) { return viscosity_index(oil, x); },
        [&oil](const Balls& x) { return viscosity_index_by_root(oil, x); }, region);
  };
  // L or H at `at_100`, in m2/s.
  const auto at_40 = [](const std::array<int, 3>& k, double at_100) {
    return (oil_at_40(k, 1000000 * Ball(at_100)) / 1000000).nearest();
  };
  const auto zero = [&](double y) { return at_40(index_oil(y).zero, y); };
  const auto hundred = [&](double y) { return at_40(index_oil(y).hundred, y); };

  Sampler sampler(1535);
  while (table.rows.size() < 60) {
    const std::size_t i = table.rows.size();
    const bool usual = i < 44;
    const double y = usual ? sampler.log_uniform(2e-6, 70e-6) : sampler.log_uniform(2e-6, 1e-2);
    const double u = i % 2 == 0
                         ? hundred(y) + (zero(y) - hundred(y)) * sampler.uniform(0, usual ? 1 : 3)
                         : hundred(y) * sampler.uniform(usual ? 0.5 : 0.2, 1);
    if (u > 1.05 * y) add(u, y, usual ? "ordinary" : "far");
  }
  // Y a little below, at and a little above the ends of the ranges; index below and above 100.
  add(7e-6, 2e-6, "ordinary");
  add(5e-6, 2e-6, "ordinary");
  add(7e-6, 2.000000002e-6, "ordinary");
  for (std::size_t i = 0; i + 1 < index_oils.size(); ++i) {
    const double end = index_oils[i].end;
    for (const double y : {end * (1 - 1e-9), end, end * (1 + 1e-9)}) {
      add((hundred(end) + zero(end)) / 2, y, "ordinary");
      add(0.85 * hundred(end), y, "ordinary");
    }
  }
  for (const double y : {4e-6, 8e-6, 70e-6, 100e-6})
    for (const double part : {1 - 1e-9, 1., 1 + 1e-9}) add(hundred(y) * part, y, "ordinary");
  for (const Numbers& x : steps({46e-6, 6.8e-6}, {52e-6, 8.5e-6})) add(x[0], x[1], "ordinary");
  for (const auto& [y, index] : {std::pair{5e-6, -40.}, {12e-6, -1.}, {8e-6, -99.}})
    add(zero(y) - index / 100 * (zero(y) - hundred(y)), y, "end");
  add(0.36 * hundred(8e-6), 8e-6, "end");  // next to 400
  return table;
}

Table summits_of_moments() {
  Table table{{"summits_from_spectral_moments",
               "alpha = m0 m4/m2^2, n = m4/(6 pi sqrt3 m2), beta = 3/8 sqrt(pi/m4), sigma_s^2 = "
               "(1 - 0.8968/alpha) m0, offset 4 sqrt(m0/(pi alpha))/sigma_s",
               "1, 1/m2, m, m, 1",
               "m0 [1e-18, 1e-10] m2, m2 [1e-6, 1e-1], bandwidth [1.5, 500]; end: m0 [1e-20, "
               "1e-8] m2, m2 [1e-8, 1], bandwidth up to 1000; far: from 0.8968 (1 + 1e-9)",
               "as they are defined", "by m2^2/m4, and squares under one root", "output,m0,m2,m4"},
              "sm"};
  constexpr std::array names{"bandwidth", "summit_density", "summit_radius", "summit_height_sd",
                             "summit_plane_offset"};
  const auto add = [&](const Numbers& numbers, const char* region) {
    for (std::size_t k = 0; k < names.size(); ++k)
      table.add(
          {names[k]}, numbers, [=](const Balls& x) { return summits(k, x); },
          [=](const Balls& x) { return summits_by_squares(k, x); }, region);
  };
  Sampler sampler(1534);
  for (int i = 0; i < 32; ++i) {
    const bool usual = i < 24;
    const double m0 = sampler.log_uniform(1e-18, 1e-10), m2 = sampler.log_uniform(1e-6, 1e-1);
    const double bandwidth =
        usual ? sampler.log_uniform(1.5, 500) : 0.8968 * (1 + sampler.log_uniform(1e-9, 0.5));
    const double m4 = bandwidth * m2 * m2 / m0;
    add({m0, m2, m4}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({4e-15, 3e-4, 1e8}, {9e-15, 5e-4, 2e8})) add(x, "ordinary");
  for (const Numbers& x : {Numbers{1e-20, 1e-4, 1e13},
                           {1e-8, 1e-2, 1e5},
                           {1e-18, 1e-8, 1e3},
                           {1e-12, 1, 1e13},
                           {1e-14, 3e-7, 100},
                           {1e-18, 3e-2, 1e16},
                           {4e-15, 3e-4, 1.5 / next_to_end * 2.25e7},
                           {4e-15, 3e-4, 1000 * next_to_end * 2.25e7}})
    add(x, "end");
  return table;
}

}  // namespace

std::vector<Table> liquids() {
  return {densities(),           temperature_viscosities(), viscosity_indices(),
          summits_of_moments(),  barus_viscosities(),       roelands_viscosities(),
          thinning_viscosities()};
}

}  // namespace tribo::reference
