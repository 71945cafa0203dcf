// SPDX-License-Identifier: Apache-2.0
// F_n and S_n in double (gaussian_moment.hpp), once for each instruction set, for one lane and for
// vectors: polynomials in pieces (gaussian_moment_pieces.inc), and e^{−d²/2} from d² unrounded.
// Rounding errors are carried along as a second double until the last operation, so that the result
// is off by little more than half a unit.
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "gaussian_moment_pieces.hpp"

#if defined(TRIBO_GAUSSIAN_MOMENT) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_GAUSSIAN_MOMENT
#undef TRIBO_GAUSSIAN_MOMENT
#else
#define TRIBO_GAUSSIAN_MOMENT
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using Integers = hn::Vec<hn::RebindToUnsigned<D>>;

// A number as the unrounded sum of two.
template <class V>
struct Sum {
  V high, low;
};

// a·b; without fused multiply-add by Dekker's product, |a|, |b| < 2^995.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Sum<V> product([[maybe_unused]] D d, V a, V b) {
  const V high = hn::Mul(a, b);
#if HWY_NATIVE_FMA
  return {high, hn::MulSub(a, b, high)};
#else
  const auto halves = [d](V x) HWY_ATTR {
    const V scaled = hn::Mul(hn::Set(d, 134217729.0), x);
    const V head = hn::Sub(scaled, hn::Sub(scaled, x));
    return Sum<V>{head, hn::Sub(x, head)};
  };
  const Sum<V> x = halves(a), y = halves(b);
  const V first = hn::Sub(hn::Mul(x.high, y.high), high);
  const V second = hn::Add(hn::Add(first, hn::Mul(x.high, y.low)), hn::Mul(x.low, y.high));
  return {high, hn::Add(second, hn::Mul(x.low, y.low))};
#endif
}

// a·b + c, |c| far below |a·b|, rounded once or nearly so.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V product_and_sum(D d, V a, V b, V c) {
  if constexpr (HWY_NATIVE_FMA) return hn::MulAdd(a, b, c);
  const Sum<V> exact = product(d, a, b);
  return hn::Add(exact.high, hn::Add(exact.low, c));
}

