// SPDX-License-Identifier: Apache-2.0
// F_n and S_n in double (gaussian_moment.hpp): polynomials in pieces (gaussian_moment_pieces.inc),
// and e^{−d²/2} from d² unrounded. What is rounded is carried along as a second double until the
// last operation, so that the result is off by little more than half a unit. The text is compiled
// twice, with and without fused multiply-add, and chosen at run time; both keep the contract.
#include <bit>
#include <cstdint>

#include "gaussian_moment_scalar.hpp"
#include "processor.hpp"

namespace tribo {
namespace {

using namespace scalar;

// scale·S·e^{−d²/2} for 0 ≤ d < pieces_end.
template <class Arithmetic>
[[gnu::always_inline]] inline double times_gaussian(Sum s, double d) {
  constexpr double steps = 128;  // to a factor 2
  // ln 2/128 in two parts, the first with 34 bits: its multiples here are exact.
  constexpr double step_high = 0x1.62e42fefp-8, step_low = 0x1.473de6af278edp-41;
  const Sum square = Arithmetic::product(d, d);
  const double half = 0.5 * square.high;
  constexpr double shifter = 0x1.8p52;
  const double shifted = half * (steps / 0.69314718055994530942) + shifter;
  const double k = shifted - shifter;
  const auto whole = std::bit_cast<std::uint64_t>(shifted) - std::bit_cast<std::uint64_t>(shifter);
  const double r = Arithmetic::multiply_add(-k, step_high, half) +
                   Arithmetic::multiply_add(-k, step_low, 0.5 * square.low);
  // e^{−r} − 1, |r| < 0.0028, and what the power of two is short of
  const double* power = powers_of_two[whole % 128];
  const double r2 = r * r;
  const double upper = Arithmetic::multiply_add(r, -1.0 / 120, 1.0 / 24);
  const double lower = Arithmetic::multiply_add(r, -1.0 / 6, 0.5);
  const double p =
      Arithmetic::multiply_add(Arithmetic::multiply_add(upper, r2, lower), r2, power[1]) - r;
  // power (1 + p)(high + low), of which all but power·high is small
  const double small = Arithmetic::multiply_add(power[0], s.low, (s.high + s.low) * (power[0] * p));
  const double value = Arithmetic::product_and_sum(power[0], s.high, small);
  const auto exponent = static_cast<std::int64_t>(whole / 128);
  // 2^−exponent; in two steps where that, or the result, is subnormal.
  if (exponent < 900)
    return value * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  return value * 0x1p-700 *
         std::bit_cast<double>(static_cast<std::uint64_t>(1023 - (exponent - 700)) << 52);
}

// F_n(−x) for x ≥ pieces_end: xⁿ (1 + n(n−1)/(2x²) + …), the second factor to far below an ulp.
template <class Arithmetic>
[[gnu::noinline, gnu::cold]] double far_below_zero(Order n, double x) {
  const double plain = detail::power(x, n);
  if (!(plain < 1e300)) return plain;  // so near overflow two products would lose their low parts
  const double order = 0.5 * twice(n);
  const double u = 0.5 / (x * x);  // < 2.5e-4
  double series = 1;
  for (int k = 6; k >= 2; --k)
    series = 1 + (order - (2 * k - 2)) * (order - (2 * k - 1)) * u / k * series;
  series *= order * (order - 1) * u;
  Sum power = twice(n) < 2 ? Sum{1, 0} : twice(n) < 4 ? Sum{x, 0} : Arithmetic::product(x, x);
  if (!is_integer(n)) {
    const double root = __builtin_sqrt(x);
    const Sum square = Arithmetic::product(root, root);
    const double root_low = ((x - square.high) - square.low) / (2 * root);
    const Sum next = Arithmetic::product(power.high, root);
    power = ordered_sum(next.high, next.low + power.low * root + power.high * root_low);
  }
  return power.high + (power.low + power.high * series);
}

[[gnu::always_inline]] inline double total(const Sum& sum) { return sum.high + sum.low; }

template <class Arithmetic>
[[gnu::always_inline]] inline double scaled_moment(Order n, double d) {
  if (d >= 0) {
    if (d < pieces_end) return total(in_pieces<Arithmetic>(n, false, d));
    return static_cast<double>(detail::far_above(n, static_cast<WiderType<double>>(d)));
  }
  if (d > -pieces_end) return total(in_pieces<Arithmetic>(n, true, -d));
  return d == d ? far_below_zero<Arithmetic>(n, -d) : d;
}

template <class Arithmetic>
[[gnu::always_inline]] inline double moment(Order n, double d) {
  if (d >= 0)
    return d < 40 ? times_gaussian<Arithmetic>(in_pieces<Arithmetic>(n, false, d), d) : 0.0;
  if (d > -pieces_end) return total(in_pieces<Arithmetic>(n, true, -d));
  return d == d ? far_below_zero<Arithmetic>(n, -d) : d;
}

[[gnu::target("fma")]] double scaled_moment_fused(Order n, double d) {
  return scaled_moment<Fused>(n, d);
}
double scaled_moment_unfused(Order n, double d) { return scaled_moment<Unfused>(n, d); }
[[gnu::target("fma")]] double moment_fused(Order n, double d) { return moment<Fused>(n, d); }
double moment_unfused(Order n, double d) { return moment<Unfused>(n, d); }

// Until the processor has been asked, which happens before main, the choice is the one that runs
// everywhere.
constinit auto chosen_scaled_moment = &scaled_moment_unfused;
constinit auto chosen_moment = &moment_unfused;
[[maybe_unused]] const bool has_chosen = [] {
  if (detail::has_fma()) {
    chosen_scaled_moment = &scaled_moment_fused;
    chosen_moment = &moment_fused;
  }
  return true;
}();

}  // namespace

double scaled_gaussian_moment(Order n, double d) { return chosen_scaled_moment(n, d); }
double gaussian_moment(Order n, double d) { return chosen_moment(n, d); }

namespace detail {

double scaled_gaussian_moment_unfused(Order n, double d) { return scaled_moment_unfused(n, d); }
double gaussian_moment_unfused(Order n, double d) { return moment_unfused(n, d); }

}  // namespace detail

}  // namespace tribo
