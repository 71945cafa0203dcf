// SPDX-License-Identifier: Apache-2.0
#include "generators/moments.hpp"
#include "generators/sampler.hpp"
#include "generators/table.hpp"

namespace tribo::reference {
namespace {

struct Argument {
  double value;
  const char* region;
};

// Arguments dense in the middle, log-spaced towards 0 on both sides, next to edges, worst cases.
std::vector<Argument> arguments() {
  std::vector<Argument> all;
  for (int i = -40; i <= 40; ++i) all.push_back({static_cast<double>(i), "dense"});
  Sampler sampler(101);
  for (int i = 0; i < 240; ++i) all.push_back({sampler.uniform(-12, 12), "dense"});
  for (int i = 0; i < 120; ++i) all.push_back({sampler.uniform(-40, 40), "dense"});
  for (int e = -300; e < 0; e += e < -20 ? 40 : 2) {
    const double x = std::ldexp(1.0, e);
    all.push_back({x, "near_zero"});
    all.push_back({-x, "near_zero"});
  }
  // Places where implementations change pieces, series or signs.
  for (const double edge : {0.5, 1.0, 2.0, 3.0, 5.0, 8.0, 9.0, 10.0, 13.0, 16.0, 29.0, 32.0, 37.0})
    for (const double sign : {-1.0, 1.0})
      for (const double towards : {0.0, 100.0})
        all.push_back({std::nextafter(sign * edge, towards), "branch"});
  // Places where other methods failed: rounded d², too short quadrature, subnormal results.
  for (const double d : {32.27553, 0.775, 36.6, 37.3, 37.5, 38.0, 38.4, 0x1.02336f3a2a1c6p+5, 37.4,
                         37.6, 34.524, 8.49, 35.999999})
    all.push_back({d, "worst"});
  return all;
}

// |d F′/F|. For n > 0 it is n|d| F_{n−1}/F_n with nF_{n−1} = F_{n+1} + dF_n; this sum cancels only
// where the condition is small. For n = 0 it is |d| times the normal density over F_0.
Ball condition(int twice_n, const Ball& d, const Ball& value) {
  if (twice_n == 0) return abs(d) * exp(-d * d / 2) / sqrt(2 * ball_pi()) / value;
  return abs(d) * (moment_by_hypergeometric(twice_n + 2, d) + d * value) / value;
}

}  // namespace

std::vector<Table> gaussian_moments() {
  Table table{{"gaussian_moment", "F_n(d) = int_d^inf (s-d)^n exp(-s^2/2)/sqrt(2 pi) ds",
               "dimensionless", "order n = 0, 1/2, 1, 3/2, 2, 5/2; argument d in [-40, 40]",
               "confluent hypergeometric functions (Arb)",
               "rigorous Gauss-Legendre quadrature with a bounded tail (Arb)", "order,argument"},
              "m"};
  for (int twice_n = 0; twice_n < 6; ++twice_n)
    for (const Argument& at : arguments())
      table.add([=] {
        const Ball d(at.value);
        const Ball value = moment_by_hypergeometric(twice_n, d);
        return Row{{},
                   {0.5 * twice_n, at.value},
                   value,
                   moment_by_quadrature(twice_n, d),
                   condition(twice_n, d, value),
                   at.region};
      });
  return {table};
}

}  // namespace tribo::reference