// The first `count` numbers of each lane's row; rows are `stride` numbers apart. Whole rows are
// loaded and transposed in registers, which is faster than gathering.
template <std::size_t count, class D, class V = hn::Vec<D>>
HWY_INLINE void load_rows([[maybe_unused]] D d, const double* base, Integers<D> index,
                          V (&numbers)[count], std::size_t stride = count) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  if constexpr (lanes == 1) {
    const double* row = base + hn::GetLane(index) * stride;
    for (std::size_t k = 0; k < count; ++k) numbers[k] = hn::Set(d, row[k]);
  } else {
    constexpr std::size_t paired = count - count % 2;
    const hn::RebindToUnsigned<D> bits;
    HWY_ALIGN std::uint64_t at[lanes];
    hn::Store(index, bits, at);
    const auto row = [&](std::size_t j) HWY_ATTR { return base + at[j] * stride; };
#if HWY_TARGET != HWY_SCALAR
    if constexpr (lanes == 2) {
      for (std::size_t k = 0; k < paired; k += 2) {
        const V first = hn::LoadU(d, row(0) + k), second = hn::LoadU(d, row(1) + k);
        numbers[k] = hn::InterleaveLower(d, first, second);
        numbers[k + 1] = hn::InterleaveUpper(d, first, second);
      }
    }
#endif
#if HWY_TARGET == HWY_AVX2
    // A block of 128 bits has two numbers. They are interleaved, then the blocks are put together.
    if constexpr (lanes == 4 && count % 4 == 0) {
      for (std::size_t k = 0; k < count; k += 4) {
        const V r0 = hn::LoadU(d, row(0) + k), r1 = hn::LoadU(d, row(1) + k);
        const V r2 = hn::LoadU(d, row(2) + k), r3 = hn::LoadU(d, row(3) + k);
        const V even01 = hn::InterleaveLower(d, r0, r1), odd01 = hn::InterleaveUpper(d, r0, r1);
        const V even23 = hn::InterleaveLower(d, r2, r3), odd23 = hn::InterleaveUpper(d, r2, r3);
        numbers[k] = hn::ConcatLowerLower(d, even23, even01);
        numbers[k + 1] = hn::ConcatLowerLower(d, odd23, odd01);
        numbers[k + 2] = hn::ConcatUpperUpper(d, even23, even01);
        numbers[k + 3] = hn::ConcatUpperUpper(d, odd23, odd01);
      }
    } else if constexpr (lanes == 4) {
      for (std::size_t k = 0; k < paired; k += 2) {
        const hn::Half<D> half;
        const auto pair = [&](std::size_t j) HWY_ATTR { return hn::LoadU(half, row(j) + k); };
        const V r02 = hn::Combine(d, pair(2), pair(0)), r13 = hn::Combine(d, pair(3), pair(1));
        numbers[k] = hn::InterleaveLower(d, r02, r13);
        numbers[k + 1] = hn::InterleaveUpper(d, r02, r13);
      }
    }
#elif HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    if constexpr (lanes == 8 && count % 4 == 0) {
      const hn::Half<D> half;
      for (std::size_t k = 0; k < count; k += 4) {
        const auto two = [&](std::size_t i, std::size_t j) HWY_ATTR {
          return hn::Combine(d, hn::LoadU(half, row(j) + k), hn::LoadU(half, row(i) + k));
        };
        const V r02 = two(0, 2), r13 = two(1, 3), r46 = two(4, 6), r57 = two(5, 7);
        const V even0 = hn::InterleaveLower(d, r02, r13), odd0 = hn::InterleaveUpper(d, r02, r13);
        const V even4 = hn::InterleaveLower(d, r46, r57), odd4 = hn::InterleaveUpper(d, r46, r57);
        // Blocks 0 and 2 of both, or 1 and 3.
        numbers[k] = V{_mm512_shuffle_f64x2(even0.raw, even4.raw, 0x88)};
        numbers[k + 1] = V{_mm512_shuffle_f64x2(odd0.raw, odd4.raw, 0x88)};
        numbers[k + 2] = V{_mm512_shuffle_f64x2(even0.raw, even4.raw, 0xDD)};
        numbers[k + 3] = V{_mm512_shuffle_f64x2(odd0.raw, odd4.raw, 0xDD)};
      }
    } else if constexpr (lanes == 8) {
      for (std::size_t k = 0; k < paired; k += 2) {
        const auto pair = [&](std::size_t j) HWY_ATTR { return _mm_loadu_pd(row(j) + k); };
        const auto four = [&](std::size_t j) HWY_ATTR {
          const __m512d low = _mm512_castpd256_pd512(
              _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(j)), pair(j + 2), 1));
          return V{_mm512_insertf64x4(
              low, _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(j + 4)), pair(j + 6), 1), 1)};
        };
        const V even = four(0), odd = four(1);
        numbers[k] = hn::InterleaveLower(d, even, odd);
        numbers[k + 1] = hn::InterleaveUpper(d, even, odd);
      }
    }
#endif
    if constexpr (count > paired) {
      HWY_ALIGN double last[lanes];
      for (std::size_t j = 0; j < lanes; ++j) last[j] = row(j)[paired];
      numbers[paired] = hn::Load(d, last);
    }
  }
}

// The polynomial of each lane's piece, Σ c_k t^k at the distance t of |d| from the piece's centre:
// c_0 high, c_0 low, c_1, …, c_10.
template <class V>
struct Piece {
  V c[piece_numbers];
  V t;
};

