// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "conformance/mistake.hpp"
#include "tribo/bracketed_root.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/starvation.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using Value = std::optional<double>;
constexpr double pi = std::numbers::pi;

double number(const json& inputs, const char* name) { return inputs.at(name).get<double>(); }

// Moments: `wrong(n, d)`.
template <class Wrong>
Mistake moment(std::string name, std::string text, Wrong&& wrong) {
  return {"gaussian_moment", std::move(name), std::move(text),
          [wrong](const json& in, std::string_view) -> Value {
            return wrong(number(in, "order"), number(in, "argument"));
          }};
}

std::optional<double> moment_of(double order, double d) {
  if (order < 0 || order > 2.5 || std::floor(2 * order) != 2 * order) return std::nullopt;
  return gaussian_moment(static_cast<Order>(static_cast<int>(2 * order)), d);
}

double gaussian(double s) { return std::exp(-s * s / 2) / std::sqrt(2 * pi); }

// Simpson's rule for ∫ (s−d)ⁿ φ(s) ds over [d, to].
double simpson(double order, double d, double to, int intervals) {
  if (!(to > d)) return 0;
  const double h = (to - d) / intervals;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2;
    const double s = d + i * h;
    sum += weight * (i == 0 && order == 0 ? 1 : std::pow(s - d, order)) * gaussian(s);
  }
  return sum * h / 3;
}

// The mistake of a formula for one order, or the model's own value for others.
template <class Wrong>
Mistake fit(double order, double from, double to, std::string name, std::string text,
            Wrong&& wrong) {
  return moment(std::move(name), std::move(text), [=](double n, double d) -> Value {
    if (n != order || d < from || d > to) return std::nullopt;
    return wrong(d);
  });
}

std::vector<Mistake> moment_mistakes() {
  const double zero = gaussian_moment(Order::five_halves, 0.0);
  std::vector<Mistake> all{
      moment("moment-unnormalized", "e^{−s²/2} without its 1/√(2π)",
             [](double n, double d) -> Value {
               const Value right = moment_of(n, d);
               return right ? Value(*right * std::sqrt(2 * pi)) : right;
             }),
      moment("moment-sign", "the argument with its sign changed",
             [](double n, double d) -> Value { return moment_of(n, -d); }),
      moment("moment-order-half-lower", "F of an order lower by 1/2",
             [](double n, double d) -> Value { return moment_of(n - 0.5, d); }),
      moment("moment-order-half-higher", "F of an order higher by 1/2",
             [](double n, double d) -> Value { return moment_of(n + 0.5, d); }),
      moment("moment-order-lower", "F of an order lower by 1",
             [](double n, double d) -> Value { return moment_of(n - 1, d); }),
      moment("moment-order-higher", "F of an order higher by 1",
             [](double n, double d) -> Value { return moment_of(n + 1, d); }),
      moment("moment-about-zero", "∫ sⁿ φ(s) ds, the moment about 0 instead of about d",
             [](double n, double d) -> Value {
               if (n == 0 || d < 0) return std::nullopt;
               // Midpoints in s from d; the integrand is smooth there.
               double sum = 0;
               const int count = 4000;
               const double h = 14.0 / count;
               for (int i = 0; i < count; ++i) {
                 const double s = d + (i + 0.5) * h;
                 sum += std::pow(s, n) * gaussian(s);
               }
               return sum * h;
             }),
      moment("moment-cut-at-4", "the integral cut off at s = 4",
             [](double n, double d) -> Value {
               if (d < -12 || d > 3.9) return std::nullopt;
               return simpson(n, d, 4, 20000);
             }),
      moment("moment-cut-at-d-plus-5", "the integral cut off at s = d + 5",
             [](double n, double d) -> Value {
               if (d < -12 || d > 12) return std::nullopt;
               return simpson(n, d, d + 5, 20000);
             }),
      moment("moment-simpson-201", "Simpson's rule with 201 points over 20 standard deviations",
             [](double n, double d) -> Value {
               if (n == 0) return std::nullopt;
               return simpson(n, d, d + 20, 200);
             }),
      moment("moment-simpson-cut", "Simpson's rule with 200 intervals, cut off at s = d + 4",
             [](double n, double d) -> Value {
               if (n == 0) return std::nullopt;
               return simpson(n, d, d + 4, 200);
             }),
      moment("moment-stray-root", "a Bessel form with a stray 1/√d",
             [](double n, double d) -> Value {
               const Value right = moment_of(n, d);
               return right && d > 0 ? Value(*right / std::sqrt(d)) : std::nullopt;
             }),
      fit(2.5, 0, 4, "moment-fit-6.804", "the published fit 4.4086e-5 (4−d)^6.804 of F_5/2",
          [](double d) { return 4.4086e-5 * std::pow(4 - d, 6.804); }),
      fit(2.5, 0, 4, "moment-fit-4.4068",
          "the fit 4.4068e-5 (4−d)^6.804, its digits swapped in copying",
          [](double d) { return 4.4068e-5 * std::pow(4 - d, 6.804); }),
      fit(2, 0, 4, "moment-fit-6.9", "the published fit 3.5e-5 (4−d)^6.9 of F_2",
          [](double d) { return 3.5e-5 * std::pow(4 - d, 6.9); }),
      fit(2.5, 0, 40, "moment-fit-exponential", "the published fit 0.6189 e^{−1.973 d} of F_5/2",
          [](double d) { return 0.6189 * std::exp(-1.973 * d); }),
      fit(2, 0, 40, "moment-fit-exponential-2", "the published fit 0.5025 e^{−1.844 d} of F_2",
          [](double d) { return 0.5025 * std::exp(-1.844 * d); }),
      fit(2.5, 0, 4, "moment-fit-erf", "the fit F_5/2(0) (1 − erf d)",
          [zero](double d) { return zero * std::erfc(d); })};
  return all;
}

