// SPDX-License-Identifier: Apache-2.0
// The film of a contact by a law without fixed exponents, as load sharing asks for it: the film
// carries F/γ with E*/γ, so that U becomes γU, G becomes G/γ, and W stays (model/README.md, section
// 6). With M = W(2U)^{−m}, m = 3/4 for points and 1/2 for lines, and L = G(2U)^{1/4},
//
//   h/R = (2Uγ)^{1/2} H(Mγ^{−m}, Lγ^{−3/4}).
//
// A law of fixed exponents, (2U)^{1/2} H = C U^a G^b W^c, gives h₀γ^{a−b}, which is the film of
// load_sharing.hpp. At a speed and a γ, the exponents a and a − b of the power law with the same
// slopes are
//
//   d ln h/d ln u = 1/2 − m H_M + H_L/4,   d ln h/d ln γ = d ln h/d ln u − H_L,
//
// where H_M and H_L are the slopes of ln H against ln M and ln L. h rises with γ for M from 1e-3 to
// 1e6 and L up to 100 (analytic.MoesFilm), so that load sharing has one root. From L = 200 on a
// point's film falls as γ^−0.001 in places, because its exponent s changes faster than the film of
// rigid bodies grows. There load sharing may have several roots, which differ by some parts in ten
// thousand, and λ is one of them.
#pragma once

#include "tribo/film_laws.hpp"
#include "tribo/nijenbanning_venner_moes.hpp"
#include "tribo/solved_films.hpp"

namespace tribo {

// d ln h/d ln u and d ln h/d ln γ: a and a − b of a law of fixed exponents.
template <class T>
struct FilmExponents {
  T speed, sharing;
};

namespace detail {

// The p-norm of two films and its slopes, p ≠ 0. The slope of `p` itself in ln M is p_slope.
template <class T>
FilmNumber<T> norm_of(const FilmNumber<T>& x, const FilmNumber<T>& y, const T& p,
                      const T& p_slope) {
  using std::log;
  using std::pow;
  const auto real_power = [](const T& by) { return [by](const T& of) { return T(pow(of, by)); }; };
  const bool is_of_greater = p > 0;
  const T value = joined(x.value, y.value, is_of_greater, real_power(is_of_greater ? p : T(-p)),
                         real_power(T(1 / p)));
  const T part = 1 / (1 + pow(T(y.value / x.value), p)), rest = 1 - part;
  T load_slope = part * x.load_slope + rest * y.load_slope;
  // −Σ part ln part ≥ 0: the norm falls as p rises.
  if (p_slope != 0 && part > 0 && rest > 0)
    load_slope += p_slope / (p * p) * (part * log(part) + rest * log(rest));
  return {value, load_slope, part * x.material_slope + rest * y.material_slope};
}

}  // namespace detail

// H of a law that joins limits at M > 0, L > 0 and, of points, D = R_x/R_y.
template <class T>
FilmNumber<T> film_number(FilmForm form, const T& load_number, const T& material_number,
                          const T& radius_ratio) {
  using std::exp;
  const bool is_line = form == FilmForm::moes_line;
  const T zero(0);
  FilmNumber<T> rigid{zero, T(is_line ? -1 : -2), zero};
  FilmNumber<T> elastic{zero, is_line ? ratio<T>(-1, 5) : ratio<T>(-2, 15), zero};
  FilmNumber<T> rigid_piezoviscous{zero, zero, ratio<T>(2, 3)};
  FilmNumber<T> elastic_piezoviscous{zero, is_line ? ratio<T>(-1, 8) : ratio<T>(-1, 12),
                                     ratio<T>(3, 4)};
  T s, s_slope;
  FilmNumber<T> isoviscous, piezoviscous;
  if (is_line) {
    const MoesFilms<T> of = moes_films(load_number, material_number);
    rigid.value = of.rigid;
    elastic.value = of.elastic;
    rigid_piezoviscous.value = of.rigid_piezoviscous;
    elastic_piezoviscous.value = of.elastic_piezoviscous;
    const T x = 2 * of.elastic / of.rigid;
    s = (7 + 8 * exp(T(-x))) / 5;
    s_slope = -ratio<T>(8, 5) * exp(T(-x)) * x * (elastic.load_slope - rigid.load_slope);
    isoviscous = detail::norm_of(rigid, elastic, ratio<T>(7, 3), zero);
    piezoviscous = detail::norm_of(rigid_piezoviscous, elastic_piezoviscous, ratio<T>(-7, 2), zero);
  } else {
    const MoesPointFilms<T> of = moes_point_films(load_number, material_number, radius_ratio);
    rigid.value = of.rigid;
    elastic.value = of.elastic;
    rigid_piezoviscous.value = of.rigid_piezoviscous;
    elastic_piezoviscous.value = of.elastic_piezoviscous;
    const T x = ratio<T>(6, 5) * of.elastic / of.rigid;
    s = ratio<T>(3, 2) * (1 + exp(T(-x)));
    s_slope = -ratio<T>(3, 2) * exp(T(-x)) * x * (elastic.load_slope - rigid.load_slope);
    const FilmNumber<T> limited =
        detail::norm_of(elastic, FilmNumber<T>{of.greatest, zero, zero}, T(-4), zero);
    isoviscous = detail::norm_of(rigid, limited, ratio<T>(3, 2), zero);
    piezoviscous = detail::norm_of(rigid_piezoviscous, elastic_piezoviscous, T(-8), zero);
  }
  return detail::norm_of(isoviscous, piezoviscous, s, s_slope);
}

// The film of a contact, h/σ_s.
template <class T>
class MoesFilm {
 public:
  struct At {
    T film_parameter, speed_exponent, sharing_exponent;
    bool is_known;  // false beyond a table of solved films: λ is then extrapolated
  };