// The piece of |d| = x < pieces_end.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Piece<V> piece_at(D d, Order n, hn::Mask<D> below_zero, V x) {
  constexpr int kept = 47;  // bits of x + 3 below those that are the number of its piece
  const hn::RebindToUnsigned<D> bits;
  const auto top = hn::ShiftRight<kept>(hn::BitCast(bits, hn::Add(x, hn::Set(d, 3.0))));
  const auto half = hn::Set(bits, std::uint64_t{1} << (kept - 1));
  const V centre = hn::Sub(hn::BitCast(d, hn::Or(hn::ShiftLeft<kept>(top), half)), hn::Set(d, 3.0));
  constexpr std::uint64_t first = 0x4008000000000000 >> kept;  // of 3.0
  const V other_side = hn::BitCast(d, hn::Set(bits, std::uint64_t{pieces_a_side}));
  const auto side = hn::BitCast(bits, hn::IfThenElseZero(below_zero, other_side));
  Piece<V> piece;
  load_rows(d, pieces[twice(n)][0][0], hn::Add(hn::Sub(top, hn::Set(bits, first)), side), piece.c);
  piece.t = hn::Sub(x, centre);
  return piece;
}

// S_n(d) at |d| = x < pieces_end for d ≥ 0, F_n(d) for d < 0. The low part is at most an eleventh
// of the high part. The error of the sum is the rounding of the low part.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Sum<V> moment_in_pieces(D d, Order n, hn::Mask<D> below_zero, V x) {
  const Piece<V> piece = piece_at(d, n, below_zero, x);
  const V* c = piece.c;
  const V t = piece.t, square = hn::Mul(t, t);
  V odd = c[11], even = c[10];
  for (int k = 9; k >= 3; k -= 2) {
    odd = hn::MulAdd(odd, square, c[k]);
    even = hn::MulAdd(even, square, c[k - 1]);
  }
  return {c[0], hn::MulAdd(t, hn::MulAdd(odd, t, even), c[1])};
}

// The same moment to a few ulp, and its derivative in x over the moment.
template <class V>
struct MomentAndLogSlope {
  V moment, log_slope;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE MomentAndLogSlope<V> moment_and_log_slope(D d, Order n, hn::Mask<D> below_zero, V x) {
  const Piece<V> piece = piece_at(d, n, below_zero, x);
  const V* c = piece.c;
  const V t = piece.t, square = hn::Mul(t, t);
  // E(t²) + t O(t²), and their derivatives in t²
  V even_slope = c[11], odd_slope = c[10];
  V even = hn::MulAdd(c[11], square, c[9]), odd = hn::MulAdd(c[10], square, c[8]);
  for (int k = 7; k >= 3; k -= 2) {
    even_slope = hn::MulAdd(even_slope, square, even);
    odd_slope = hn::MulAdd(odd_slope, square, odd);
    even = hn::MulAdd(even, square, c[k]);
    odd = hn::MulAdd(odd, square, c[k - 1]);
  }
  even_slope = hn::MulAdd(even_slope, square, even);
  even = hn::MulAdd(even, square, c[0]);
  const V moment = hn::MulAdd(odd, t, even);
  const V slope = hn::MulAdd(hn::Add(t, t), hn::MulAdd(odd_slope, t, even_slope), odd);
  return {moment, hn::Div(slope, moment)};
}

// s·e^{−part·x²}, part a half or a quarter, part·x² ≤ 1410.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V times_gaussian(D d, Sum<V> s, V x, double part = 0.5) {
  const hn::RebindToUnsigned<D> bits;
  // ln 2/128 in two parts, the first with 34 bits: its multiples here are exact.
  const V step_high = hn::Set(d, 0x1.62e42fefp-8), step_low = hn::Set(d, 0x1.473de6af278edp-41);
  const V half = hn::Set(d, 0.5);
  const Sum<V> square = product(d, x, x);
  const V half_square = hn::Mul(hn::Set(d, part), square.high);
  const V shifter = hn::Set(d, 0x1.8p52);
  const V shifted =
      hn::Add(hn::Mul(half_square, hn::Set(d, powers_a_binade / 0.69314718055994530942)), shifter);
  const V k = hn::Sub(shifted, shifter);
  const auto whole = hn::Sub(hn::BitCast(bits, shifted), hn::BitCast(bits, shifter));
  const V r = hn::Add(hn::NegMulAdd(k, step_high, half_square),
                      hn::NegMulAdd(k, step_low, hn::Mul(hn::Set(d, part), square.low)));
  // p = e^{−r} − 1, |r| < 0.0028, plus the relative rounding error of the power of two, power[1]
  V power[2];
  load_rows(d, powers_of_two[0], hn::And(whole, hn::Set(bits, std::uint64_t{powers_a_binade - 1})),
            power);
  const V r2 = hn::Mul(r, r);
  const V upper = hn::MulAdd(r, hn::Set(d, -1.0 / 120), hn::Set(d, 1.0 / 24));
  const V lower = hn::MulAdd(r, hn::Set(d, -1.0 / 6), half);
  const V p = hn::Sub(hn::MulAdd(hn::MulAdd(upper, r2, lower), r2, power[1]), r);
  // power (1 + p)(high + low), of which all but power·high is small
  const V small =
      hn::MulAdd(power[0], s.low, hn::Mul(hn::Add(s.high, s.low), hn::Mul(power[0], p)));
  const V value = product_and_sum(d, power[0], s.high, small);
  // 2^−exponent in two steps, because it or the result may be subnormal
  const auto exponent = hn::ShiftRight<7>(whole);
  const auto first = hn::ShiftRight<1>(exponent);
  const auto two_to_minus = [&](Integers<D> e) HWY_ATTR {
    return hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(bits, std::uint64_t{1023}), e)));
  };
  return hn::Mul(hn::Mul(value, two_to_minus(first)), two_to_minus(hn::Sub(exponent, first)));
}