template <class Wrong>
Mistake hertz(std::string name, std::string text, Wrong&& wrong) {
  return {"hertz_point", std::move(name), std::move(text),
          [wrong](const json& in, std::string_view field) -> Value {
            const HertzPoint<double> point = wrong(
                number(in, "load"), number(in, "effective_modulus"), number(in, "reduced_radius"));
            return field == "radius"          ? point.radius
                   : field == "mean_pressure" ? point.mean_pressure
                   : field == "peak_pressure" ? point.peak_pressure
                                              : point.approach;
          }};
}

std::vector<Mistake> hertz_mistakes() {
  using Point = HertzPoint<double>;
  return {
      hertz("hertz-radius-halved", "R/2 in place of R (a ball on a flat has the ball's radius)",
            [](double f, double e, double r) { return hertz_point(f, e, r / 2); }),
      hertz("hertz-radius-doubled", "2R in place of R",
            [](double f, double e, double r) { return hertz_point(f, e, 2 * r); }),
      hertz("hertz-2E*", "2E* in place of E* (E′ of the film formulas is 2E*)",
            [](double f, double e, double r) { return hertz_point(f, 2 * e, r); }),
      hertz("hertz-E*-halved", "E*/2 in place of E*",
            [](double f, double e, double r) { return hertz_point(f, e / 2, r); }),
      hertz("hertz-area-without-pi", "A = a² in place of πa²",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.mean_pressure *= pi;
              p.peak_pressure *= pi;
              return p;
            }),
      hertz("hertz-peak-is-mean", "the peak pressure without its 3/2",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.peak_pressure = p.mean_pressure;
              return p;
            }),
      hertz("hertz-diameter", "the contact's diameter in place of its radius",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.radius *= 2;
              return p;
            }),
      hertz("hertz-approach-halved", "a²/(2R), the gap's geometry, in place of the approach a²/R",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.approach /= 2;
              return p;
            }),
      hertz("hertz-R-in-mm", "R in mm in place of m",
            [](double f, double e, double r) { return hertz_point(f, e, 1e3 * r); })};
}

