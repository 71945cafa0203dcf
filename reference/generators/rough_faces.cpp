// SPDX-License-Identifier: Apache-2.0
// Rough faces: plasticity, a summit that yields, the area of contact, flow, and the lambda ratio.
#include <arb_hypgeom.h>

#include "generators/sampler.hpp"
#include "generators/table.hpp"
#include "generators/zeros.hpp"

namespace tribo::reference {
namespace {

Table plasticity_indices() {
  Table table{
      {"plasticity_index", "psi = (E*/H) sqrt(sigma_s/beta)", "dimensionless",
       "E* [1e5, 1e12] Pa, H [1e5, 1e11] Pa, sigma_s [1e-10, 1e-4] m, beta [1e-8, 0.1] m; "
       "far: [1e-60, 1e60] each",
       "a square root", "logarithms", "effective_modulus,hardness,summit_height_sd,summit_radius"},
      "rp"};
  const auto add = [&table](const Numbers& numbers, const char* region) {
    table.add(
        {}, numbers, [](const Balls& x) { return x[0] / x[1] * sqrt(x[2] / x[3]); },
        [](const Balls& x) { return exp(log(x[0]) - log(x[1]) + (log(x[2]) - log(x[3])) / 2); },
        region);
  };
  Sampler sampler(1550);
  for (int i = 0; i < 40; ++i) {
    const bool usual = i < 30;
    const auto pick = [&](double low, double high) {
      return usual ? sampler.log_uniform(low, high) : sampler.log_uniform(1e-60, 1e60);
    };
    const double modulus = pick(1e5, 1e12), hardness = pick(1e5, 1e11);
    const double height = pick(1e-10, 1e-4);
    add({modulus, hardness, height, pick(1e-8, 0.1)}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({1.1e11, 3e9, 1e-7, 5e-5}, {1.6e11, 7e9, 3e-7, 9e-5}))
    add(x, "ordinary");
  for (const Numbers& x :
       at_ends({1.1e11, 3e9, 1e-7, 5e-5},
               {{0, 1e5, 1e12}, {1, 1e5, 1e11}, {2, 1e-10, 1e-4}, {3, 1e-8, 0.1}}))
    add(x, "end");
  return table;
}

// The branch is chosen by the double, so that no comparison of balls is undecided.
Ball kogut_etsion(double interference, const Ball& x) {
  if (interference < 1) return pow(x, fraction(3, 2));
  if (interference < 6) return fraction(103, 100) * pow(x, fraction(1425, 1000));
  return fraction(7, 5) * pow(x, fraction(1263, 1000));
}
Ball kogut_etsion_by_roots(double interference, const Ball& x) {
  const auto root = [&](int p, int q) {
    return zero_between([&](const Ball& y) { return pow(y, Ball(q)) - pow(x, Ball(p)); },
                        pow(Ball(2), Ball(-2000)), pow(Ball(2), Ball(2000)));
  };
  if (interference < 1) return root(3, 2);
  if (interference < 6) return root(57, 40) * 103 / 100;
  return root(1263, 1000) * 14 / 10;
}

Table yielding_summits() {
  Table table{{"kogut_etsion_load",
               "F/F_c = x^1.5 below 1, 1.03 x^1.425 from 1 to 6, 1.40 x^1.263 from 6 to 110",
               "dimensionless", "x [1e-3, 100], both sides of 1 and of 6; far: from 1e-100, to 110",
               "powers", "bisection on whole powers", "interference_ratio"},
              "rk"};
  const auto add = [&table](double x, const char* region) {
    table.add(
        {}, {x}, [=](const Balls& y) { return kogut_etsion(x, y[0]); },
        [=](const Balls& y) { return kogut_etsion_by_roots(x, y[0]); }, region);
  };
  Sampler sampler(1551);
  for (int i = 0; i < 48; ++i) {
    const double low = i % 3 == 0 ? 1e-3 : i % 3 == 1 ? 1.001 : 6.001;
    const double high = i % 3 == 0 ? 0.999 : i % 3 == 1 ? 5.999 : 100;
    add(sampler.log_uniform(low, high), "ordinary");
  }
  for (const double step : {1., 6.})
    for (const double part : {1 - 1e-6, 1 + 1e-6}) add(step * part, "ordinary");
  add(1e-3, "end");
  add(100, "end");
  for (const double x : {1e-100, 1e-30, 1e-6, 104., 110.}) add(x, "far");
  return table;
}

// erf by FLINT, and by its series of positive terms, 2x/sqrt(pi) e^(-x^2) sum (2x^2)^n/(2n + 1)!!.
Ball erf(const Ball& x) {
  Ball result;
  arb_hypgeom_erf(result.get(), x.get(), ball_precision);
  return result;
}
Ball erf_by_series(const Ball& x) {
  const Ball twice = 2 * x * x;
  Ball term = 1, sum = 1;
  int n = 1;
  for (; term > sum * pow(Ball(2), Ball(-250)) || 2 * twice > 2 * n + 1; ++n) {
    term = term * twice / (2 * n + 1);
    sum += term;
  }
  arb_add_error(sum.get(), term.get());  // each further term is at most half of the one before
  return 2 * x / sqrt(ball_pi()) * exp(-x * x) * sum;
}

Table contact_areas() {
  Table table{{"persson_contact_area", "A/A0 = erf(sqrt2 p/(E* h'))", "dimensionless",
               "E* [1e5, 1e12] Pa, h' [1e-3, 1], p/(E* h') [1e-6, 1.5]; end: p [1, 1e10] Pa, h' "
               "[1e-4, 2], p/(E* h') from 1e-9; far: p/(E* h') [1e-100, 4]",
               "confluent hypergeometric function", "a series of positive terms",
               "pressure,effective_modulus,rms_gradient"},
              "ra"};
  const auto add = [&table](const Numbers& numbers, const char* region) {
    table.add(
        {}, numbers, [](const Balls& x) { return erf(sqrt(Ball(2)) * x[0] / (x[1] * x[2])); },
        [](const Balls& x) { return erf_by_series(x[0] / x[1] / x[2] * 2 / sqrt(Ball(2))); },
        region);
  };
  Sampler sampler(1552);
  for (int i = 0; i < 50; ++i) {
    const bool usual = i < 40;
    const double modulus = sampler.log_uniform(1e5, 1e12), gradient = sampler.log_uniform(1e-3, 1);
    const double relative = usual ? sampler.log_uniform(1e-6, 1.5) : sampler.log_uniform(1e-100, 4);
    add({relative * modulus * gradient, modulus, gradient}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({1e7, 1e9, 0.1}, {2e7, 1.4e9, 0.15})) add(x, "ordinary");
  for (const Numbers& x : {Numbers{1, 1e5, 0.1},
                           {1e10, 1e12, 0.1},
                           {1e3, 1e5, 0.1},
                           {1e10, 1e12, 0.5},
                           {1e4, 1e9, 1e-4},
                           {1e7, 1e9, 2},
                           {next_to_end * 1.5e8, 1e9, 0.1},
                           {1e-9 / next_to_end * 1e11, 1e12, 0.1}})
    add(x, "end");
  return table;
}

Table flow_factors() {
  Table table{{"patir_cheng_pressure_flow", "1 - 0.90 exp(-0.56 H)", "dimensionless",
               "H [0.5, 20]; far: [1e-30, 1e3]", "exponential", "a power of e^0.56 in the divisor",
               "film_ratio"},
              "rf"};
  const auto add = [&table](double h, const char* region) {
    table.add(
        {}, {h},
        [](const Balls& x) { return 1 - fraction(9, 10) * exp(-fraction(56, 100) * x[0]); },
        [](const Balls& x) {
          const Ball power = pow(exp(fraction(14, 25)), x[0]);
          return (10 * power - 9) / (10 * power);
        },
        region);
  };
  Sampler sampler(1553);
  for (int i = 0; i < 40; ++i)
    add(i < 32 ? sampler.log_uniform(0.5, 20) : sampler.log_uniform(1e-30, 1e3),
        i < 32 ? "ordinary" : "far");
  add(0.5, "end");
  add(20, "end");
  return table;
}

Table lambda_ratios() {
  Table table{{"lambda_ratio", "Rq^2 = Rq1^2 + Rq2^2, Lambda = h_min/Rq", "m, 1",
               "h_min [1e-10, 1e-3] m, Rq1 and Rq2 [1e-10, 1e-4] m; far: [1e-100, 1e100] m each",
               "a sum of squares", "by the ratio of both",
               "output,minimum_film,first_roughness,second_roughness"},
              "rl"};
  const auto add = [&table](const Numbers& numbers, const char* region) {
    for (const bool is_lambda : {false, true})
      table.add(
          {is_lambda ? "lambda_ratio" : "composite_roughness"}, numbers,
          [=](const Balls& x) {
            const Ball rough = sqrt(x[1] * x[1] + x[2] * x[2]);
            return is_lambda ? x[0] / rough : rough;
          },
          [=](const Balls& x) {
            const Ball part = x[2] / x[1], stretched = sqrt(1 + part * part);
            return is_lambda ? x[0] / x[1] / stretched : x[1] * stretched;
          },
          region);
  };
  Sampler sampler(1554);
  for (int i = 0; i < 30; ++i) {
    const bool usual = i < 24;
    const auto pick = [&](double low, double high) {
      return usual ? sampler.log_uniform(low, high) : sampler.log_uniform(1e-100, 1e100);
    };
    const double film = pick(1e-10, 1e-3), rough = pick(1e-9, 1e-5);
    const double other = usual ? rough * sampler.log_uniform(0.1, 10) : pick(1, 1);
    add({film, rough, other}, usual ? "ordinary" : "far");
  }
  for (const Numbers& x : steps({3e-7, 2e-7, 1e-7}, {5e-7, 3e-7, 2.5e-7})) add(x, "ordinary");
  for (const Numbers& x : {Numbers{1e-10, 2e-7, 1e-7},
                           {1e-3, 2e-7, 1e-7},
                           {3e-7, 1e-10, 1e-10},
                           {3e-7, 1e-4, 1e-4},
                           {3e-7, 3e-10, 1e-10},
                           {3e-7, 7e-5, 1e-4}})
    add(x, "end");
  return table;
}

}  // namespace

std::vector<Table> rough_faces() {
  return {plasticity_indices(), yielding_summits(), contact_areas(), flow_factors(),
          lambda_ratios()};
}

}  // namespace tribo::reference