// |d|, and the end of the pieces where |d| is beyond them or NaN.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V distance_in_pieces(D d, V argument) {
  const V x = hn::Abs(argument);
  const V last = hn::Set(d, below_pieces_end);
  return hn::IfThenElse(hn::Lt(x, last), x, last);
}

// Computes the lanes of a mask anew, by a scalar function of the argument.
template <class D, class Function>
HWY_NOINLINE hn::Vec<D> mend(D d, hn::Vec<D> value, hn::Vec<D> argument, hn::Mask<D> lanes,
                             Function&& function) {
  HWY_ALIGN double values[hn::MaxLanes(D())];
  HWY_ALIGN double arguments[hn::MaxLanes(D())];
  HWY_ALIGN double selected[hn::MaxLanes(D())];
  hn::Store(value, d, values);
  hn::Store(argument, d, arguments);
  hn::Store(hn::IfThenElseZero(lanes, hn::Set(d, 1.0)), d, selected);
  for (std::size_t j = 0; j < hn::Lanes(d); ++j)
    if (selected[j] != 0) values[j] = function(arguments[j]);
  return hn::Load(d, values);
}

// F_n(d), for every d.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V moment_of(D d, Order n, V argument) {
  const auto below_zero = hn::Lt(argument, hn::Zero(d));
  const Sum<V> sum = moment_in_pieces(d, n, below_zero, distance_in_pieces(d, argument));
  V value = hn::Add(sum.high, sum.low);
  if (!hn::AllTrue(d, below_zero)) {
    const V limit = hn::Set(d, 40.0);  // F_n(40) < 2^−1075
    const V gaussian = times_gaussian(d, sum, hn::Min(hn::Abs(argument), limit));
    const V above = hn::IfThenElseZero(hn::Lt(argument, limit), gaussian);
    value = hn::IfThenElse(below_zero, value, above);
  }
  const auto beyond = hn::Not(hn::Gt(argument, hn::Set(d, -pieces_end)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, beyond)))
    value = mend(d, value, argument, beyond, [n](double x) { return moment_beyond_pieces(n, x); });
  return value;
}

// S_n(d), for every d.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V scaled_moment_of(D d, Order n, V argument) {
  const auto below_zero = hn::Lt(argument, hn::Zero(d));
  const Sum<V> sum = moment_in_pieces(d, n, below_zero, distance_in_pieces(d, argument));
  const V value = hn::Add(sum.high, sum.low);
  const auto beyond = hn::Not(hn::Lt(hn::Abs(argument), hn::Set(d, pieces_end)));
  if (HWY_LIKELY(hn::AllFalse(d, beyond))) return value;
  return mend(d, value, argument, beyond, [n](double x) { return moment_beyond_pieces(n, x); });
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
