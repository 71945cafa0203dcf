// SPDX-License-Identifier: Apache-2.0
// F_n and S_n of a vector of arguments (gaussian_moment.hpp), once for each instruction set: 16
// polynomials on each side of 0 (gaussian_moment_rows.inc), of which each lane takes its own, and
// e^{−d²/2} with d² split.
#include <hwy/highway.h>

#include "gaussian_moment_rows.hpp"

#if defined(TRIBO_GAUSSIAN_MOMENT_VECTOR) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_GAUSSIAN_MOMENT_VECTOR
#undef TRIBO_GAUSSIAN_MOMENT_VECTOR
#else
#define TRIBO_GAUSSIAN_MOMENT_VECTOR
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using Integers = hn::Vec<hn::RebindToUnsigned<D>>;

// Coefficient k of each lane's piece, from rows of 16 in memory; a row's second half is for d < 0.
template <class D>
class GatheredRows {
 public:
  GatheredRows(D d, const double* base, Integers<D> piece) : d_(d), base_(base), piece_(piece) {}
  HWY_INLINE hn::Vec<D> operator()(int k) const {
    const double* row = base_ + std::ptrdiff_t{16} * k;
    const hn::RebindToSigned<D> signed_tag;
    if constexpr (hn::MaxLanes(D()) == 1)
      return hn::Set(d_, row[hn::GetLane(piece_)]);
    else
      return hn::GatherIndex(d_, row, hn::BitCast(signed_tag, piece_));
  }

 private:
  D d_;
  const double* base_;
  Integers<D> piece_;
};

#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
// The same from two registers, the second loaded `second` doubles after the first: Highway 1.0.3
// has no look-up in two of them.
template <class D, std::size_t second = 8>
class PermutedRows {
 public:
  PermutedRows(D d, const double* base, Integers<D> piece) : d_(d), base_(base), piece_(piece) {}
  HWY_INLINE hn::Vec<D> operator()(int k) const {
    const double* row = base_ + std::ptrdiff_t{16} * k;
    return hn::Vec<D>{
        _mm512_permutex2var_pd(hn::Load(d_, row).raw, piece_.raw, hn::Load(d_, row + second).raw)};
  }

 private:
  D d_;
  const double* base_;
  Integers<D> piece_;
};

// The same where lanes lie on both sides of 0.
template <class D>
class MixedRows {
 public:
  MixedRows(D d, const double* base, Integers<D> piece, hn::Mask<D> below_zero)
      : above_(d, base, piece),
        below_(d, base + vector_side_stride, piece),
        below_zero_(below_zero) {}
  HWY_INLINE hn::Vec<D> operator()(int k) const {
    return hn::IfThenElse(below_zero_, below_(k), above_(k));
  }

 private:
  PermutedRows<D> above_, below_;
  hn::Mask<D> below_zero_;
};
#endif

// A polynomial's place: each lane's piece, and the distance t of |d| from its centre.
template <class D>
struct Place {
  Integers<D> piece;  // 0 … 15
  hn::Vec<D> t;
};

// Of |d| < pieces_end.
template <class D>
HWY_INLINE Place<D> place_of(D d, hn::Vec<D> x) {
  constexpr int kept = 50;  // bits below those that number the pieces of x + 3
  const hn::RebindToUnsigned<D> bits;
  const auto top = hn::ShiftRight<kept>(hn::BitCast(bits, hn::Add(x, hn::Set(d, 3.0))));
  const auto half = hn::Set(bits, std::uint64_t{1} << (kept - 1));
  const auto centre =
      hn::Sub(hn::BitCast(d, hn::Or(hn::ShiftLeft<kept>(top), half)), hn::Set(d, 3.0));
  constexpr std::uint64_t first = 0x4008000000000000 >> kept;  // of 3.0
  return {hn::Sub(top, hn::Set(bits, first)), hn::Sub(x, centre)};
}

