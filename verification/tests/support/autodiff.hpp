// SPDX-License-Identifier: Apache-2.0
// Derivatives of the model's formulas by Boost's forward automatic differentiation, in 50 digits;
// and the functions that these formulas need and Boost lacks.
#pragma once

#include <boost/math/differentiation/autodiff.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "support/judge.hpp"
#include "tribo/mixed_contact.hpp"

// Boost 1.74 has no log1p and no expm1 for these numbers. The model finds both by
// argument-dependent lookup, as it finds Boost's own functions.
namespace boost::math::differentiation::detail {

template <class Real>
fvar<Real, 1> log1p(const fvar<Real, 1>& x) {
  using std::log1p;
  const Real at(x);
  return x.apply_derivatives(
      1, [&](std::size_t i) { return i == 0 ? Real(log1p(at)) : Real(1 / (1 + at)); });
}

template <class Real>
fvar<Real, 1> expm1(const fvar<Real, 1>& x) {
  using std::exp;
  using std::expm1;
  const Real at(x);
  return x.apply_derivatives(
      1, [&](std::size_t i) { return i == 0 ? Real(expm1(at)) : Real(exp(at)); });
}

}  // namespace boost::math::differentiation::detail

namespace tribo {

namespace verification {

// Boost 1.74 cannot differentiate with MPFR's numbers. The numbers here also have fifty digits.
using Differentiable = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                                     boost::multiprecision::et_off>;

// A number with its derivative with respect to one variable.
using Dual = boost::math::differentiation::autodiff_fvar<Differentiable, 1>;

inline Dual variable(const Reference& x) {
  return boost::math::differentiation::make_fvar<Differentiable, 1>(Differentiable(x));
}
inline Reference value(const Dual& x) { return Reference(x.derivative(0)); }
inline Reference derivative(const Dual& x) { return Reference(x.derivative(1)); }

// d ln y/d ln x, where y is a function of the variable x.
inline Reference log_slope(const Dual& y, const Reference& x) {
  return derivative(y) * x / value(y);
}

}  // namespace verification

// The general pi() takes arccos(−1). The derivative of arccos does not exist there, and automatic
// differentiation would multiply it by 0.
template <>
inline verification::Dual pi<verification::Dual>() {
  return verification::Dual(pi<verification::Reference>());
}

namespace verification {

// g(λ) = ln λ − ln λ₀ + e ln(1 − A(λ)). The film λ is the root of g.
inline Dual sharing_residual(const LoadSharing<Dual>& sharing, const Dual& lambda,
                             const Dual& lambda0) {
  return log(lambda) - log(lambda0) +
         ratio<Dual>(sharing.film().sharing_exponent) *
             log1p(Dual(-sharing.asperity_share(lambda)));
}

// The root with its derivative. In `solve` the value may converge a step before the derivative
// does; one more Newton step at the converged root corrects the derivative. g′ also comes from
// automatic differentiation, and not from the model's F_p′.
inline Dual root_with_derivative(AsperityModel model, const Dual& stiffness, const Dual& offset,
                                 const Dual& lambda0,
                                 const FilmLaw& film = hamrock_dowson_central_law) {
  const LoadSharing<Dual> moving(model, stiffness, offset, film);
  const LoadSharing<Dual> fixed(model, Dual(value(stiffness)), Dual(value(offset)), film);
  const Dual lambda0_fixed(value(lambda0));
  const Reference root = value(fixed.solve(lambda0_fixed).film_parameter);
  const Reference slope = derivative(sharing_residual(fixed, variable(root), lambda0_fixed));
  return Dual(root) - sharing_residual(moving, Dual(root), lambda0) / Dual(slope);
}

// d ln h*/d ln u of a scene. Only the film and the inlet of the model are used.
inline Reference film_log_slope(const Scene& scene, const Reference& u) {
  const MixedContact<Dual> contact(scene);
  const Dual speed = variable(u);
  const Dual root = root_with_derivative(scene.closures.asperity, contact.sharing().stiffness(),
                                         contact.sharing().offset(),
                                         contact.flooded_film_parameter(speed), contact.film());
  // `inlet` reads only λ of the shares. Its own scalar root ends with a Newton step, too.
  return log_slope(root * contact.inlet({speed, {root, Dual(0), Dual(1), 0}}).film_ratio, u);
}

}  // namespace verification

}  // namespace tribo
