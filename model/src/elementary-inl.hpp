// SPDX-License-Identifier: Apache-2.0
// The elementary functions of the engine, once for each instruction set: SLEEF's deterministic
// variants, which give the same bits for one lane and for a vector of any length. Those with fused
// multiply-add are named finz, those without it cinz. Error: 1 ulp each where the name ends in u10,
// 3.5 ulp where it ends in u35.
#include <hwy/highway.h>

#include <cstdint>
#include <limits>

#include "tribo/real.hpp"

#if defined(TRIBO_ELEMENTARY) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_ELEMENTARY
#undef TRIBO_ELEMENTARY
#else
#define TRIBO_ELEMENTARY
#endif

// SLEEF's functions for one or two lanes (FEW), for a whole vector (MANY), and for one double
// (ONE). sleef.h declares only those of the compiler's default instruction set. The functions of
// one double round in the current rounding mode, and lose digits in modes other than to nearest;
// the functions of vectors always round to nearest. The other targets of Highway have only the
// functions of one double.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
#define TRIBO_SLEEF_FEW(name, error) Sleef_finz_##name##d2_##error##avx2128
#define TRIBO_SLEEF_MANY(name, error) Sleef_finz_##name##d8_##error##avx512f
#elif HWY_TARGET == HWY_AVX2
#define TRIBO_SLEEF_FEW(name, error) Sleef_finz_##name##d2_##error##avx2128
#define TRIBO_SLEEF_MANY(name, error) Sleef_finz_##name##d4_##error##avx2
#elif HWY_TARGET == HWY_SSE4
#define TRIBO_SLEEF_FEW(name, error) Sleef_cinz_##name##d2_##error##sse4
#elif HWY_TARGET == HWY_NEON
#define TRIBO_SLEEF_FEW(name, error) Sleef_finz_##name##d2_##error##advsimd
#else
#define TRIBO_SLEEF_ONE(name, error) Sleef_cinz_##name##d1_##error##purec
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

#if defined(TRIBO_SLEEF_MANY)
using Raw = decltype(hn::Vec<hn::ScalableTag<double>>().raw);
#endif

// function(x) of each lane by SLEEF's `name`.
#if defined(TRIBO_SLEEF_MANY)
#define TRIBO_ELEMENTARY_FUNCTION(function, name, error)       \
  extern "C" __m128d TRIBO_SLEEF_FEW(name, error)(__m128d);    \
  extern "C" Raw TRIBO_SLEEF_MANY(name, error)(Raw);           \
  template <class D>                                           \
  HWY_INLINE hn::Vec<D> function(D, hn::Vec<D> x) {            \
    if constexpr (hn::MaxLanes(D()) <= 2)                      \
      return hn::Vec<D>{TRIBO_SLEEF_FEW(name, error)(x.raw)};  \
    else                                                       \
      return hn::Vec<D>{TRIBO_SLEEF_MANY(name, error)(x.raw)}; \
  }
#elif HWY_TARGET == HWY_NEON  // one lane is half of a register
#define TRIBO_ELEMENTARY_FUNCTION(function, name, error)                                         \
  extern "C" float64x2_t TRIBO_SLEEF_FEW(name, error)(float64x2_t);                              \
  template <class D>                                                                             \
  HWY_INLINE hn::Vec<D> function(D, hn::Vec<D> x) {                                              \
    if constexpr (hn::MaxLanes(D()) == 1)                                                        \
      return hn::Vec<D>{vget_low_f64(TRIBO_SLEEF_FEW(name, error)(vcombine_f64(x.raw, x.raw)))}; \
    else                                                                                         \
      return hn::Vec<D>{TRIBO_SLEEF_FEW(name, error)(x.raw)};                                    \
  }
#elif defined(TRIBO_SLEEF_FEW)
#define TRIBO_ELEMENTARY_FUNCTION(function, name, error)    \
  extern "C" __m128d TRIBO_SLEEF_FEW(name, error)(__m128d); \
  template <class D>                                        \
  HWY_INLINE hn::Vec<D> function(D, hn::Vec<D> x) {         \
    return hn::Vec<D>{TRIBO_SLEEF_FEW(name, error)(x.raw)}; \
  }
#else
#define TRIBO_ELEMENTARY_FUNCTION(function, name, error)                  \
  extern "C" double TRIBO_SLEEF_ONE(name, error)(double);                 \
  template <class D>                                                      \
  HWY_INLINE hn::Vec<D> function(D d, hn::Vec<D> x) {                     \
    HWY_ALIGN double lanes[hn::MaxLanes(D())];                            \
    hn::Store(x, d, lanes);                                               \
    for (double& lane : lanes) lane = TRIBO_SLEEF_ONE(name, error)(lane); \
    return hn::Load(d, lanes);                                            \
  }
#endif

TRIBO_ELEMENTARY_FUNCTION(exponential, exp, u10)              // e^x
TRIBO_ELEMENTARY_FUNCTION(exponential_less_one, expm1, u10)   // e^x − 1
TRIBO_ELEMENTARY_FUNCTION(logarithm, log, u10)                // ln x
TRIBO_ELEMENTARY_FUNCTION(rough_logarithm, log, u35)          // ln x to 3.5 ulp
TRIBO_ELEMENTARY_FUNCTION(logarithm_of_one_plus, log1p, u10)  // ln(1 + x)
TRIBO_ELEMENTARY_FUNCTION(arc_tangent, atan, u35)             // arctan x to 3.5 ulp
#undef TRIBO_ELEMENTARY_FUNCTION
#undef TRIBO_SLEEF_ONE
#undef TRIBO_SLEEF_FEW
#undef TRIBO_SLEEF_MANY