// visit(rows) with what reads the coefficients of order n.
template <class D, class Visitor>
HWY_INLINE auto with_rows(D d, Order n, hn::Mask<D> below_zero, Integers<D> piece,
                          Visitor&& visit) {
  const double* base = vector_rows(n);
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  if constexpr (hn::MaxLanes(D()) == 8) {
    if (hn::AllFalse(d, below_zero)) return visit(PermutedRows<D>(d, base, piece));
    if (hn::AllTrue(d, below_zero))
      return visit(PermutedRows<D>(d, base + vector_side_stride, piece));
    const hn::RebindToSigned<D> integers;
    const auto is_near = hn::Lt(hn::BitCast(integers, piece), hn::Set(integers, std::int64_t{8}));
    if (hn::AllTrue(integers, is_near)) {
      // Of the first 8 pieces of each side.
      const hn::RebindToUnsigned<D> bits;
      const auto eight = hn::BitCast(d, hn::Set(bits, std::uint64_t{8}));
      const auto side = hn::BitCast(bits, hn::IfThenElseZero(below_zero, eight));
      return visit(PermutedRows<D, vector_side_stride>(d, base, hn::Or(piece, side)));
    }
    return visit(MixedRows<D>(d, base, piece, below_zero));
  } else
#endif
  {
    const hn::RebindToUnsigned<D> bits;
    const auto stride = hn::Set(bits, std::uint64_t{vector_side_stride});
    const auto offset = hn::BitCast(bits, hn::IfThenElseZero(below_zero, hn::BitCast(d, stride)));
    return visit(GatheredRows<D>(d, base, hn::Add(piece, offset)));
  }
}

// A number as the unrounded sum of two.
template <class V>
struct VectorSum {
  V high, low;
};

// S_n(d) at |d| = x < pieces_end for d ≥ 0, F_n(d) for d < 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE VectorSum<V> moment_in_pieces(D d, Order n, hn::Mask<D> below_zero, V x) {
  const Place<D> place = place_of(d, x);
  return with_rows(d, n, below_zero, place.piece, [&](const auto& rows) HWY_ATTR {
    const V t = place.t;
    const V square = hn::Mul(t, t);
    V odd = rows(20), even = rows(19);  // of c_19 and c_18
    for (int k = 18; k >= 4; k -= 2) {
      odd = hn::MulAdd(odd, square, rows(k));
      even = hn::MulAdd(even, square, rows(k - 1));
    }
    // c_0 + c_1 t unrounded, but for the product where there is no fused multiply-add
    const V first = rows(0), product = hn::Mul(t, rows(2));
    const V product_low = hn::MulSub(t, rows(2), product);
    const V leading = hn::Add(first, product);
    const V leading_low = hn::Sub(product, hn::Sub(leading, first));
    const V rest = hn::MulAdd(hn::MulAdd(odd, t, even), square, hn::Add(rows(1), product_low));
    const V low = hn::Add(leading_low, rest);
    const V high = hn::Add(leading, low);
    return VectorSum<V>{high, hn::Sub(low, hn::Sub(high, leading))};
  });
}

// The same to a few ulp, with its derivative in x over it.
template <class D, class V = hn::Vec<D>>
HWY_INLINE VectorSum<V> moment_and_log_slope(D d, Order n, hn::Mask<D> below_zero, V x) {
  const Place<D> place = place_of(d, x);
  return with_rows(d, n, below_zero, place.piece, [&](const auto& rows) HWY_ATTR {
    const V t = place.t;
    const V square = hn::Mul(t, t);
    // E(t²) + t O(t²), and their derivatives in t²
    V odd = rows(20), even = rows(19);
    V odd_slope = hn::Zero(d), even_slope = hn::Zero(d);
    for (int k = 18; k >= 2; k -= 2) {
      odd_slope = hn::MulAdd(odd_slope, square, odd);
      even_slope = hn::MulAdd(even_slope, square, even);
      odd = hn::MulAdd(odd, square, rows(k));
      even = hn::MulAdd(even, square, rows(k == 2 ? 0 : k - 1));
    }
    const V value = hn::MulAdd(odd, t, even);
    const V slope = hn::MulAdd(hn::Add(t, t), hn::MulAdd(odd_slope, t, even_slope), odd);
    return VectorSum<V>{value, hn::Div(slope, value)};
  });
}

