// SPDX-License-Identifier: Apache-2.0
#include "sweep/arithmetic.hpp"

#define XXH_INLINE_ALL
#include <gnu/libc-version.h>
#include <xxhash.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "tribo/batch.hpp"

namespace tribo::sweep {

std::string arithmetic() {
  std::vector<double> values;
  for (int i = 1; i <= 500; ++i) {
    const double x = 0.0137 * i;
    for (const double value :
         {std::exp(-x), std::expm1(x), std::log(x), std::log1p(x), std::pow(x, 0.67), std::cbrt(x),
          std::atan(x), std::asinh(x), std::erfc(x), std::sin(x), std::tanh(x)})
      values.push_back(value);
  }
  const std::uint64_t sum = XXH3_64bits(values.data(), values.size() * sizeof(double));
  std::string text =
      std::string(is_fused() ? "FMA" : "no FMA") + ", libm " + gnu_get_libc_version() + ' ';
  constexpr std::string_view digits = "0123456789abcdef";
  for (int shift = 28; shift >= 0; shift -= 4) text += digits[(sum >> shift) & 15];
  return text;
}

}  // namespace tribo::sweep
