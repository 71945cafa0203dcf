// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/mistake_entry.hpp"
#include "conformance/solved_mistakes.hpp"
#include "tribo/adhesion.hpp"
#include "tribo/film_regimes.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/liquids.hpp"
#include "tribo/rough_faces.hpp"
#include "tribo/spectral_moments.hpp"
#include "tribo/starvation.hpp"
#include "tribo/two_bodies.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using Constants = std::span<const double>;
using Value = std::optional<double>;

// --- Reduced radius: arguments R₁x, R₂x, R₁y and R₂y. Wrong formulas may give results below 0.

double in_parallel(double a, double b) { return 1 / (1 / a + 1 / b); }
Numbers radii(double x, double y) { return {x, y, in_parallel(x, y)}; }
Numbers right_radii(const Arguments& a) {
  return radii(in_parallel(a[0], a[1]), in_parallel(a[2], a[3]));
}

// --- Ellipse: arguments F, E*, R_x and R_y

// α ≥ 1, the greater radius over the smaller one.
double radii_ratio(const Arguments& a) { return std::max(a[2], a[3]) / std::min(a[2], a[3]); }

// The shape with this k, and K and E of the parameter 1 − 1/k².
EllipseShape<double> shape_of(double k) {
  const auto [b, d] = detail::associated_integrals(k);
  return {k, b + d, b + d / k / k};
}

// The results of a shape, right or wrong, with this R.
Numbers ellipse_with(const Arguments& a, const EllipseShape<double>& shape, double reduced) {
  const double k = shape.ellipticity, pi = std::numbers::pi;
  const double minor = std::cbrt(3 * shape.second_integral * a[0] * reduced / (pi * k * a[1]));
  const bool is_exchanged = a[3] < a[2];
  const double mean = a[0] / (pi * k * minor * minor);
  return {is_exchanged ? k * minor : minor,
          is_exchanged ? minor : k * minor,
          is_exchanged ? 1 / k : k,
          mean,
          1.5 * mean,
          minor * minor * shape.first_integral / (2 * reduced * shape.second_integral)};
}
Numbers ellipse_with(const Arguments& a, const EllipseShape<double>& shape) {
  return ellipse_with(a, shape, in_parallel(a[2], a[3]));
}
Numbers ellipse_with(const Arguments& a, double reduced) {
  return ellipse_with(a, ellipse_shape(radii_ratio(a)), reduced);
}
Numbers right_ellipse(const Arguments& a) { return ellipse_with(a, in_parallel(a[2], a[3])); }

// Integrals of q^power, not of q = 1 − 1/k². 1/2: the modulus √q is taken for q; 2: q for √q.
EllipseShape<double> integrals_of_power(double k, double power) {
  const double q = (k - 1) * (k + 1) / (k * k), wrong = std::pow(q, power);
  // 1 − q^p without the cancellation of long ellipses
  const double complement = power == 0.5 ? 1 / (k * k * (1 + wrong))
                            : power == 2 ? (1 + q) / (k * k)
                                         : 1 - wrong;
  EllipseShape<double> shape = shape_of(1 / std::sqrt(complement));
  shape.ellipticity = k;
  return shape;
}

// The shape for a ratio of radii that is solved with these integrals.
EllipseShape<double> shape_of_power(double ratio, double power) {
  double low = 1, high = 4 * ratio;
  for (double middle = 0; (middle = std::sqrt(low * high)) > low && middle < high;) {
    const EllipseShape<double> shape = integrals_of_power(middle, power);
    const double first = shape.first_integral, second = shape.second_integral;
    const bool is_below = middle * middle * second - first < ratio * (first - second);
    (is_below ? low : high) = middle;
  }
  return integrals_of_power(high, power);
}

// The power mean of R_x and R_y: −1 harmonic, 0 geometric, 1 arithmetic.
double mean_radius(const Arguments& a, double power) {
  return power < 0   ? 2 * in_parallel(a[2], a[3])
         : power > 0 ? (a[2] + a[3]) / 2
                     : std::sqrt(a[2]) * std::sqrt(a[3]);
}

Numbers circle(const Arguments& a, double radius) {
  const HertzPoint<double> hertz = hertz_point(a[0], a[1], radius);
  return {hertz.radius, hertz.radius, 1, hertz.mean_pressure, hertz.peak_pressure, hertz.approach};
}

// --- Moments: arguments n and d

