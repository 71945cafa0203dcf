// SPDX-License-Identifier: Apache-2.0
// The judgement on a number. A failing check prints the inputs as decimal and hexfloat, the
// expected and the given number, the error in ulp, the condition number, the bound, and the factor
// by which it was missed.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "sampling/sampler.hpp"
#include "support/case_count.hpp"

namespace tribo::verification {

// The number type of the model's templates in 50 digits. MPFR's arithmetic is compiled already, so
// that tests compile faster than with a number type of headers alone.
using Reference = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

struct Input {
  std::string_view name;
  double value;
};

inline std::string describe(std::initializer_list<Input> inputs) {
  std::string text;
  for (const Input& input : inputs)
    text += fmt::format("\n  {} = {} ({:a})", input.name, input.value, input.value);
  return text;
}

template <class Real>
std::string text_of(const Real& number) {
  if constexpr (std::is_floating_point_v<Real>)
    return fmt::format("{} ({:a})", number, number);
  else
    return number.str(50);
}

template <class Real>
double relative_error(Real got, const Reference& expected) {
  using std::isfinite;
  if (Reference(got) == expected) return 0;
  if (!isfinite(got) || expected == 0) return std::numeric_limits<double>::infinity();
  return static_cast<double>(abs((Reference(got) - expected) / expected));
}

// |got − expected| ≤ bound·condition·|expected|; `bound` is relative, `condition` ≥ 1.
template <class Real>
testing::AssertionResult is_close(Real got, const Reference& expected, double bound,
                                  std::initializer_list<Input> inputs, double condition = 1) {
  const double error = relative_error(got, expected);
  record_part_of_bound(error / (bound * condition));
  if (error <= bound * condition) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << describe(inputs) << "\n  expected "
         << expected.str(std::is_floating_point_v<Real> ? 25 : 50) << "\n  got      "
         << text_of(got)
         << fmt::format(
                "\n  error {:.3g} relative, {:.3g} ulp; condition {:.3g}; bound {:.3g}; "
                "missed by a factor {:.3g}",
                error, error / static_cast<double>(std::numeric_limits<Real>::epsilon()), condition,
                bound * condition, error / (bound * condition));
}

// |got − expected| ≤ tolerance, in the unit of the two; for printed numbers, half a unit of the
// last digit. Like EXPECT_NEAR, but counted as a case (see main.cpp).
inline testing::AssertionResult is_within(double got, double expected, double tolerance) {
  record_part_of_bound(std::abs(got - expected) / tolerance);
  if (std::abs(got - expected) <= tolerance) return testing::AssertionSuccess();
  return testing::AssertionFailure() << fmt::format(
             "\n  expected {} ({:a}) to within {:.3g}\n  got      {} ({:a}), off by {:.3g}",
             expected, expected, tolerance, got, got, got - expected);
}

}  // namespace tribo::verification
