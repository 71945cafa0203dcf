// SPDX-License-Identifier: Apache-2.0
// Films of laws without fixed exponents (moes_film.hpp, solved_films.hpp) in double, once for each
// instruction set, for one lane and for vectors: ln λ at s = ln u and z = ln γ.
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "contact_numbers-inl.hpp"
#include "elementary-inl.hpp"
#include "tribo/solved_films.hpp"

#if defined(TRIBO_STIFFENED_FILM) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_STIFFENED_FILM
#undef TRIBO_STIFFENED_FILM
#else
#define TRIBO_STIFFENED_FILM
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// ln λ, its slopes in z and in s, and its second derivative in z. This derivative leaves out the
// change of a norm's exponent: no root depends on it.
template <class D>
struct LogFilm {
  using V = hn::Vec<D>;
  V value, by_sharing, by_speed, bend;
  hn::Mask<D> is_known;  // false beyond a table of solved films
};

// The exponent of a norm, and its slope, which is the same in z and in s.
template <class V>
struct NormExponent {
  V value, slope;
};

// The norm of exponent p of two films. is_of_greater: p > 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE LogFilm<D> norm_of(D d, const LogFilm<D>& x, const LogFilm<D>& y, bool is_of_greater,
                              const NormExponent<V>& p, bool has_slope) {
  const V one = hn::Set(d, 1.0);
  const V difference = hn::Sub(x.value, y.value);
  const V distance = hn::Mul(hn::Abs(difference), hn::Abs(p.value));
  const V small = exponential(d, hn::Neg(distance));
  const V log_sum = logarithm_of_one_plus(d, small);
  const V top = is_of_greater ? hn::Max(x.value, y.value) : hn::Min(x.value, y.value);
  const V inverse = hn::Div(one, p.value);
  const V rest = hn::Div(small, hn::Add(one, small));  // the part of the film that matters less
  const auto is_first =
      is_of_greater ? hn::Ge(difference, hn::Zero(d)) : hn::Le(difference, hn::Zero(d));
  const V part = hn::IfThenElse(is_first, hn::Sub(one, rest), rest);
  const auto mixed = [&](V of_x, V of_y)
                         HWY_ATTR { return hn::MulAdd(part, hn::Sub(of_x, of_y), of_y); };
  const V apart = hn::Sub(x.by_sharing, y.by_sharing);
  LogFilm<D> joined{hn::MulAdd(log_sum, inverse, top), mixed(x.by_sharing, y.by_sharing),
                    mixed(x.by_speed, y.by_speed), mixed(x.bend, y.bend), x.is_known};
  const V both = hn::Mul(hn::Mul(p.value, part), hn::Sub(one, part));
  joined.bend = hn::MulAdd(both, hn::Mul(apart, apart), joined.bend);
  if (has_slope) {
    // −Σ part ln part ≥ 0: the norm falls as p rises.
    const V entropy = hn::MulAdd(rest, distance, log_sum);
    const V fall = hn::Mul(hn::Mul(hn::Mul(p.slope, inverse), inverse), entropy);
    joined.by_sharing = hn::Sub(joined.by_sharing, fall);
    joined.by_speed = hn::Sub(joined.by_speed, fall);
  }
  return joined;
}

// The film by a law that joins limits. The contact's numbers are ln λ by each limit at s = z = 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE LogFilm<D> film_by_limits(D d, bool is_line, const detail::FilmNumbers<V>& film,
                                     V greatest, V s, V z) {
  const V zero = hn::Zero(d), both = hn::Add(s, z);
  const auto always = hn::Eq(zero, zero);
  const auto of_both = [&](V at_one, double slope) HWY_ATTR {
    const V by = hn::Set(d, slope);
    return LogFilm<D>{hn::MulAdd(both, by, at_one), by, by, zero, always};
  };
  const auto of_speed = [&](V at_one, double slope) HWY_ATTR {
    const V by = hn::Set(d, slope);
    return LogFilm<D>{hn::MulAdd(s, by, at_one), zero, by, zero, always};
  };
  const auto fixed = [&](double p) HWY_ATTR { return NormExponent<V>{hn::Set(d, p), zero}; };
  const LogFilm<D> rigid = of_both(film.rigid, is_line ? 1 : 2);
  const LogFilm<D> elastic = of_both(film.elastic, 0.6);
  const LogFilm<D> rigid_piezoviscous = of_speed(film.rigid_piezoviscous, 2.0 / 3);
  const LogFilm<D> elastic_piezoviscous = of_speed(film.elastic_piezoviscous, 0.75);
  // p = base + rise e^{−x}, x = factor EI/RI; from x = 1000 on e^{−x} is 0
  const double base = is_line ? 1.4 : 1.5, rise = is_line ? 1.6 : 1.5;
  const double log_factor = is_line ? 0.69314718055994530942 : 0.18232155679395462621;
  const V log_x = hn::Min(hn::Add(hn::Sub(elastic.value, rigid.value), hn::Set(d, log_factor)),
                          hn::Set(d, 7.0));
  const V x = exponential(d, log_x);
  const V fall = hn::Mul(hn::Set(d, rise), exponential(d, hn::Neg(x)));
  const NormExponent<V> p{hn::Add(hn::Set(d, base), fall),
                          hn::Mul(hn::Mul(hn::Set(d, is_line ? 0.4 : 1.4), x), fall)};
  LogFilm<D> isoviscous, piezoviscous;
  if (is_line) {
    isoviscous = norm_of(d, rigid, elastic, true, fixed(7.0 / 3), false);
    piezoviscous = norm_of(d, rigid_piezoviscous, elastic_piezoviscous, false, fixed(-3.5), false);
  } else {
    const LogFilm<D> limited = norm_of(d, elastic, of_both(greatest, 0.5), false, fixed(-4), false);
    isoviscous = norm_of(d, rigid, limited, true, fixed(1.5), false);
    piezoviscous = norm_of(d, rigid_piezoviscous, elastic_piezoviscous, false, fixed(-8), false);
  }
  return norm_of(d, isoviscous, piezoviscous, true, p, true);
}