  MoesFilm() = default;
  // Arguments as for nijenbanning_venner_moes(), in SI units. `load` is F, for a line (F/L)R_x;
  // `radius_ratio` is R_x/R_y and is not used for a line; `height` is σ_s. With a law of fixed
  // exponents the object must not be asked for films.
  MoesFilm(const FilmLaw& law, const T& viscosity, const T& pressure_viscosity, const T& load,
           const T& effective_modulus, const T& radius_x, const T& radius_ratio, const T& height)
      : law_(&law), radius_ratio_(radius_ratio) {
    using std::sqrt;
    if (law.has_fixed_exponents()) return;
    const T root = sqrt(T(viscosity / (effective_modulus * radius_x)));  // (2U)^{1/2}
    const T fourth_root = sqrt(root);
    load_number_ = load / (2 * effective_modulus * radius_x * radius_x) / root;
    if (!law.is_of_lines) load_number_ /= fourth_root;
    material_number_ = 2 * pressure_viscosity * effective_modulus * fourth_root;
    // At L = 0 a tiny L is taken: the film there equals the limit L → 0 to every digit.
    if (material_number_ == 0) material_number_ = T(1e-30);
    film_ = radius_x * root / height;
  }

  // M and L at a speed in m/s, and γ.
  struct Numbers {
    T load, material;
  };
  Numbers numbers(const T& speed, const T& stiffening) const {
    using std::sqrt;
    const T root = sqrt(T(speed * stiffening)), fourth_root = sqrt(root);
    return {load_number_ / (law_->is_of_lines ? root : T(root * fourth_root)),
            material_number_ * fourth_root / stiffening};
  }

  // At a speed in m/s, and γ; λ is NaN beyond a table of solved films.
  At at(const T& speed, const T& stiffening) const {
    At film = continued(speed, stiffening);
    if (!film.is_known) film.film_parameter = quiet_nan<T>();
    return film;
  }

  // The same; beyond the table ln Ĥ goes on in straight lines.
  At continued(const T& speed, const T& stiffening) const {
    using std::log;
    using std::sqrt;
    const T root = sqrt(T(speed * stiffening));
    const bool is_line = law_->is_of_lines;
    const auto [load, material] = numbers(speed, stiffening);
    FilmNumber<T> number;
    bool is_known = true;
    if (law_->is_solved()) {
      const FilmTable& table = film_table(*law_);
      const T log_load = log(load);
      number = solved_film_number(table, log_load, material);
      is_known = is_within(table, log_load, material);
    } else {
      number = film_number(law_->form, load, material, radius_ratio_);
    }
    const T by_speed = ratio<T>(1, 2) -
                       (is_line ? ratio<T>(1, 2) : ratio<T>(3, 4)) * number.load_slope +
                       number.material_slope / 4;
    return {film_ * root * number.value, by_speed, by_speed - number.material_slope, is_known};
  }

 private:
  const FilmLaw* law_ = nullptr;
  T radius_ratio_{};
  T load_number_{}, material_number_{}, film_{};  // M, L and (2U)^{1/2}R/σ_s at 1 m/s
};

}  // namespace tribo