struct Film {
  double speed, viscosity, alpha, load, modulus, radius, ellipticity;
};
// Hamrock and Dowson's form with other conventions.
double film(const Film& f, double constant, double u_modulus, double g_modulus, double w_modulus) {
  return f.radius * constant *
         std::pow(f.viscosity * f.speed / (u_modulus * f.modulus * f.radius), 0.67) *
         std::pow(f.alpha * g_modulus * f.modulus, 0.53) *
         std::pow(f.load / (w_modulus * f.modulus * f.radius * f.radius), -0.067);
}
double bracket(double k, double factor = 0.61) { return 1 - factor * std::exp(-0.73 * k); }

template <class Wrong>
Mistake film_mistake(std::string name, std::string text, Wrong&& wrong) {
  return {"hamrock_dowson_central", std::move(name), std::move(text),
          [wrong](const json& in, std::string_view) -> Value {
            return wrong(Film{number(in, "speed"), number(in, "viscosity"),
                              number(in, "pressure_viscosity"), number(in, "load"),
                              number(in, "effective_modulus"), number(in, "reduced_radius"),
                              number(in, "ellipticity")});
          }};
}

std::vector<Mistake> film_mistakes() {
  const auto with_moduli = [](double u, double g, double w) {
    return [=](const Film& f) { return film(f, 2.69 * bracket(f.ellipticity), u, g, w); };
  };
  return {
      film_mistake("film-radius-halved",
                   "R/2 in place of R (a ball on a flat has the ball's radius)",
                   [](Film f) {
                     f.radius /= 2;
                     return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                   }),
      film_mistake("film-radius-doubled", "2R in place of R",
                   [](Film f) {
                     f.radius *= 2;
                     return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                   }),
      film_mistake("film-R-in-mm", "R in mm in place of m",
                   [](Film f) {
                     f.radius *= 1e3;
                     return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                   }),
      film_mistake("film-E*", "E* in place of 2E* in U, G and W", with_moduli(1, 1, 1)),
      film_mistake("film-E*-in-U", "E* in place of 2E* in the speed number U",
                   with_moduli(1, 2, 2)),
      film_mistake("film-E*-in-G", "E* in place of 2E* in the material number G",
                   with_moduli(2, 1, 2)),
      film_mistake("film-E*-in-W", "E* in place of 2E* in the load number W", with_moduli(2, 2, 1)),
      film_mistake("film-4E*", "2E′ with E′ = 2E* in place of 2E*", with_moduli(4, 4, 4)),
      film_mistake("film-speed-sum", "the sum of the surface speeds in place of their mean",
                   [](Film f) {
                     f.speed *= 2;
                     return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                   }),
      film_mistake("film-speed-halved", "half of the entrainment speed",
                   [](Film f) {
                     f.speed /= 2;
                     return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2);
                   }),
      film_mistake(
          "film-0.6", "0.6 in place of 0.61",
          [](const Film& f) { return film(f, 2.69 * bracket(f.ellipticity, 0.6), 2, 2, 2); }),
      film_mistake("film-bracket-dropped", "2.69 without 1 − 0.61 e^{−0.73k}",
                   [](const Film& f) { return film(f, 2.69, 2, 2, 2); }),
      film_mistake("film-constant-1.9", "the rounded constant 1.9 of a circular contact",
                   [](const Film& f) { return film(f, 1.9, 2, 2, 2); }),
      film_mistake("film-circular-constant",
                   "the constant of a circular contact at every ellipticity",
                   [](const Film& f) { return film(f, 2.69 * bracket(1), 2, 2, 2); }),
      film_mistake("film-minimum", "the minimum film 3.63 U^0.68 G^0.49 W^−0.073 (1 − e^{−0.68k})",
                   [](const Film& f) {
                     const double e = 2 * f.modulus;
                     return f.radius * 3.63 *
                            std::pow(f.viscosity * f.speed / (e * f.radius), 0.68) *
                            std::pow(f.alpha * e, 0.49) *
                            std::pow(f.load / (e * f.radius * f.radius), -0.073) *
                            (1 - std::exp(-0.68 * f.ellipticity));
                   }),
      film_mistake("film-over-radius", "h/R in place of h", [](const Film& f) {
        return film(f, 2.69 * bracket(f.ellipticity), 2, 2, 2) / f.radius;
      })};
}