// A cubic between two nodes, at t from 0 to 1, and its first and second derivative in t.
template <class V>
struct Cubic {
  V value, slope, bend;
};
template <class D, class V = hn::Vec<D>>
class CubicLanes {
 public:
  HWY_INLINE CubicLanes(D d, V t) {
    const V one = hn::Set(d, 1.0), two = hn::Set(d, 2.0), three = hn::Set(d, 3.0),
            six = hn::Set(d, 6.0), rest = hn::Sub(one, t);
    end_ = {hn::Mul(hn::Mul(t, t), hn::NegMulAdd(two, t, three)), hn::Mul(hn::Mul(six, t), rest),
            hn::NegMulAdd(hn::Set(d, 12.0), t, six)};
    from_ = {hn::Mul(t, hn::Mul(rest, rest)), hn::Mul(rest, hn::NegMulAdd(three, t, one)),
             hn::MulSub(six, t, hn::Set(d, 4.0))};
    to_ = {hn::Neg(hn::Mul(hn::Mul(t, t), rest)), hn::Mul(t, hn::MulSub(three, t, two)),
           hn::MulSub(six, t, two)};
  }
  HWY_INLINE V value(V from, V from_slope, V to, V to_slope) const {
    return sum(&Cubic<V>::value, hn::Sub(to, from), from_slope, to_slope, from);
  }
  HWY_INLINE V slope(V from, V from_slope, V to, V to_slope) const {
    return hn::MulAdd(hn::Sub(to, from), end_.slope,
                      hn::MulAdd(from_slope, from_.slope, hn::Mul(to_slope, to_.slope)));
  }
  HWY_INLINE V bend(V from, V from_slope, V to, V to_slope) const {
    return hn::MulAdd(hn::Sub(to, from), end_.bend,
                      hn::MulAdd(from_slope, from_.bend, hn::Mul(to_slope, to_.bend)));
  }

 private:
  HWY_INLINE V sum(V Cubic<V>::*of, V rise, V from_slope, V to_slope, V from) const {
    return hn::Add(from, hn::MulAdd(rise, end_.*of,
                                    hn::MulAdd(from_slope, from_.*of, hn::Mul(to_slope, to_.*of))));
  }
  Cubic<V> end_, from_, to_;
};

// The number of the step that contains t, in a table whose steps have the length 1.
inline constexpr double whole_shifter = 0x1.8p52;  // its sum with a number is a whole number
template <class D, class V = hn::Vec<D>>
HWY_INLINE V step_of(D d, V t, std::size_t steps) {
  const V shifter = hn::Set(d, whole_shifter), last = hn::Set(d, static_cast<double>(steps - 1));
  const V whole = hn::Sub(hn::Add(hn::Sub(t, hn::Set(d, 0.5)), shifter), shifter);
  return hn::Min(hn::Max(whole, hn::Zero(d)), last);
}
// The index of a row from a whole number ≥ 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Integers<D> whole_number(D d, V number) {
  const hn::RebindToUnsigned<D> bits;
  const V shifter = hn::Set(d, whole_shifter);
  return hn::Sub(hn::BitCast(bits, hn::Add(number, shifter)), hn::BitCast(bits, shifter));
}