// sum·e^{−d²/2}, 0 ≤ d < pieces_end.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V times_gaussian(D d, VectorSum<V> sum, V x) {
  const hn::RebindToUnsigned<D> bits;
  const V half = hn::Set(d, 0.5);
  const V head = hn::And(x, hn::BitCast(d, hn::Set(bits, ~((std::uint64_t{1} << 27) - 1))));
  const V square = hn::Mul(half, hn::Mul(head, head));                        // exact
  const V rest = hn::Mul(hn::Mul(half, hn::Sub(x, head)), hn::Add(x, head));  // d²/2 less that
  const V shifter = hn::Set(d, 0x1.8p52);
  const V shifted = hn::MulAdd(square, hn::Set(d, 1.44269504088896340736), shifter);
  const V k = hn::Sub(shifted, shifter);
  // ln 2 in two parts, the first with 38 bits: its multiples here are exact.
  const V near = hn::NegMulAdd(k, hn::Set(d, 0x1.62e42fefap-1), square);
  const V m = hn::Sub(hn::NegMulAdd(hn::Set(d, -0x1.cf79abc9e3b3ap-40), k, hn::Neg(near)), rest);
  // e^m − 1 for |m| < 0.347: m^14/14! is below 2^−57
  const V m2 = hn::Mul(m, m);
  V odd = hn::Set(d, 1.0 / 6227020800), even = hn::Set(d, 1.0 / 479001600);
  odd = hn::MulAdd(odd, m2, hn::Set(d, 1.0 / 39916800));
  even = hn::MulAdd(even, m2, hn::Set(d, 1.0 / 3628800));
  odd = hn::MulAdd(odd, m2, hn::Set(d, 1.0 / 362880));
  even = hn::MulAdd(even, m2, hn::Set(d, 1.0 / 40320));
  odd = hn::MulAdd(odd, m2, hn::Set(d, 1.0 / 5040));
  even = hn::MulAdd(even, m2, hn::Set(d, 1.0 / 720));
  odd = hn::MulAdd(odd, m2, hn::Set(d, 1.0 / 120));
  even = hn::MulAdd(even, m2, hn::Set(d, 1.0 / 24));
  odd = hn::MulAdd(odd, m2, hn::Set(d, 1.0 / 6));
  even = hn::MulAdd(even, m2, half);
  const V q = hn::MulAdd(hn::MulAdd(odd, m, even), m2, m);
  const V value = hn::Add(sum.high, hn::MulAdd(sum.high, q, sum.low));
  // 2^−k in two steps, for where that, or the result, is subnormal
  const auto whole = hn::Sub(hn::BitCast(bits, shifted), hn::BitCast(bits, shifter));
  const auto first = hn::ShiftRight<1>(whole);
  const auto bias = hn::Set(bits, std::uint64_t{1023});
  const auto power = [&](Integers<D> e)
                         HWY_ATTR { return hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(bias, e))); };
  return hn::Mul(hn::Mul(value, power(first)), power(hn::Sub(whole, first)));
}

// |d|, and the end of the pieces for what lies beyond or is no number.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V distance_in_pieces(D d, V argument) {
  const V x = hn::Abs(argument);
  const V last = hn::Set(d, below_pieces_end);
  return hn::IfThenElse(hn::Lt(x, last), x, last);
}

// F_n(d) for d > −pieces_end.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V moment_vector(D d, Order n, V argument) {
  const auto below_zero = hn::Lt(argument, hn::Zero(d));
  const V x = distance_in_pieces(d, argument);
  const VectorSum<V> sum = moment_in_pieces(d, n, below_zero, x);
  const V limit = hn::Set(d, 40.0);  // F_n(40) < 2^−1075
  const V product = times_gaussian(d, sum, hn::Min(x, limit));
  const V above = hn::IfThenElseZero(hn::Lt(argument, limit), product);
  return hn::IfThenElse(below_zero, sum.high, above);
}

// S_n(d) for |d| < pieces_end.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V scaled_moment_vector(D d, Order n, V argument) {
  const auto below_zero = hn::Lt(argument, hn::Zero(d));
  return moment_in_pieces(d, n, below_zero, distance_in_pieces(d, argument)).high;
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