template <class Wrong>
Mistake starvation(std::string name, std::string text, Wrong&& wrong) {
  return {"starvation_ratio", std::move(name), std::move(text),
          [wrong](const json& in, std::string_view) -> Value {
            return wrong(in.at("closure").get<std::string>(), number(in, "flooded_over_inlet"),
                         number(in, "damiens_exponent"));
          }};
}

std::optional<StarvationClosure> closure_of(const std::string& name) {
  if (name == "flooded_inlet") return StarvationClosure::flooded_inlet;
  if (name == "starved_inlet") return StarvationClosure::starved_inlet;
  if (name == "printed_exponents") return StarvationClosure::printed_exponents;
  if (name == "damiens") return StarvationClosure::damiens;
  return std::nullopt;
}

// Another closure where one is asked for.
Mistake closure_swapped(const std::string& asked, const std::string& given) {
  return starvation("starvation-" + given + "-for-" + asked,
                    "`" + given + "` in place of `" + asked + "`",
                    [=](const std::string& closure, double r, double gamma) -> Value {
                      if (closure != asked) return std::nullopt;
                      return starvation_ratio(*closure_of(given), r, gamma);
                    });
}

std::vector<Mistake> starvation_mistakes() {
  std::vector<Mistake> all{
      starvation("starvation-over-inlet", "h*/h_oil in place of h*/h_ff",
                 [](const std::string& closure, double r, double gamma) -> Value {
                   return r * starvation_ratio(*closure_of(closure), r, gamma);
                 }),
      starvation("starvation-circular-gap",
                 "Crook's constant for a circular contact, 16√2/(3π), in place of 4√2/3",
                 [](const std::string& closure, double r, double) -> Value {
                   if (closure != "flooded_inlet" || r >= 1) return std::nullopt;
                   const double c = crook_constant<double>() * pi / 4;
                   return wolveridge_film_ratio(std::pow((1 / r - 1) * c, 2.0 / 3));
                 }),
      starvation("starvation-exponent-3/2", "ψ^{2/3} for ψ^{3/2} in Crook's gap",
                 [](const std::string& closure, double r, double) -> Value {
                   if (closure != "flooded_inlet" || r >= 1) return std::nullopt;
                   return wolveridge_film_ratio(
                       std::pow((1 / r - 1) * crook_constant<double>(), 1.5));
                 }),
      starvation("starvation-inverted", "r upside down: h_oil/h_ff in place of h_ff/h_oil",
                 [](const std::string& closure, double r, double gamma) -> Value {
                   return starvation_ratio(*closure_of(closure), 1 / r, gamma);
                 }),
      starvation("starvation-never", "the flooded film, no starvation",
                 [](const std::string&, double, double) -> Value { return 1.0; })};
  for (const char* const asked : {"flooded_inlet", "starved_inlet", "printed_exponents", "damiens"})
    for (const char* const given :
         {"flooded_inlet", "starved_inlet", "printed_exponents", "damiens"})
      if (std::string_view(asked) != given) all.push_back(closure_swapped(asked, given));
  return all;
}