// A solved film. Beyond the table ln λ continues in a straight line, with is_known = false.
template <class D, class V = hn::Vec<D>>
HWY_INLINE LogFilm<D> film_in_table(D d, const FilmTable& table, bool is_line,
                                    const detail::FilmNumbers<V>& film, V log_scale, V s, V z) {
  const hn::RebindToUnsigned<D> bits;
  // ln M falls by m(s + z); L has the factor e^{s/4 − 3z/4}.
  const V m = hn::Set(d, is_line ? 0.5 : 0.75), quarter = hn::Set(d, 0.25);
  const V three_quarters = hn::Set(d, 0.75);
  const V log_load = hn::NegMulAdd(hn::Add(s, z), m, film.rigid);
  const V l =
      hn::Mul(film.elastic, exponential(d, hn::Mul(quarter, hn::NegMulAdd(z, hn::Set(d, 3.0), s))));
  const V load =
      hn::Min(hn::Max(log_load, hn::Set(d, table.first_load)), hn::Set(d, table.last_load()));
  const V material = hn::Min(l, hn::Set(d, table.last_material()));
  const double by_load_step = 1 / table.load_step, by_material_step = 1 / table.material_step;
  const V x = hn::Mul(hn::Sub(load, hn::Set(d, table.first_load)), hn::Set(d, by_load_step));
  const V y = hn::Mul(material, hn::Set(d, by_material_step));
  const V half = hn::Set(d, 0.5);
  const V i = step_of(d, x, table.load_steps), j = step_of(d, y, table.material_steps);
  const auto index =
      whole_number(d, hn::MulAdd(i, hn::Set(d, static_cast<double>(table.material_steps + 1)), j));
  const double* const base = table.nodes[0];
  V n00[4], n01[4], n10[4], n11[4];
  const auto beside = hn::Add(index, hn::Set(bits, std::uint64_t{table.material_steps + 1}));
  const auto next = [&](Integers<D> k)
                        HWY_ATTR { return hn::Add(k, hn::Set(bits, std::uint64_t{1})); };
  load_rows(d, base, index, n00);
  load_rows(d, base, next(index), n01);
  load_rows(d, base, beside, n10);
  load_rows(d, base, next(beside), n11);
  const CubicLanes<D> along(d, hn::Sub(x, i)), across(d, hn::Sub(y, j));
  const auto across_of = [&](V(&low)[4], V(&high)[4], int k) HWY_ATTR {
    return Cubic<V>{across.value(low[k], low[k + 2], high[k], high[k + 2]),
                    across.slope(low[k], low[k + 2], high[k], high[k + 2]),
                    across.bend(low[k], low[k + 2], high[k], high[k + 2])};
  };
  const Cubic<V> f0 = across_of(n00, n01, 0), g0 = across_of(n00, n01, 1);
  const Cubic<V> f1 = across_of(n10, n11, 0), g1 = across_of(n10, n11, 1);
  const V value = along.value(f0.value, g0.value, f1.value, g1.value);
  const V dx =
      hn::Mul(along.slope(f0.value, g0.value, f1.value, g1.value), hn::Set(d, by_load_step));
  const V dy =
      hn::Mul(along.value(f0.slope, g0.slope, f1.slope, g1.slope), hn::Set(d, by_material_step));
  const V dxx = hn::Mul(along.bend(f0.value, g0.value, f1.value, g1.value),
                        hn::Set(d, by_load_step * by_load_step));
  const V dxy = hn::Mul(along.slope(f0.slope, g0.slope, f1.slope, g1.slope),
                        hn::Set(d, by_load_step * by_material_step));
  const V dyy = hn::Mul(along.value(f0.bend, g0.bend, f1.bend, g1.bend),
                        hn::Set(d, by_material_step * by_material_step));
  const V log_film =
      hn::MulAdd(dx, hn::Sub(log_load, load), hn::MulAdd(dy, hn::Sub(l, material), value));
  const V by_material = hn::Mul(dy, l);
  const V by_load = hn::NegMulAdd(m, dx, half);
  LogFilm<D> result;
  result.value = hn::Add(hn::MulAdd(half, hn::Add(s, z), log_scale), log_film);
  result.by_speed = hn::MulAdd(quarter, by_material, by_load);
  result.by_sharing = hn::NegMulAdd(three_quarters, by_material, by_load);
  const V c = hn::Mul(three_quarters, l);
  result.bend = hn::MulAdd(
      hn::Mul(m, m), dxx,
      hn::MulAdd(hn::Mul(hn::Add(m, m), c), dxy,
                 hn::MulAdd(hn::Mul(c, c), dyy, hn::Mul(three_quarters, hn::Mul(c, dy)))));
  result.is_known = hn::And(hn::Eq(log_load, load), hn::Eq(l, material));
  result.bend = hn::IfThenElseZero(result.is_known, result.bend);
  return result;
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE LogFilm<D> log_film_at(D d, const FilmLaw& law, const FilmTable* table,
                                  const detail::FilmNumbers<V>& film, V at_unit_speed, V s, V z) {
  if (table != nullptr) return film_in_table(d, *table, law.is_of_lines, film, at_unit_speed, s, z);
  return film_by_limits(d, law.is_of_lines, film, at_unit_speed, s, z);
}
inline const FilmTable* table_of(const FilmLaw& law) {
  return law.is_solved() ? &film_table(law) : nullptr;
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
