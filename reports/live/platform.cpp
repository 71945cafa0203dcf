// SPDX-License-Identifier: Apache-2.0
// The functions that the engine otherwise takes from SLEEF and Highway, for WebAssembly, which has
// neither library. The elementary functions are those of its C library (musl; errors below 1 ulp,
// as with SLEEF), and the instruction set is the one that the file was compiled for.
#include <hwy/targets.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

extern "C" {
double Sleef_cinz_expd1_u10purec(double x) { return std::exp(x); }
double Sleef_cinz_expm1d1_u10purec(double x) { return std::expm1(x); }
double Sleef_cinz_logd1_u10purec(double x) { return std::log(x); }
double Sleef_cinz_logd1_u35purec(double x) { return std::log(x); }
double Sleef_cinz_log1pd1_u10purec(double x) { return std::log1p(x); }
double Sleef_cinz_atand1_u35purec(double x) { return std::atan(x); }
}

namespace hwy {
int64_t SupportedTargets() { return HWY_TARGETS; }
void SetSupportedTargetsForTest(int64_t) {}
ChosenTarget& GetChosenTarget() {
  static ChosenTarget chosen;
  return chosen;
}
}  // namespace hwy

// Decimals by the C library, in place of the C++ library's functions, which bring 100 kB of tables.
_LIBCPP_BEGIN_NAMESPACE_STD
namespace {
to_chars_result put(char* first, char* last, string_view text) {
  if (static_cast<size_t>(last - first) < text.size()) return {last, errc::value_too_large};
  return {first + text.copy(first, text.size()), errc()};
}
}  // namespace

// The fewest digits that read back as the same double, in the shorter form: 20000, 1e+05.
to_chars_result to_chars(char* first, char* last, double x) {
  array<char, 400> scientific{}, fixed{};
  int digits = 0;
  do snprintf(scientific.data(), scientific.size(), "%.*e", digits, x);
  while (strtod(scientific.data(), nullptr) != x && ++digits < 17);
  const string_view short_one = scientific.data();
  const size_t exponent = short_one.find('e');
  if (exponent == string_view::npos) return put(first, last, short_one);
  const int decimals = digits - atoi(scientific.data() + exponent + 1);
  snprintf(fixed.data(), fixed.size(), "%.*f", decimals < 0 ? 0 : decimals, x);
  const string_view plain = fixed.data();
  return put(first, last, plain.size() <= short_one.size() ? plain : short_one);
}
// The model asks for the format `general` alone.
to_chars_result to_chars(char* first, char* last, double x, chars_format, int digits) {
  array<char, 400> text{};
  snprintf(text.data(), text.size(), "%.*g", digits, x);
  return put(first, last, text.data());
}

namespace __itoa {
char* __u64toa(uint64_t number, char* to) noexcept { return to + sprintf(to, "%llu", number); }
char* __u32toa(uint32_t number, char* to) noexcept { return __u64toa(number, to); }
}  // namespace __itoa
_LIBCPP_END_NAMESPACE_STD