double gaussian(double s) { return std::exp(-s * s / 2) / std::sqrt(2 * std::numbers::pi); }

// F of any order from 0 to 3.5; those past 5/2 by quadrature.
Value moment_of(double order, double d) {
  if (order < 0 || order > 3.5) return std::nullopt;
  if (order > 2.5) return moment_to(order, d, std::max(d, 0.0) + 14);
  return gaussian_moment(static_cast<Order>(static_cast<int>(2 * order)), d);
}

// ∫ sⁿ φ(s) ds over s > d; half orders have no power of s < 0.
Value moment_about_zero(double order, double d) {
  if (order == 0) return gaussian_moment(Order::zero, d);
  if (order == 1) return gaussian(d);
  if (order == 2) return d * gaussian(d) + gaussian_moment(Order::zero, d);
  if (d <= 0) return moment_of(order, 0);
  const int count = 8000;
  const double h = 16.0 / count;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double s = d + (i + 0.5) * h;
    sum += std::pow(s, order) * gaussian(s);
  }
  return sum * h;
}

// --- Regimes: arguments regime, g_V, g_E, α and k

double right_regime(const Arguments& a) {
  return regime_film(static_cast<FilmRegime>(static_cast<int>(a[0])), a[1], a[2], a[3], a[4]);
}

// --- Heated inlet: arguments p₀, E*, S, β, η₀, u and k_f

double heating(const Arguments& a, double speeds) { return a[3] * a[4] * speeds / a[6]; }
double thermal(const Arguments& a, double l, Constants n) {
  return (1 - n[0] * a[0] / (2 * a[1]) * std::pow(l, n[1])) /
         (1 + n[2] * (1 + n[3] * std::pow(a[2], n[4])) * std::pow(l, n[5]));
}

// --- A heated inlet of pure rolling: arguments β, η₀, u and k_f

double rolling_heat(const Arguments& a, double speeds) { return a[0] * a[1] * speeds / a[3]; }
double rolling(double l, double factor, double power) {
  return 1 / (1 + factor * std::pow(l, power));
}

// --- Carreau and Yasuda: arguments η₀, η_∞, λ, γ̇, a and n

double thinned(const Arguments& a, double exponent) {
  return std::pow(1 + std::pow(a[2] * a[3], a[4]), exponent);
}

// --- Rough faces

// `numbers`: factor and exponent below 1, from 1 to 6, and beyond.
double load_of_rows(double x, Constants numbers) {
  const std::size_t row = x < 1 ? 0 : x < second_kogut_etsion_interference ? 2 : 4;
  return numbers[row] * std::pow(x, numbers[row + 1]);
}
double relative_pressure(const Arguments& a) { return a[0] / (a[1] * a[2]); }
Numbers lambda_of(const Arguments& a, double rough) { return {rough, a[0] / rough}; }

// --- D341: arguments T₁, ν₁, T₂, ν₂ and T

// A straight line of y(ν) over x(T); ν in mm²/s.
template <class Of, class OfTemperature, class Inverse>
Value d341(const Arguments& a, const Of& y, const OfTemperature& x, const Inverse& viscosity) {
  const double first = y(1e6 * a[1]), second = y(1e6 * a[3]);
  const double part = (x(a[4]) - x(a[0])) / (x(a[2]) - x(a[0]));
  const double found = 1e-6 * viscosity(first + part * (second - first));
  return std::isfinite(found) ? Value(found) : std::nullopt;
}
double natural_log(double x) { return std::log(x); }
// The offset is added to the viscosity in mm²/s.
auto log_log(Constants offset) {
  return [=](double viscosity) { return std::log(std::log(viscosity + offset[0])); };
}
auto without_log_log(Constants offset) {
  return [=](double y) { return std::exp(std::exp(y)) - offset[0]; };
}

// --- Viscosity index: arguments ν at 40 and at 100 °C

// The index `above`(H/U, Y) where U is below H; else the right index.
template <class Above>
Value index_of(const Arguments& a, const Above& above) {
  const double hundred = detail::index_oils(a[1]).hundred, u = 1e6 * a[0];
  return u < hundred ? above(hundred / u, 1e6 * a[1]) : viscosity_index(a[0], a[1]);
}

// --- Summits: arguments m₀, m₂ and m₄

Numbers right_summits(const Arguments& a) {
  const Summits<double> s = summits_from_spectral_moments(a[0], a[1], a[2]);
  return {s.bandwidth, s.summit_density, s.summit_radius, s.summit_height_sd,
          s.summit_plane_offset};
}