// 2^k for integers |k| ≤ 1022 in two's complement.
template <class D>
HWY_INLINE hn::Vec<D> two_to(D d, hn::Vec<hn::RebindToUnsigned<D>> k) {
  const hn::RebindToUnsigned<D> bits;
  return hn::BitCast(d, hn::ShiftLeft<52>(hn::Add(k, hn::Set(bits, std::uint64_t{1023}))));
}

// x = 2^e m, √½ ≤ m < √2, of x > 0.
template <class V>
struct Binary {
  V exponent, mantissa;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE Binary<V> binary_of(D d, V x) {
  const hn::RebindToUnsigned<D> bits;
  const auto is_tiny = hn::Lt(x, hn::Set(d, 0x1p-1000));
  const V scaled = hn::IfThenElse(is_tiny, hn::Mul(x, hn::Set(d, 0x1p100)), x);
  constexpr std::uint64_t one = 0x3FF0000000000000, root_of_half = 0x3FE6A09E667F3BCD;
  const auto all = hn::BitCast(bits, scaled);
  const auto biased = hn::ShiftRight<52>(hn::Add(all, hn::Set(bits, one - root_of_half)));
  const V m = hn::BitCast(d, hn::Add(hn::Sub(all, hn::ShiftLeft<52>(biased)), hn::Set(bits, one)));
  // e + 1023 as a number, without a conversion
  const V with_bias = hn::BitCast(d, hn::Or(biased, hn::BitCast(bits, hn::Set(d, 0x1p52))));
  const V bias = hn::IfThenElse(is_tiny, hn::Set(d, 0x1p52 + 1123), hn::Set(d, 0x1p52 + 1023));
  return {hn::Sub(with_bias, bias), m};
}

// 2^{n/q} e^x of an integer n, as 2^k exp(x + r ln 2/q) with n = kq + r, |r| ≤ q/2; `of` has q.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V two_to_part_times_exp(D d, V n, const Exponent& of, V x) {
  const hn::RebindToUnsigned<D> bits;
  const V shifter = hn::Set(d, 0x1.8p52);
  const V shifted = hn::MulAdd(n, hn::Set(d, of.inverse_q), shifter);
  const V r = hn::NegMulAdd(hn::Sub(shifted, shifter), hn::Set(d, of.q), n);
  const V argument = hn::MulAdd(r, hn::Set(d, of.log_two_over_q), x);
  // 2^k in two steps, for where the result is subnormal or near overflow
  const auto k = hn::Sub(hn::BitCast(bits, shifted), hn::BitCast(bits, shifter));
  const auto shift = hn::Set(bits, std::uint64_t{4096});
  const auto first = hn::Sub(hn::ShiftRight<1>(hn::Add(k, shift)), hn::ShiftRight<1>(shift));
  return hn::Mul(hn::Mul(exponential(d, argument), two_to(d, first)), two_to(d, hn::Sub(k, first)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> is_positive_and_finite(D d, V x) {
  return hn::And(hn::Gt(x, hn::Zero(d)), hn::Lt(x, hn::Set(d, infinity)));
}

// x^{p/q}, x ≥ 0, |p| and q below 2000, |p/q| ≤ 2: with x = 2^e m the exponential's argument is
// small, so that the rounding of p/q and of ln x costs nothing. Error: 3 ulp.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V decimal_power(D d, V x, const Exponent& exponent) {
  const Binary<V> of = binary_of(d, x);
  const V part = hn::Mul(hn::Set(d, exponent.value), rough_logarithm(d, of.mantissa));
  const V power =
      two_to_part_times_exp(d, hn::Mul(of.exponent, hn::Set(d, exponent.p)), exponent, part);
  const auto is_ordinary = is_positive_and_finite(d, x);
  if (HWY_LIKELY(hn::AllTrue(d, is_ordinary))) return power;
  const V at_ends = exponent.p > 0 ? x : hn::Div(hn::Set(d, 1.0), x);
  return hn::IfThenElse(is_ordinary, power, at_ends);
}

// x^a y^b z^c with such exponents. Error: 3 ulp by one exponential, 10 ε by three powers.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V decimal_powers(D d, V x, const Fraction& a, V y, const Fraction& b, V z,
                            const Fraction& c) {
  constexpr int q = 1000;  // a multiple of all three denominators, but for those of Ertel's law
  if (q % a.q != 0 || q % b.q != 0 || q % c.q != 0)
    return hn::Mul(hn::Mul(decimal_power(d, x, a), decimal_power(d, y, b)), decimal_power(d, z, c));
  V n = hn::Zero(d), part = hn::Zero(d);
  auto is_ordinary = hn::Eq(n, n);
  const auto add = [&](V base, const Fraction& exponent) HWY_ATTR {
    const Binary<V> of = binary_of(d, base);
    const int p = exponent.p * (q / exponent.q);
    n = hn::MulAdd(of.exponent, hn::Set(d, double(p)), n);
    part = hn::MulAdd(rough_logarithm(d, of.mantissa), hn::Set(d, double(p) / q), part);
    is_ordinary = hn::And(is_ordinary, is_positive_and_finite(d, base));
  };
  add(x, a);
  add(y, b);
  add(z, c);
  constexpr Exponent one_thousandth(Fraction{1, q});
  const V power = two_to_part_times_exp(d, n, one_thousandth, part);
  if (HWY_LIKELY(hn::AllTrue(d, is_ordinary))) return power;
  const V one_by_one =
      hn::Mul(hn::Mul(decimal_power(d, x, a), decimal_power(d, y, b)), decimal_power(d, z, c));
  return hn::IfThenElse(is_ordinary, power, one_by_one);
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