struct Sharing {
  bool is_gt;
  double film, stiffness, offset;
};
// λ of ln λ − ln λ₀ + p ln(1 − (K F)^q) = 0, by bisection between what A < 1 allows and enough.
double shared_film(const Sharing& s, Order order, double q, double p) {
  const auto share = [&](double lambda) {
    return std::pow(s.stiffness * gaussian_moment(order, lambda - s.offset), q);
  };
  double floor = 0;
  if (share(0) >= 1) {
    double low = 0, high = s.offset + 50;
    for (int i = 0; i < 200; ++i) (share((low + high) / 2) >= 1 ? low : high) = (low + high) / 2;
    floor = high;
  }
  double low = std::max(floor, 0.0), high = std::max(s.film, floor) + s.offset + 60;
  const auto excess = [&](double lambda) {
    const double a = share(lambda);
    return a >= 1 ? -1 : std::log(lambda / s.film) + p * std::log1p(-a);
  };
  for (int i = 0; i < 200; ++i) (excess((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

template <class Wrong>
Mistake sharing(std::string name, std::string text, Wrong&& wrong) {
  return {"load_sharing", std::move(name), std::move(text),
          [wrong](const json& in, std::string_view) -> Value {
            const Sharing s{in.at("asperity") == "greenwood_tripp",
                            number(in, "flooded_film_parameter"), number(in, "stiffness"),
                            number(in, "offset")};
            // Extreme inputs are not what a mistake is told by.
            if (!(s.film > 1e-8 && s.film < 1e8 && s.stiffness < 1e8)) return std::nullopt;
            return wrong(s);
          }};
}

std::vector<Mistake> sharing_mistakes() {
  const auto order = [](const Sharing& s) {
    return s.is_gt ? Order::five_halves : Order::three_halves;
  };
  const auto q = [](const Sharing& s) { return s.is_gt ? 0.5 : 1.0; };
  return {
      sharing("sharing-none", "λ = λ₀, no load sharing",
              [](const Sharing& s) -> Value { return s.film; }),
      sharing("sharing-q-1", "q = 1 in place of 1/2: (n γ_2)² was taken for n γ_2",
              [=](const Sharing& s) -> Value {
                return s.is_gt ? Value(shared_film(s, order(s), 1, 0.14)) : std::nullopt;
              }),
      sharing("sharing-exponent-0.67", "the film's exponent 0.67 in place of 0.67 − 0.53 = 0.14",
              [=](const Sharing& s) -> Value { return shared_film(s, order(s), q(s), 0.67); }),
      sharing("sharing-offset-ignored", "F at λ in place of λ − δ",
              [=](Sharing s) -> Value {
                s.offset = 0;
                return shared_film(s, order(s), q(s), 0.14);
              }),
      sharing("sharing-offset-doubled", "F at λ − 2δ",
              [=](Sharing s) -> Value {
                s.offset *= 2;
                return shared_film(s, order(s), q(s), 0.14);
              }),
      sharing("sharing-offset-added", "F at λ + δ in place of λ − δ",
              [=](Sharing s) -> Value {
                const auto share = [&](double lambda) {
                  return std::pow(s.stiffness * gaussian_moment(order(s), lambda + s.offset), q(s));
                };
                if (share(0) >= 1) return std::nullopt;
                double low = 0, high = s.film + 60;
                for (int i = 0; i < 200; ++i) {
                  const double middle = (low + high) / 2;
                  (std::log(middle / s.film) + 0.14 * std::log1p(-share(middle)) < 0 ? low : high) =
                      middle;
                }
                return (low + high) / 2;
              }),
      sharing("sharing-stiffness-halved", "K/2: 8√2/15 in place of 16√2/15",
              [=](Sharing s) -> Value {
                s.stiffness /= 2;
                return shared_film(s, order(s), q(s), 0.14);
              }),
      sharing("sharing-stiffness-doubled", "2K: E′ = 2E* in the asperities' load",
              [=](Sharing s) -> Value {
                s.stiffness *= 2;
                return shared_film(s, order(s), q(s), 0.14);
              }),
      sharing("sharing-gw-for-gt",
              "Greenwood and Williamson's F_3/2 and q = 1 for Greenwood and Tripp",
              [](const Sharing& s) -> Value {
                return s.is_gt ? Value(shared_film(s, Order::three_halves, 1, 0.14)) : std::nullopt;
              }),
      sharing("sharing-gt-for-gw",
              "Greenwood and Tripp's F_5/2 and q = 1/2 for Greenwood and Williamson",
              [](const Sharing& s) -> Value {
                return s.is_gt ? std::nullopt
                               : Value(shared_film(s, Order::five_halves, 0.5, 0.14));
              })};
}

}  // namespace

std::vector<Mistake> function_mistakes() {
  std::vector<Mistake> all;
  for (std::vector<Mistake> part : {hertz_mistakes(), film_mistakes(), moment_mistakes(),
                                    starvation_mistakes(), sharing_mistakes()})
    for (Mistake& one : part) all.push_back(std::move(one));
  return all;
}

}  // namespace tribo::conformance