// --- The table

std::optional<Numbers> results_of(const std::optional<Numbers>& results) { return results; }
std::optional<Numbers> results_of(Value only) {
  return only ? std::optional(Numbers{*only}) : std::nullopt;
}

struct NamedFormula {
  // `made_as` is a lambda that gives all results, the only one, or nothing.
  template <class Lambda>
  constexpr NamedFormula(std::string_view of, std::string_view called, std::size_t count,
                         Lambda /*made_as*/, std::span<const double> of_law = {})
      : function(of),
        name(called),
        numbers(count),
        right(of_law),
        formula([](const Arguments& a, Constants c) { return results_of(Lambda{}(a, c)); }) {}

  std::string_view function, name;
  std::size_t numbers;
  std::span<const double> right;  // with these the formula is the law; empty: it never is
  FunctionFormula formula;
};

// The numbers of laws, as their sources print them, in the order of the formulas below.
constexpr std::array<double, 6> gupta{13.2, 0.42, 0.213, 2.23, 0.83, 0.64};
constexpr std::array<double, 6> regime{0.131, 1.683, 0.68, 0.0387, 0.85, 0.31};
constexpr std::array<double, 2> dowson_higginson{5.9e8, 1.34};
constexpr std::array<double, 4> roelands{1.96e8, 1, 1, 9.67};
constexpr std::array<double, 1> walther{0.7};
constexpr std::array<double, 2> rolling_inlet{3.94, 0.62};
constexpr std::array<double, 2> jkr{3, 1};
constexpr std::array<double, 1> plasticity{0.5};
constexpr std::array<double, 6> kogut_etsion{1, 1.5, 1.03, 1.425, 1.40, 1.263};
constexpr std::array<double, 2> patir_cheng{0.9, 0.56};

