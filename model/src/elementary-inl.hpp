// SPDX-License-Identifier: Apache-2.0
// The elementary functions of the engine, once for each instruction set: SLEEF's deterministic
// variants, which give the same bits for one lane and for a vector of any length. Those with fused
// multiply-add are named finz, those without it cinz. Error: 1 ulp each.
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

// For a lane or two, and for a whole vector; sleef.h declares those of the compiler's default
// instruction set alone. Its functions of one double round in the current rounding mode where those
// of vectors round to nearest, and lose digits in other modes; Highway's targets without
// instructions of their own have nothing else.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
#define TRIBO_SLEEF_FEW(name, error) Sleef_finz_##name##d2_##error##avx2128
#define TRIBO_SLEEF_MANY(name, error) Sleef_finz_##name##d8_##error##avx512f
#elif HWY_TARGET == HWY_AVX2
#define TRIBO_SLEEF_FEW(name, error) Sleef_finz_##name##d2_##error##avx2128
#define TRIBO_SLEEF_MANY(name, error) Sleef_finz_##name##d4_##error##avx2
#elif HWY_TARGET == HWY_SSE4
#define TRIBO_SLEEF_FEW(name, error) Sleef_cinz_##name##d2_##error##sse4
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

// x^{p/q}, x ≥ 0, |p| and q below 2000, |p/q| ≤ 2. With x = 2^e m, √½ ≤ m < √2, and ep = kq + r,
// |r| ≤ q/2, it is 2^k exp((p ln m + r ln 2)/q), whose argument is small: the rounding of an
// exponent or of ln x costs nothing. Error: 3 ulp.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V decimal_power(D d, V x, const Fraction& exponent) {
  const hn::RebindToUnsigned<D> bits;
  const V p = hn::Set(d, double(exponent.p)), q = hn::Set(d, double(exponent.q));
  const auto is_tiny = hn::Lt(x, hn::Set(d, 0x1p-1000));
  const V scaled = hn::IfThenElse(is_tiny, hn::Mul(x, hn::Set(d, 0x1p100)), x);
  constexpr std::uint64_t one = 0x3FF0000000000000, root_of_half = 0x3FE6A09E667F3BCD;
  const auto all = hn::BitCast(bits, scaled);
  const auto biased = hn::ShiftRight<52>(hn::Add(all, hn::Set(bits, one - root_of_half)));
  const V m = hn::BitCast(d, hn::Add(hn::Sub(all, hn::ShiftLeft<52>(biased)), hn::Set(bits, one)));
  // of e + 1023, without a conversion
  const V with_bias = hn::BitCast(d, hn::Or(biased, hn::BitCast(bits, hn::Set(d, 0x1p52))));
  const V bias = hn::IfThenElse(is_tiny, hn::Set(d, 0x1p52 + 1123), hn::Set(d, 0x1p52 + 1023));
  const V ep = hn::Mul(hn::Sub(with_bias, bias), p);
  const V shifter = hn::Set(d, 0x1.8p52);
  const V shifted = hn::Add(hn::Mul(ep, hn::Set(d, 1.0 / exponent.q)), shifter);
  const V r = hn::Sub(ep, hn::Mul(hn::Sub(shifted, shifter), q));
  const V ln_2 = hn::Set(d, 0.69314718055994530942 / exponent.q);
  const V argument = hn::MulAdd(hn::Set(d, double(exponent.p) / exponent.q), rough_logarithm(d, m),
                                hn::Mul(r, ln_2));
  // 2^k in two steps, for where the result is subnormal or near overflow
  const auto k = hn::Sub(hn::BitCast(bits, shifted), hn::BitCast(bits, shifter));
  const auto shift = hn::Set(bits, std::uint64_t{4096});
  const auto first = hn::Sub(hn::ShiftRight<1>(hn::Add(k, shift)), hn::ShiftRight<1>(shift));
  const V power =
      hn::Mul(hn::Mul(exponential(d, argument), two_to(d, first)), two_to(d, hn::Sub(k, first)));
  const auto is_ordinary = hn::And(hn::Gt(x, hn::Zero(d)), hn::Lt(x, hn::Set(d, infinity)));
  if (HWY_LIKELY(hn::AllTrue(d, is_ordinary))) return power;
  const V at_ends = exponent.p > 0 ? x : hn::Div(hn::Set(d, 1.0), x);
  return hn::IfThenElse(is_ordinary, power, at_ends);
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