constexpr NamedFormula formulas[] = {
    // E₁, ν₁, E₂ and ν₂
    {"effective_modulus", "modulus_by_one_minus_ratio", 0,
     [](const Arguments& a, Constants) { return 1 / ((1 - a[1]) / a[0] + (1 - a[3]) / a[2]); }},
    {"effective_modulus", "modulus_added", 1,
     [](const Arguments& a, Constants factor) {
       return factor[0] * (a[0] / (1 - a[1] * a[1]) + a[2] / (1 - a[3] * a[3]));
     }},
    {"effective_modulus", "modulus_of_one_ratio", 0,
     [](const Arguments& a, Constants) { return effective_modulus(a[0], a[1], a[2], a[1]); }},
    {"effective_modulus", "modulus_of_mean_ratio", 0,
     [](const Arguments& a, Constants) {
       const double mean = (a[1] + a[3]) / 2;
       return effective_modulus(a[0], mean, a[2], mean);
     }},
    {"effective_modulus", "modulus_of_first_twice", 0,
     [](const Arguments& a, Constants) { return effective_modulus(a[0], a[1], a[0], a[1]); }},

    {"reduced_radius", "radii_of_difference", 0,
     [](const Arguments& a, Constants) {
       return radii(in_parallel(a[0], -a[1]), in_parallel(a[2], -a[3]));
     }},
    {"reduced_radius", "radii_added", 1,
     [](const Arguments& a, Constants factor) {
       return radii(factor[0] * (a[0] + a[1]), factor[0] * (a[2] + a[3]));
     }},
    {"reduced_radius", "radii_of_first", 0,
     [](const Arguments& a, Constants) { return radii(a[0], a[2]); }},
    {"reduced_radius", "radii_exchanged", 0,
     [](const Arguments& a, Constants) {
       return right_radii({a[2], a[3], a[0], a[1]});
     }},
    {"reduced_radius", "radii_without_sign", 0,
     [](const Arguments& a, Constants) {
       return right_radii({std::abs(a[0]), std::abs(a[1]), std::abs(a[2]), std::abs(a[3])});
     }},
    // Wrong ways to make R of R_x and R_y, which are right.
    {"reduced_radius", "radius_as_mean", 0,
     [](const Arguments& a, Constants) {
       Numbers right = right_radii(a);
       right[2] = (right[0] + right[1]) / 2;
       return right;
     }},
    {"reduced_radius", "radius_as_geometric_mean", 0,
     [](const Arguments& a, Constants) {
       Numbers right = right_radii(a);
       right[2] = std::sqrt(right[0]) * std::sqrt(right[1]);
       return right;
     }},
    {"reduced_radius", "radius_along_x", 0,
     [](const Arguments& a, Constants) {
       Numbers right = right_radii(a);
       right[2] = right[0];
       return right;
     }},

    {"hertz_ellipse", "ellipse_of_parameter_power", 1,
     [](const Arguments& a, Constants power) -> std::optional<Numbers> {
       const double ratio = radii_ratio(a);
       if (!(ratio > 1)) return std::nullopt;  // 0/0
       return ellipse_with(a, shape_of_power(ratio, power[0]));
     }},
    {"hertz_ellipse", "ellipse_of_parameter_power_at_right_k", 1,
     [](const Arguments& a, Constants power) -> std::optional<Numbers> {
       const double k = ellipse_shape(radii_ratio(a)).ellipticity;
       if (!(k > 1)) return std::nullopt;
       return ellipse_with(a, integrals_of_power(k, power[0]));
     }},
    // cos τ = (α − 1)/(α + 1), times a factor.
    {"hertz_ellipse", "ellipse_of_auxiliary_angle", 1,
     [](const Arguments& a, Constants factor) -> std::optional<Numbers> {
       const double ratio = radii_ratio(a), cosine = factor[0] * (ratio - 1) / (ratio + 1);
       if (!(cosine < 1)) return std::nullopt;
       return ellipse_with(a, ellipse_shape((1 + cosine) / (1 - cosine)));
     }},
    // k = c α^e, K = f + g ln α, E = h + i/α.
    {"hertz_ellipse", "ellipse_of_fits", 6,
     [](const Arguments& a, Constants fit) {
       const double ratio = radii_ratio(a);
       return ellipse_with(
           a, EllipseShape<double>{fit[0] * std::pow(ratio, fit[1]),
                                   fit[2] + fit[3] * std::log(ratio), fit[4] + fit[5] / ratio});
     }},
    {"hertz_ellipse", "ellipse_of_fitted_ratio", 2,
     [](const Arguments& a, Constants fit) {
       return ellipse_with(a, shape_of(fit[0] * std::pow(radii_ratio(a), fit[1])));
     }},
    // a³ = E·3FR/(πkE*) with E = (π/2)/k² · (1 + 2(k² − 1)/π + ¼ ln k).
    {"hertz_ellipse", "ellipse_of_logarithms", 0,
     [](const Arguments& a, Constants) {
       const double ratio = radii_ratio(a), pi = std::numbers::pi;
       const double k = 1 + std::sqrt(std::log(16 * ratio) * ratio / 2) - std::sqrt(std::log(4)) -
                        0.16 * std::log(ratio);
       EllipseShape<double> shape = shape_of(k);
       shape.second_integral = pi / 2 / (k * k) * (1 + 2 * (k * k - 1) / pi + 0.25 * std::log(k));
       return ellipse_with(a, shape);
     }},
    {"hertz_ellipse", "ellipse_exchanged", 0,
     [](const Arguments& a, Constants) {
       return right_ellipse({a[0], a[1], a[3], a[2]});
     }},
    {"hertz_ellipse", "ellipse_of_greater_ratio", 0,
     [](const Arguments& a, Constants) {
       Numbers right = right_ellipse(a);
       right[2] = std::max(right[2], 1 / right[2]);
       return right;
     }},
    {"hertz_ellipse", "ellipse_eccentricity", 0,
     [](const Arguments& a, Constants) {
       Numbers right = right_ellipse(a);
       const double k = std::max(right[2], 1 / right[2]);
       right[2] = std::sqrt((k - 1) * (k + 1)) / k;
       return right;
     }},
    {"hertz_ellipse", "ellipse_mean_from_peak", 0,
     [](const Arguments& a, Constants) {
       Numbers right = right_ellipse(a);
       right[3] *= right[4] / a[0];  // the area is F/p_mean
       return right;
     }},
    {"hertz_ellipse", "ellipse_with_radius_x", 0,
     [](const Arguments& a, Constants) { return ellipse_with(a, a[2]); }},
    {"hertz_ellipse", "ellipse_with_smaller_radius", 0,
     [](const Arguments& a, Constants) { return ellipse_with(a, std::min(a[2], a[3])); }},
    {"hertz_ellipse", "ellipse_with_multiple_of_radius", 1,
     [](const Arguments& a, Constants factor) {
       return ellipse_with(a, factor[0] * in_parallel(a[2], a[3]));
     }},
    {"hertz_ellipse", "ellipse_with_mean_radius", 1,
     [](const Arguments& a, Constants power) { return ellipse_with(a, mean_radius(a, power[0])); }},
    {"hertz_ellipse", "ellipse_as_circle_of_mean_radius", 1,
     [](const Arguments& a, Constants power) { return circle(a, mean_radius(a, power[0])); }},
    {"hertz_ellipse", "ellipse_as_circle_of_reduced_radius", 0,
     [](const Arguments& a, Constants) { return circle(a, in_parallel(a[2], a[3])); }},
    {"hertz_ellipse", "ellipse_as_circle_of_radius_x", 0,
     [](const Arguments& a, Constants) { return circle(a, a[2]); }},
    {"hertz_ellipse", "ellipse_with_approach_of_circle", 1,
     [](const Arguments& a, Constants power) {
       Numbers right = right_ellipse(a);
       right[5] = hertz_point(a[0], a[1], mean_radius(a, power[0])).approach;
       return right;
     }},

    {"gaussian_moment", "moment_of_order", 1,
     [](const Arguments& a, Constants shift) { return moment_of(a[0] + shift[0], a[1]); }},
    {"gaussian_moment", "moment_about_zero", 0,
     [](const Arguments& a, Constants) { return moment_about_zero(a[0], a[1]); }},
    {"gaussian_moment", "moment_zero_beyond", 1,
     [](const Arguments& a, Constants end) { return a[1] > end[0] ? 0 : *moment_of(a[0], a[1]); }},
    {"gaussian_moment", "moment_over_root", 0,
     [](const Arguments& a, Constants) {
       return a[1] > 0 ? Value(*moment_of(a[0], a[1]) / std::sqrt(a[1])) : std::nullopt;
     }},
    // The fits c (d₁ − d)^e and c e^{−bd} say nothing outside their ranges of d.
    {"gaussian_moment", "moment_power_fit", 3,
     [](const Arguments& a, Constants numbers) -> Value {
       if (a[1] < 0 || a[1] > numbers[1]) return std::nullopt;
       return numbers[0] * std::pow(numbers[1] - a[1], numbers[2]);
     }},
    {"gaussian_moment", "moment_exponential_fit", 2,
     [](const Arguments& a, Constants numbers) -> Value {
       if (a[1] < 0 || a[1] > 40) return std::nullopt;
       return numbers[0] * std::exp(-numbers[1] * a[1]);
     }},
    {"gaussian_moment", "moment_error_function_fit", 0,
     [](const Arguments& a, Constants) -> Value {
       if (a[1] < 0 || a[1] > 4) return std::nullopt;
       return *moment_of(a[0], 0) * std::erfc(a[1]);
     }},

    // Arguments closure, r and γ. The first formula has Crook's constant of a circular gap.
    {"starvation_ratio", "inlet_with_circular_gap", 0,
     [](const Arguments& a, Constants) {
       const auto closure = static_cast<StarvationClosure>(static_cast<int>(a[0]));
       return InletCurve<double>{closure, std::numbers::pi / 4}.film_ratio(a[1]);
     }},
    {"starvation_ratio", "inlet_with_inverse_exponent", 0,
     [](const Arguments& a, Constants) -> Value {
       if (a[1] >= 1) return std::nullopt;
       return wolveridge_film_ratio(std::pow((1 / a[1] - 1) * crook_constant<double>(), 1.5));
     }},

    {"regime_film", "regime_with_inverse_phi", 0,
     [](const Arguments& a, Constants) -> Value {
       if (static_cast<FilmRegime>(static_cast<int>(a[0])) != FilmRegime::isoviscous_rigid)
         return std::nullopt;
       const double ratio = 1 + 2 / (3 * a[3]);
       return right_regime(a) * std::pow(ratio, 4);
     }},
    // Number: the power of k that is taken for R_y/R_x.
    {"regime_film", "regime_with_power_of_ellipticity", 1,
     [](const Arguments& a, Constants power) {
       return right_regime({a[0], a[1], a[2], std::pow(a[4], power[0]), a[4]});
     }},
    {"regime_film", "regime_with_inverse_in_phi", 0,
     [](const Arguments& a, Constants) {
       const double ratio = (1 + 2 / (3 * a[3])) / (1 + 2 * a[3] / 3);
       return right_regime(a) * ratio * ratio;
     }},
    // Numbers: two of the isoviscous rigid law's arctan term, then those of k or α in others.
    {"regime_film", "regime_of_numbers", regime.size(),
     [](const Arguments& a, Constants n) {
       const auto side = [&](double weight, double decay, double of) {
         return 1 - weight * std::exp(-decay * of);
       };
       switch (static_cast<FilmRegime>(static_cast<int>(a[0]))) {
         case FilmRegime::isoviscous_rigid: {
           const auto root = [&](Constants of) { return of[0] * std::atan(a[3] / 2) + of[1]; };
           const double ratio = root(n) / root(tribo::conformance::regime);
           return right_regime(a) * ratio * ratio;
         }
         case FilmRegime::viscous_rigid_roelands:
           return right_regime(a) * side(1, n[3], a[3]) / side(1, 0.0387, a[3]);
         case FilmRegime::isoviscous_elastic:
           return right_regime(a) * side(n[4], n[5], a[4]) / side(0.85, 0.31, a[4]);
         default:
           return right_regime(a) * side(1, n[2], a[4]) / side(1, 0.68, a[4]);
       }
     }},

    {"gupta_thermal_reduction", "thermal_with_speed_once", gupta.size(),
     [](const Arguments& a, Constants numbers) { return thermal(a, heating(a, a[5]), numbers); }},
    {"gupta_thermal_reduction", "thermal_of_numbers", gupta.size(),
     [](const Arguments& a, Constants numbers) {
       return thermal(a, heating(a, a[5] * a[5]), numbers);
     },
     gupta},
    {"gupta_thermal_reduction", "thermal_of_murch_and_wilson", 0,
     [](const Arguments& a, Constants) {
       const double l = heating(a, a[5] * a[5]);
       return 1 / (1 + 0.1 * (1 + 14.8 * std::pow(a[2], 0.83)) * std::pow(l, 0.64));
     }},

    {"murch_wilson_thermal_reduction", "rolling_with_speed_once", rolling_inlet.size(),
     [](const Arguments& a, Constants numbers) {
       return rolling(rolling_heat(a, a[2]), 1 / numbers[0], numbers[1]);
     }},
    // Numbers: the factor of L, and its power.
    {"murch_wilson_thermal_reduction", "rolling_of_numbers", 2,
     [](const Arguments& a, Constants numbers) {
       return rolling(rolling_heat(a, a[2] * a[2]), numbers[0], numbers[1]);
     }},
    {"murch_wilson_thermal_reduction", "rolling_as_printed", rolling_inlet.size(),
     [](const Arguments& a, Constants numbers) {
       return rolling(rolling_heat(a, a[2] * a[2]), 1 / numbers[0], numbers[1]);
     },
     rolling_inlet},
    {"murch_wilson_thermal_reduction", "rolling_inverted", rolling_inlet.size(),
     [](const Arguments& a, Constants numbers) {
       return 1 / rolling(rolling_heat(a, a[2] * a[2]), 1 / numbers[0], numbers[1]);
     }},

    // Numbers n and m: a³ = 3R/(4E*) [F + n πwR + m √(6πwRF + (3πwR)²)]; empty unless a³ > 0.
    {"jkr_radius", "jkr_of_loads", 2,
     [](const Arguments& a, Constants numbers) {
       const double adhesive = std::numbers::pi * a[1] * a[3];
       const double load = a[0] + numbers[0] * adhesive +
                           numbers[1] * std::sqrt(adhesive * (6 * a[0] + 9 * adhesive));
       return load > 0 ? Value(std::cbrt(0.75 * a[3] / a[2] * load)) : std::nullopt;
     },
     jkr},
    {"jkr_radius", "jkr_cubed", 0,
     [](const Arguments& a, Constants) {
       const double radius = jkr_radius(a[0], a[1], a[2], a[3]);
       return radius * radius * radius;
     }},

    // Numbers x, y and z of the exponent (x n + y)/z; where z is 0, it is (x n + y)/a.
    {"carreau_yasuda_viscosity", "carreau_of_exponent", 3,
     [](const Arguments& a, Constants numbers) {
       const double divisor = numbers[2] == 0 ? a[4] : numbers[2];
       return a[1] + (a[0] - a[1]) * thinned(a, (numbers[0] * a[5] + numbers[1]) / divisor);
     }},
    {"carreau_yasuda_viscosity", "carreau_as_cross", 0,
     [](const Arguments& a, Constants) {
       return a[1] + (a[0] - a[1]) / (1 + std::pow(a[2] * a[3], 1 - a[5]));
     }},

    {"plasticity_index", "plasticity_of_power", 1,
     [](const Arguments& a, Constants power) {
       return a[0] / a[1] * std::pow(a[2] / a[3], power[0]);
     },
     plasticity},
    {"kogut_etsion_load", "kogut_of_rows", 6,
     [](const Arguments& a, Constants numbers) { return load_of_rows(a[0], numbers); },
     kogut_etsion},
    {"persson_contact_area", "persson_of_factor", 1,
     [](const Arguments& a, Constants factor) {
       return std::erf(factor[0] * relative_pressure(a));
     }},
    // Numbers: the factor of the relative pressure, and the greatest area.
    {"persson_contact_area", "persson_linear", 2,
     [](const Arguments& a, Constants numbers) {
       return std::min(numbers[1], numbers[0] * relative_pressure(a));
     }},
    {"persson_contact_area", "persson_complement", 0,
     [](const Arguments& a, Constants) {
       return std::erfc(std::numbers::sqrt2 * relative_pressure(a));
     }},
    // Numbers: the factor of the exponential, and the factor of H in it.
    {"patir_cheng_pressure_flow", "flow_of_numbers", 2,
     [](const Arguments& a, Constants numbers) {
       return 1 - numbers[0] * std::exp(-numbers[1] * a[0]);
     },
     patir_cheng},
    {"patir_cheng_pressure_flow", "flow_shortage", 2,
     [](const Arguments& a, Constants numbers) { return numbers[0] * std::exp(-numbers[1] * a[0]); }},
    // Numbers n and m of (m (Rq₁ⁿ + Rq₂ⁿ))^(1/n).
    {"lambda_ratio", "lambda_of_norm", 2,
     [](const Arguments& a, Constants numbers) {
       const double sum = std::pow(a[1], numbers[0]) + std::pow(a[2], numbers[0]);
       return lambda_of(a, std::pow(numbers[1] * sum, 1 / numbers[0]));
     }},
    {"lambda_ratio", "lambda_of_first_face", 0,
     [](const Arguments& a, Constants) { return lambda_of(a, a[1]); }},

    {"dowson_higginson_density", "density_of_numbers", 2,
     [](const Arguments& a, Constants numbers) {
       return 1 + numbers[0] * a[0] / (1 + numbers[1] * a[0]);
     }},
    {"dowson_higginson_density", "density_of_ratio", 2,
     [](const Arguments& a, Constants n) { return (n[0] + n[1] * a[0]) / (n[0] + a[0]); },
     dowson_higginson},
    // Numbers: K′ and K of Murnaghan's (1 + K′p/K)^(1/K′).
    {"dowson_higginson_density", "density_of_murnaghan", 2,
     [](const Arguments& a, Constants numbers) {
       return std::pow(1 + numbers[0] * a[0] / numbers[1], 1 / numbers[0]);
     }},
    {"barus_viscosity", "barus_power_of_viscosity", 0,
     [](const Arguments& a, Constants) { return std::pow(a[0], a[1] * a[2]); }},
    {"barus_viscosity", "barus_linear", 0,
     [](const Arguments& a, Constants) { return a[0] * (1 + a[1] * a[2]); }},
    // Numbers p, f, g and c: p_R = p and z = g α p/(f ln η₀ + c); the law has f = g = 1.
    {"roelands_viscosity", "roelands_of_numbers", roelands.size(),
     [](const Arguments& a, Constants numbers) {
       const double scale = std::log(a[0]) * numbers[1] + numbers[3];
       const double z = numbers[2] * a[1] * numbers[0] / scale;
       return a[0] * std::exp(scale * (std::pow(1 + a[2] / numbers[0], z) - 1));
     },
     roelands},
    // Numbers: z, p_R and 9.67.
    {"roelands_viscosity", "roelands_of_exponent", 3,
     [](const Arguments& a, Constants n) {
       const double power = std::pow(1 + a[2] / n[1], n[0]);
       return a[0] * std::exp((std::log(a[0]) + n[2]) * (power - 1));
     }},
    {"roelands_viscosity", "roelands_in_millipascal", 0,
     [](const Arguments& a, Constants) {
       return viscosity_at(ViscosityLaw::roelands, 1e3 * a[0], a[1], a[2]) / 1e3;
     }},
    {"astm_d341_viscosity", "d341_with_offset", 1,
     [](const Arguments& a, Constants offset) {
       return d341(a, log_log(offset), natural_log, without_log_log(offset));
     },
     walther},
    {"astm_d341_viscosity", "d341_with_sum", 1,
     [](const Arguments& a, Constants offset) {
       return d341(a, log_log(offset), natural_log, [](double y) { return std::exp(std::exp(y)); });
     }},
    {"astm_d341_viscosity", "d341_in_celsius", 1,
     [](const Arguments& a, Constants offset) {
       return d341(
           a, log_log(offset), [](double t) { return std::log(t - 273.15); },
           without_log_log(offset));
     }},
    // Numbers: the offset, and the power of T.
    {"astm_d341_viscosity", "d341_over_power", 2,
     [](const Arguments& a, Constants n) {
       return d341(
           a, log_log(n), [&](double t) { return std::pow(t, n[1]); }, without_log_log(n));
     }},
    {"astm_d341_viscosity", "d341_with_one_logarithm", 1,
     [](const Arguments& a, Constants offset) {
       return d341(
           a, [=](double viscosity) { return std::log(viscosity + offset[0]); }, natural_log,
           [=](double y) { return std::exp(y) - offset[0]; });
     }},

    {"viscosity_index", "index_of_difference", 0,
     [](const Arguments& a, Constants) {
       const auto oils = detail::index_oils(a[1]);
       return 100 * (oils.zero - 1e6 * a[0]) / (oils.zero - oils.hundred);
     }},
    {"viscosity_index", "index_of_power_below_100", 0,
     [](const Arguments& a, Constants) -> Value {
       const auto oils = detail::index_oils(a[1]);
       const double u = 1e6 * a[0], power = std::log(oils.hundred / u) / std::log(1e6 * a[1]);
       if (!(u >= oils.hundred && u < oils.zero)) return viscosity_index(a[0], a[1]);
       return (std::pow(10, power) - 1) / 0.00715 + 100;
     }},
    // Numbers b, c and d of the index (bᴺ − 1)/d + c.
    {"viscosity_index", "index_of_power", 3,
     [](const Arguments& a, Constants numbers) {
       return index_of(a, [&](double ratio, double y) {
         const double power = std::log(ratio) / std::log(y);
         return (std::pow(numbers[0], power) - 1) / numbers[2] + numbers[1];
       });
     }},
    // Number: the factor of Y in N = ln(H/U)/ln Y.
    {"viscosity_index", "index_of_other_unit", 1,
     [](const Arguments& a, Constants unit) {
       return index_of(a, [&](double ratio, double y) {
         return (std::pow(10, std::log(ratio) / std::log(unit[0] * y)) - 1) / 0.00715 + 100;
       });
     }},
    {"viscosity_index", "index_of_inverse_ratio", 0,
     [](const Arguments& a, Constants) {
       return index_of(a, [](double ratio, double y) {
         return (std::pow(10, -std::log(ratio) / std::log(y)) - 1) / 0.00715 + 100;
       });
     }},

    // Numbers: not 0 for each moment in whose place its root is taken.
    {"summits_from_spectral_moments", "summits_of_roots", 3,
     [](const Arguments& a, Constants are_roots) {
       Arguments misread = a;
       for (std::size_t i = 0; i < 3; ++i)
         if (are_roots[i] != 0) misread[i] = std::sqrt(a[i]);
       const Numbers results = right_summits(misread);
       return results[0] > 0 ? std::optional(results) : std::nullopt;
     }},
    // Numbers, not 0 if so: √m₀ is answered for σ_s; the offset is divided by √m₀, not by σ_s.
    {"summits_from_spectral_moments", "summits_of_all_heights", 2,
     [](const Arguments& a, Constants where) {
       Numbers results = right_summits(a);
       const double sd = std::sqrt(a[0]);
       if (where[1] != 0) results[4] *= results[3] / sd;
       if (where[0] != 0) results[3] = sd;
       return results;
     }},
};

}  // namespace

std::pair<FunctionFormula, std::span<const double>> formula_of_law(std::string_view function) {
  for (const NamedFormula& one : formulas)
    if (one.function == function && !one.right.empty()) return {one.formula, one.right};
  return {nullptr, {}};
}

FunctionFormula find_formula(std::string_view function, std::string_view name,
                             std::size_t numbers) {
  for (const NamedFormula& one : formulas)
    if (one.function == function && one.name == name && one.numbers == numbers) return one.formula;
  return nullptr;
}

}  // namespace tribo::conformance
