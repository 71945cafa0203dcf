// SPDX-License-Identifier: Apache-2.0
// Diagnoses of causes that the list of mistakes lacks: other terms, factors and powers of a law,
// another end of an integral, inverted answers. The wrong solvers are written here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "conformance/answers.hpp"
#include "conformance/expression.hpp"
#include "conformance/question.hpp"
#include "support/judge.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using std::exp, std::log, std::pow, std::sqrt;
constexpr double pi = std::numbers::pi;

struct In {
  const json& inputs;
  double operator()(const char* name) const { return inputs.at(name).get<double>(); }
};
using Formula = std::function<json(const In& in)>;

// The results of the right function at inputs that `slip` changes.
Numbers results_of(
    const char* function, const In& in,
    const std::function<void(json& inputs)>& slip = [](json&) {}) {
  TestCase asked;
  asked.inputs = in.inputs;
  slip(asked.inputs);
  asked.in_catalogue = catalogue::function_named(function);
  return right_numbers(question_of(asked));
}

std::string said_of(const std::string& function, const Formula& formula) {
  const auto answer = [&](const TestCase& one) {
    if (one.function != function) return json();
    const json given = formula({one.inputs});
    return given.is_number() ? json{{"value", given}} : given;
  };
  return all_said(answer);
}

struct Slip {
  const char* function;
  const char* words;  // that the diagnosis has to have
  Formula formula;
};

void expect_told(const std::vector<Slip>& slips) {
  for (const Slip& slip : slips) {
    const std::string said = said_of(slip.function, slip.formula);
    EXPECT_NE(said.find(slip.words), std::string::npos)
        << slip.function << ", not said: " << slip.words << "\nsaid: " << said;
    expect_said(said, "None of the known", false);
    for (const Slip& other : slips) {
      if (said.find(slip.words) == std::string::npos || &other == &slip) continue;
      EXPECT_TRUE(std::string(other.words).find(slip.words) != std::string::npos ||
                  std::string(slip.words).find(other.words) != std::string::npos ||
                  said.find(other.words) == std::string::npos)
          << slip.words << ", but also: " << other.words;
    }
  }
}

double density(double s) { return exp(-s * s / 2) / sqrt(2 * pi); }
double tail(double d) { return std::erfc(d / std::numbers::sqrt2) / 2; }

TEST(LawExpressions, AreTheLawsOfTheCatalogue) {
  std::size_t count = 0;
  for (const catalogue::Function& function : catalogue::functions()) {
    const auto law = law_expression(function);
    if (!law) continue;
    ++count;
    ASSERT_EQ(law->results.size(), function.results.size()) << function.name;
    for (const TestCase& one : cases_of(function.name)) {
      const Question asked = question_of(one);
      for (const Expected& expected : one.expected) {
        const double value = law->value(law->results[*expected.place], asked.arguments);
        const double right = right_numbers(asked)[*expected.place];
        // For large d a moment is a difference of nearly equal terms, which loses digits.
        const double allowed = 1e-9 * std::abs(right) * expected.condition +
                               (function.name == "gaussian_moment" ? 1e-12 : 0);
        EXPECT_LE(std::abs(value - right), allowed)
            << function.name << '.' << expected.field << ' ' << one.inputs.dump() << ": got "
            << value << ", expected " << right;
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GE(count, 30U);
}

TEST(Terms, ThatAreLeftOutOrOfTheWrongSignAreTold) {
  expect_told(
      {{"gaussian_moment", "+ d Q(d) in place of − d Q(d)",
        [](const In& in) -> json {
          const double d = in("argument");
          return in("order") == 1 ? json(density(d) + d * tail(d)) : json();
        }},
       {"gaussian_moment", "d² in place of d, in d φ(d)",
        [](const In& in) -> json {
          const double d = in("argument");
          return in("order") == 2 ? json((1 + d * d) * tail(d) - d * d * density(d)) : json();
        }},
       {"roelands_viscosity", "no term −1, in −1 + ",
        [](const In& in) -> json {
          const double scale = log(in("viscosity")) + 9.67;
          const double z = in("pressure_viscosity") * 1.96e8 / scale;
          const double value = in("viscosity") * exp(scale * pow(1 + in("pressure") / 1.96e8, z));
          return std::isfinite(value) ? json(value) : json();
        }},
       {"lambda_ratio", "with 1/Rq² in place of 1/Rq, in h_min/Rq (",
        [](const In& in) -> json {
          const double square = pow(in("first_roughness"), 2) + pow(in("second_roughness"), 2);
          return {{"composite_roughness", sqrt(square)},
                  {"lambda_ratio", in("minimum_film") / square}};
        }},
       {"effective_modulus", "(1 − ν₁)² in place of 1 − ν₁²", [](const In& in) -> json {
          return 1 / (pow(1 - in("first_poisson_ratio"), 2) / in("first_modulus") +
                      pow(1 - in("second_poisson_ratio"), 2) / in("second_modulus"));
        }}});
}

TEST(Parentheses, ThatAreLeftOutAreTold) {
  const auto heat = [](const In& in) {
    return in("temperature_viscosity") * in("viscosity") * pow(in("speed"), 2) /
           in("thermal_conductivity");
  };
  expect_told(
      {{"gupta_thermal_reduction", "+ 0.213 (1 + 2.23 S^0.83) L^0.64 in place of ",
        [=](const In& in) -> json {
          const double l = heat(in);
          return 1 - 6.6 * in("peak_pressure") / in("effective_modulus") * pow(l, 0.42) +
                 0.213 * (1 + 2.23 * pow(in("slide_roll_ratio"), 0.83)) * pow(l, 0.64);
        }},
       {"carreau_yasuda_viscosity", " + n in place of (−1 + n)/a",
        [](const In& in) -> json {
          const double a = in("transition_exponent"), n = in("power_law_index");
          const double rest = in("high_shear_viscosity");
          return rest + (in("viscosity") - rest) *
                            pow(1 + pow(in("relaxation_time") * in("shear_rate"), a), n - 1 / a);
        }},
       {"murch_wilson_thermal_reduction", "(3.94 + L)^0.62 in place of 3.94 + L^0.62",
        [=](const In& in) { return 3.94 / pow(3.94 + heat(in), 0.62); }},
       {"carreau_yasuda_viscosity", "λ (γ̇)^(a) in place of (λ γ̇)^(a)",
        [](const In& in) {
          const double a = in("transition_exponent"), rest = in("high_shear_viscosity");
          return rest + (in("viscosity") - rest) *
                            pow(1 + in("relaxation_time") * pow(in("shear_rate"), a),
                                (in("power_law_index") - 1) / a);
        }},
       {"hamrock_dowson_minimum", "k e^(−0.68) in place of e^(−0.68 k)", [](const In& in) -> json {
          const double modulus = 2 * in("effective_modulus"), radius = in("radius_x");
          return radius * 3.63 * pow(in("speed") * in("viscosity") / modulus / radius, 0.68) *
                 pow(in("pressure_viscosity") * modulus, 0.49) *
                 pow(in("load") / modulus / radius / radius, -0.073) *
                 (1 - exp(-0.68) * in.inputs.value("ellipticity", 1.0));
        }}});
}

TEST(Powers, OfInputsAndOfFactorsAreTold) {
  expect_told(
      {{"patir_cheng_pressure_flow", "H² in place of H (",
        [](const In& in) { return 1 - 0.9 * exp(-0.56 * pow(in("film_ratio"), 2)); }},
       {"patir_cheng_pressure_flow", "H^(3/2) in place of H, in −0.56 H",
        [](const In& in) { return 1 - 0.9 * exp(-0.56 * pow(in("film_ratio"), 1.5)); }},
       {"hertz_point", "1/R in place of R (",
        [](const In& in) -> json {
          const double r = 1 / in("reduced_radius"), f = in("load");
          const double a = std::cbrt(0.75 * f * r / in("effective_modulus"));
          const double mean = f / (pi * a * a);
          return {{"radius", a},
                  {"mean_pressure", mean},
                  {"peak_pressure", 1.5 * mean},
                  {"approach", a * a / r}};
        }},
       {"hertz_point", "with 1/a in place of 1/a², in p̄ (",
        [](const In& in) -> json {
          const double r = in("reduced_radius"), f = in("load");
          const double a = std::cbrt(0.75 * f * r / in("effective_modulus"));
          const double mean = f / (pi * a);
          return {{"radius", a},
                  {"mean_pressure", mean},
                  {"peak_pressure", 1.5 * mean},
                  {"approach", a * a / r}};
        }},
       {"moes_line", "1.311 M^(3/4)/L^0.125 in place of 1.311 L^(3/4)/M^0.125",
        [](const In& in) {
          const double modulus = 2 * in("effective_modulus"), r = in("reduced_radius");
          const double u = 2 * in("speed") * in("viscosity") / (modulus * r);
          const double m = in("load_per_length") / (modulus * r) / sqrt(u);
          const double l = in("pressure_viscosity") * modulus * pow(u, 0.25);
          const double ri = 3 / m, ei = 2.621 * pow(m, -0.2), rp = 1.287 * pow(l, 2. / 3);
          const double ep = 1.311 * pow(m, 0.75) * pow(l, -0.125);
          const double s = (7 + 8 * exp(-2 * ei / ri)) / 5;
          const double rigid = pow(pow(ri, 7. / 3) + pow(ei, 7. / 3), 3 * s / 7);
          const double thick = pow(pow(rp, -3.5) + pow(ep, -3.5), -2 * s / 7);
          return pow(rigid + thick, 1 / s) * r * sqrt(u);
        }},
       {"persson_contact_area", "1.77245 in place of √2",
        [](const In& in) {
          return std::erf(sqrt(pi) * in("pressure") /
                          (in("effective_modulus") * in("rms_gradient")));
        }},
       {"jkr_radius", "0.74 in place of 3/4",
        [](const In& in) {
          const double r = in("reduced_radius"), pull = pi * in("work_of_adhesion") * r;
          const double root = sqrt(6 * pull * in("load") + 9 * pull * pull);
          return std::cbrt(0.74 * r / in("effective_modulus") * (in("load") + 3 * pull + root));
        }},
       {"regime_film", "atan in degrees (0.5 α) in place of atan(0.5 α)",
        [](const In& in) -> json {
          if (in.inputs.at("regime") != "isoviscous_rigid" || !in.inputs.contains("radius_ratio"))
            return {};
          const double alpha = in("radius_ratio"), phi = 1 / (1 + 2 / (3 * alpha));
          const double arc = 0.131 * std::atan(alpha / 2) * 180 / pi + 1.683;
          return 128 * alpha * phi * phi * arc * arc;
        }},
       {"reduced_radius", "√((1/R_x)² + (1/R_y)²) in place of 1/R_x + 1/R_y",
        [](const In& in) -> json {
          const double x = 1 / in("first_radius_x") + 1 / in("second_radius_x");
          const double y = 1 / in("first_radius_y") + 1 / in("second_radius_y");
          return {
              {"radius_x", 1 / x}, {"radius_y", 1 / y}, {"reduced_radius", 1 / std::hypot(x, y)}};
        }},
       {"viscosity_index", "log₁₀(Y) in place of ln(Y)",
        [](const In& in) -> json {
          const auto oils = detail::index_oils(in("kinematic_viscosity_100"));
          const double u = 1e6 * in("kinematic_viscosity_40");
          if (u >= oils.hundred) return {};
          const double power =
              log(oils.hundred / u) / std::log10(1e6 * in("kinematic_viscosity_100"));
          return (pow(10, power) - 1) / 0.00715 + 100;
        }},
       {"barus_viscosity", "with 1e-05 p in place of p (",
        [](const In& in) {
          return in("viscosity") * exp(in("pressure_viscosity") * 1e-5 * in("pressure"));
        }},
       {"subsurface_shear", "atan(1/(a/z)) in place of atan(a/z)",
        [](const In& in) -> json {
          const double z = in("depth") / in("radius"), q = 1 / (1 + z * z);
          if (z == 0) return {};
          const double radial = q / 2 - (1 + in("poisson_ratio")) * (1 - z * std::atan(z));
          return in("peak_pressure") * std::abs(radial + q) / 2;
        }},
       {"subsurface_shear", "no term + 0.5 q",
        [](const In& in) -> json {
          const double z = in("depth") / in("radius"), q = 1 / (1 + z * z);
          if (z == 0) return {};
          return in("peak_pressure") / 2 *
                 std::abs(q - (1 + in("poisson_ratio")) * (1 - z * std::atan(1 / z)));
        }},
       {"carreau_yasuda_viscosity", "no term − η_∞, in η₀ − η_∞",
        [](const In& in) {
          const double a = in("transition_exponent");
          return in("high_shear_viscosity") +
                 in("viscosity") * pow(1 + pow(in("relaxation_time") * in("shear_rate"), a),
                                       (in("power_law_index") - 1) / a);
        }},
       {"hertz_line", "0.304 in place of 0.300283",
        [](const In& in) -> json {
          const double load = in("load_per_length");
          const double b = sqrt(4 * load * in("reduced_radius") / (pi * in("effective_modulus")));
          const double peak = 2 * load / (pi * b);
          return {{"half_width", b},
                  {"mean_pressure", load / (2 * b)},
                  {"peak_pressure", peak},
                  {"peak_shear", 0.304 * peak}};
        }},
       {"persson_contact_area", "tanh(√2 p/(E* h′)) in place of erf", [](const In& in) {
          return std::tanh(sqrt(2) * in("pressure") /
                           (in("effective_modulus") * in("rms_gradient")));
        }}});
}

TEST(RightAnswers, UpsideDownOrTakenFromOneAreTold) {
  const auto modulus = [](const In& in) {
    return 1 / ((1 - pow(in("first_poisson_ratio"), 2)) / in("first_modulus") +
                (1 - pow(in("second_poisson_ratio"), 2)) / in("second_modulus"));
  };
  const auto thermal = [](const In& in) {
    const double l = in("temperature_viscosity") * in("viscosity") * pow(in("speed"), 2) /
                     in("thermal_conductivity");
    return 3.94 / (3.94 + pow(l, 0.62));
  };
  expect_told({{"effective_modulus", "wrong answers are 1 over the right ones.",
                [=](const In& in) { return 1 / modulus(in); }},
               {"murch_wilson_thermal_reduction", "wrong answers are 1 less the right ones.",
                [=](const In& in) { return 1 - thermal(in); }},
               {"murch_wilson_thermal_reduction", "wrong answers are the roots of the right ones.",
                [=](const In& in) { return sqrt(thermal(in)); }}});
}

double simpson(const std::function<double(double)>& of, double from, double to) {
  constexpr int count = 4000;
  double sum = 0;
  for (int i = 0; i <= count; ++i)
    sum += (i == 0 || i == count ? 1 : i % 2 == 1 ? 4 : 2) * of(from + (to - from) * i / count);
  return sum * (to - from) / count / 3;
}
// ∫ (s − d)^order φ(s) ds from d to `end`, with s = d + t².
double moment_to(double order, double d, double end) {
  return end <= d
             ? 0
             : simpson([&](double t) { return 2 * pow(t, 2 * order + 1) * density(d + t * t); },
                       sqrt(std::max(0.0, std::min(end, 0.0) - 12 - d)), sqrt(end - d));
}

TEST(Integrals, ThatEndTooEarlyAreToldWithTheirEnd) {
  expect_told({{"gaussian_moment", "the integral cut off at s = 6 (",
                [](const In& in) { return moment_to(in("order"), in("argument"), 6); }},
               {"gaussian_moment", "the integral cut off at s = d + 7 (", [](const In& in) {
                  return moment_to(in("order"), in("argument"), in("argument") + 7);
                }}});
}

// The moment as a sum over places with weights. A place is 0 at s = d and 1 at the end, which is
// s = d + `end` if `is_distance`, else s = `end`.
Formula moment_by_sum(double end, bool is_distance,
                      const std::vector<std::pair<double, double>>& places) {
  return [=](const In& in) {
    const double d = in("argument"), width = is_distance ? end : end - d;
    double sum = 0;
    for (const auto& [place, weight] : places)
      if (width > 0)
        sum += weight * width * pow(place * width, in("order")) * density(d + place * width);
    return sum;
  };
}
std::vector<std::pair<double, double>> trapezoids(int count) {
  std::vector<std::pair<double, double>> places;
  for (int i = 0; i <= count; ++i)
    places.emplace_back(1.0 * i / count, (i == 0 || i == count ? 0.5 : 1.0) / count);
  return places;
}
std::vector<std::pair<double, double>> simpsons(int count) {
  auto places = trapezoids(count);
  for (int i = 0; i <= count; ++i)
    places[static_cast<std::size_t>(i)].second *= (i % 2 == 1 ? 4.0 : 2.0) / 3;
  return places;
}
std::vector<std::pair<double, double>> midpoints(int count) {
  std::vector<std::pair<double, double>> places;
  for (int i = 0; i < count; ++i) places.emplace_back((i + 0.5) / count, 1.0 / count);
  return places;
}
std::vector<std::pair<double, double>> ten_of_gauss() {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  std::vector<std::pair<double, double>> places;
  for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
    for (const double sign : {-1, 1})
      places.emplace_back((1 + sign * Gauss::abscissa()[i]) / 2, Gauss::weights()[i] / 2);
  return places;
}

TEST(Integrals, OfTooFewPointsAreToldWithTheirRule) {
  expect_told(
      {{"gaussian_moment", "the integral by 100 trapezoids up to s = d + 8 (",
        moment_by_sum(8, true, trapezoids(100))},
       {"gaussian_moment", "the integral by 499 trapezoids up to s = 6 (",
        moment_by_sum(6, false, trapezoids(499))},
       {"gaussian_moment", "the integral by 30 intervals of Simpson's rule up to s = d + 10 (",
        moment_by_sum(10, true, simpsons(30))},
       {"gaussian_moment", "the integral by 50 midpoints up to s = d + 5 (",
        moment_by_sum(5, true, midpoints(50))},
       {"gaussian_moment", "the integral by 10 points of Gauss and Legendre up to s = d + 6 (",
        moment_by_sum(6, true, ten_of_gauss())}});
}

TEST(Inputs, OnOneSideOfOneThatAreUpsideDownAreTold) {
  const auto with = [](double (*read)(double)) {
    return [read](const In& in) {
      return results_of("hamrock_dowson_central", in, [&](json& inputs) {
        if (inputs.contains("ellipticity")) inputs["ellipticity"] = read(in("ellipticity"));
      })[0];
    };
  };
  expect_told(
      {{"hamrock_dowson_central", "with the greater of k and 1/k in place of k (",
        with([](double k) { return std::max(k, 1 / k); })},
       {"hamrock_dowson_central", "with the less of k and 1/k in place of k (",
        with([](double k) { return std::min(k, 1 / k); })},
       {"hamrock_dowson_central", ": 1/k in place of k (", with([](double k) { return 1 / k; })}});
}

// An oil's index by another row of the table than the right one.
double index_by(const In& in, std::ptrdiff_t (*other)(std::ptrdiff_t row)) {
  const double u = 1e6 * in("kinematic_viscosity_40"), y = 1e6 * in("kinematic_viscosity_100");
  const auto& rows = detail::index_rows;
  std::ptrdiff_t row = std::ssize(rows) - 1;
  while (row > 0 && y <= 1e6 * rows[static_cast<std::size_t>(row)].from) --row;
  const auto& n = rows[static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(other(row), 0, std::ssize(rows) - 1))];
  const double l = n.a * y * y / 1e5 + n.b * y / 1e4 + n.c / 1e3;
  const double h = n.d * y * y / 1e5 + n.e * y / 1e4 + n.f / 1e3;
  if (u >= h) return (l - u) / (l - h) * 100;
  return 100 + (exp(log(10) * log(h / u) / log(y)) - 1) / 0.00715;
}

TEST(Rows, OfATableThatAreTakenForOthersAreTold) {
  expect_told(
      {{"viscosity_index", "the row after the right one in the table",
        [](const In& in) { return index_by(in, [](std::ptrdiff_t row) { return row + 1; }); }},
       {"viscosity_index", "the row before the right one in the table",
        [](const In& in) { return index_by(in, [](std::ptrdiff_t row) { return row - 1; }); }},
       {"viscosity_index",
        "the numbers of the row from 7 mm²/s in place of those of the row from 7.7 mm²/s",
        [](const In& in) {
          return index_by(in, [](std::ptrdiff_t row) { return row == 6 ? 5 : row; });
        }},
       {"viscosity_index", "the numbers of the row from 2 mm²/s for every Y", [](const In& in) {
          return index_by(in, [](std::ptrdiff_t) -> std::ptrdiff_t { return 0; });
        }}});
}

// The film ratio of a starved inlet, by bisection of [0, 1]. Null for another closure.
json starved(const In& in, int halvings) {
  if (in.inputs.at("closure") != "starved_inlet") return {};
  double low = 0, high = 1;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2, psi = std::tan(middle * pi / 2) / 2.7;
    const double length = in("flooded_over_inlet") * (middle + 4 * sqrt(2) / 3 * pow(psi, 1.5));
    (length < 1 ? low : high) = middle;
  }
  return (low + high) / 2;
}

TEST(Bisections, ThatEndTooEarlyAreToldWithTheirSteps) {
  expect_told(
      {{"starvation_ratio", "which is 1/2^15: as of a bisection of a width of 1 that ends after 15",
        [](const In& in) { return starved(in, 15); }},
       {"starvation_ratio", "which is 1/2^12: as of a bisection",
        [](const In& in) { return starved(in, 12); }}});
}

TEST(Iterations, ThatStopAtAToleranceAreToldWithIt) {
  const auto ended = [](double tolerance) {
    return [=](const In& in) -> json {
      const double root = results_of("load_sharing", in)[0];
      double low = in("flooded_film_parameter"), high = low + 60 + in.inputs.value("offset", 0.0);
      while (high - low > tolerance * high) {
        const double middle = (low + high) / 2;
        (middle < root ? low : high) = middle;
      }
      return high;
    };
  };
  const std::string said = said_of("load_sharing", ended(1e-3));
  expect_said(said, "as of an iteration that stops where it changes by no more");
  const std::string far = said_of("load_sharing", ended(0.1));
  expect_said(far, "as of an iteration that stops where", false);
}

// Half of the old film parameter and half of the new one, until they differ by a part of 1000.
TEST(Iterations, OfSubstitutionThatStopEarlyAreToldByTheEquationThatTheyMeet) {
  const auto substituted = [](double tolerance) {
    return [=](const In& in) -> json {
      const LoadSharing<double> sharing(in.inputs.at("asperity") == "greenwood_tripp"
                                            ? AsperityModel::greenwood_tripp
                                            : AsperityModel::greenwood_williamson,
                                        in("stiffness"), in.inputs.value("offset", 0.0));
      const double flooded = in("flooded_film_parameter");
      double film = flooded, before = 0;
      for (int i = 0; i < 500 && std::abs(film / before - 1) >= tolerance; ++i) {
        before = film;
        film = (film + flooded * pow(std::max(1 - sharing.asperity_share(film), 1e-12), -0.14)) / 2;
      }
      return film;
    };
  };
  expect_said(said_of("load_sharing", substituted(1e-3)),
              "of λ₀/(1 − A)^e, with the share A at λ, and ");
  expect_said(said_of("load_sharing",
                      [](const In& in) -> json {
                        return results_of("load_sharing", in)[0] *
                               (1 + 1e-4 * std::sin(in("stiffness")));
                      }),
              "of λ₀/(1 − A)^e", false);
}

// Bisections that end after a number of steps. Each question has a bracket of its own.
TEST(Iterations, ThatEndAfterSomeStepsAreToldByTheirBrackets) {
  const auto halved = [](double right, double low, double high, int steps) {
    for (int i = 0; i < steps; ++i) {
      const double middle = (low + high) / 2;
      (middle < right ? low : high) = middle;
    }
    return (low + high) / 2;
  };
  const auto ratio = [&](int steps) {
    return [=](const In& in) -> json {
      const double right = results_of("starvation_ratio", in)[0];
      if (in.inputs.at("closure") != "starved_inlet") return right;
      return halved(right, 0, std::min(1.0, 1 / in("flooded_over_inlet")), steps);
    };
  };
  for (const int steps : {8, 15})
    expect_said(said_of("starvation_ratio", ratio(steps)),
                fmt::format("are whole multiples of 1/2^{} of 1 or of 1/", steps + 1));
  // The error is at most 1e-3 of the root, or 1e-3 where the root is less than 1.
  const std::string said = said_of("load_sharing", [](const In& in) -> json {
    const double right = results_of("load_sharing", in)[0];
    const double any = std::fmod(1e4 * std::sqrt(right), 1.0);
    return right + 1e-3 * any * std::max(right, 1.0);
  });
  expect_said(said, "of the value, or of 1 where the value is less");
}

// The least of these answers is the first one.
TEST(Answers, ThatAreRoundedAreToldWithTheirStep) {
  for (const double step : {1.0, 0.1}) {
    const auto rounded = [=](const In& in) -> json {
      const double right =
          viscosity_index(in("kinematic_viscosity_40"), in("kinematic_viscosity_100"));
      return step * std::nearbyint(right / step);
    };
    const std::string words = fmt::format("are whole steps of {:g} from each other", step);
    expect_told({{"viscosity_index", words.c_str(), rounded}});
  }
}

// All are wrong, by factors that differ by decades though each is far below 1.
TEST(Answers, ThatAreOneNumberFarTooSmallAreToldWithIt) {
  expect_told(
      {{"barus_viscosity", "wrong answers are 1e-09", [](const In&) -> json { return 1e-9; }}});
}

TEST(Inputs, ThatAreCutOffAreToldWithTheirEndAndNotAsACache) {
  const auto cut = [](const char* name, const char* input, double least) {
    return [=](const In& in) -> json {
      return results_of(name, in, [&](json& inputs) {
        inputs[input] = std::fmax(inputs.value(input, 1.0), least);  // k has a default
      })[0];
    };
  };
  const std::string moments = said_of("gaussian_moment", cut("gaussian_moment", "argument", 0));
  expect_said(moments, "those of argument = 0 wherever it is less: it is cut off there.");
  expect_said(moments, "cache", false);
  // One case alone does not tell a cut-off from a cache.
  const std::string film =
      said_of("hamrock_dowson_minimum", cut("hamrock_dowson_minimum", "ellipticity", 1));
  expect_said(film,
              "those of ellipticity = 1 wherever it is less: it is cut off there; or the "
              "solver keeps answers");
}

TEST(Results, ThatAreRightAreNotToldBesideAWrongOne) {
  const std::string said = said_of("lambda_ratio", [](const In& in) -> json {
    const double rms = std::hypot(in("first_roughness"), in("second_roughness"));
    return {{"composite_roughness", rms},
            {"lambda_ratio", in("minimum_film") / in("first_roughness")}};
  });
  expect_said(said, "Rq₁ alone");
  expect_said(said, "composite_roughness", false);
}

// A wrong factor of some results is told as a factor. It is not told as two mistakes whose effects
// cancel in a right result.
TEST(Results, ThatAreRightSpeakAgainstMistakesThatTakeEachOtherBack) {
  const std::string said = said_of("hertz_line", [](const In& in) -> json {
    const Numbers results = results_of("hertz_line", in);
    return {{"half_width", results[0]},
            {"mean_pressure", results[1]},
            {"peak_pressure", results[2] / 2},
            {"peak_shear", results[3] / 2}};
  });
  expect_said(said, "peak_pressure is 50 % low everywhere. It is too small by a factor of 2.");
  expect_said(said, "mistakes give together", false);
}

// A change of the law is not told where another cause says it more simply.
TEST(Axes, OfAnEllipseThatAreNotExchangedAreToldAsTheRightValueOfTheOtherOne) {
  const std::string said = said_of("hertz_ellipse", [](const In& in) -> json {
    const Numbers results = results_of("hertz_ellipse", in);
    return {{"semi_axis_x", std::min(results[0], results[1])},
            {"semi_axis_y", std::max(results[0], results[1])}};
  });
  expect_said(said, "are the right semi_axis_y of their cases");
  expect_said(said, "no factor k", false);
}

TEST(LoadSharing, WithAnotherExponentIsToldWithIt) {
  const auto shared = [](double exponent) {
    return [=](const In& in) -> json {
      const bool is_gt = in.inputs.at("asperity") == "greenwood_tripp";
      double low = in("flooded_film_parameter"), high = low + 60 + in.inputs.value("offset", 0.0);
      for (int i = 0; i < 90; ++i) {
        const double middle = (low + high) / 2, d = middle - in.inputs.value("offset", 0.0);
        const double f =
            in("stiffness") * gaussian_moment(is_gt ? Order::five_halves : Order::three_halves, d);
        const double share = is_gt ? sqrt(f) : f;
        const bool is_below =
            share >= 1 || middle < in("flooded_film_parameter") * pow(1 - share, -exponent);
        (is_below ? low : high) = middle;
      }
      return (low + high) / 2;
    };
  };
  expect_told(
      {{"load_sharing", "with the film's exponent 0.15 in place of the film's exponent 0.14",
        shared(0.15)}});
}

// The radius of an adhesive contact with other numbers. What is below 0 under the root counts as 0.
Formula jkr(double outside, double linear, double square) {
  return [=](const In& in) -> json {
    const double pull = pi * in("work_of_adhesion") * in("reduced_radius"), load = in("load");
    const double root = sqrt(std::max(0.0, linear * pull * load + square * pull * pull));
    return std::cbrt(outside * in("reduced_radius") / in("effective_modulus") *
                     (load + 3 * pull + root));
  };
}
Formula roelands_of_constant(double z, double (*logarithm)(double)) {
  return [=](const In& in) -> json {
    const double scale = logarithm(in("viscosity")) + 9.67;
    return in("viscosity") * exp(scale * (pow(1 + in("pressure") / 1.96e8, z) - 1));
  };
}

TEST(TwoChanges, OfWhichOneIsANumberAreToldTogether) {
  expect_told({{"jkr_radius", "with no term + 9 πwR²", jkr(0.75, 6, 0)},
               {"jkr_radius", "+ 3 πwR² in place of + 9 πwR²", jkr(0.75, 6, 3)},
               {"roelands_viscosity", "log₁₀(η₀) in place of ln(η₀), and 0.61 in place of z",
                roelands_of_constant(0.61, [](double x) { return std::log10(x); })},
               {"roelands_viscosity", "with 0.62 in place of z (",
                roelands_of_constant(0.62, [](double x) { return log(x); })},
               {"patir_cheng_pressure_flow", "with −H^0.56 in place of −0.56 H (",
                [](const In& in) -> json { return 1 - 0.9 * exp(-pow(in("film_ratio"), 0.56)); }}});
  const std::string both = said_of("jkr_radius", jkr(1.5, 6, 3));
  expect_said(both, "3/2 in place of 3/4");
  expect_said(both, "+ 3 πwR² in place of + 9 πwR²");
  // People do not write a number with so many digits.
  const std::string odd = said_of("jkr_radius", jkr(1.5, 6, 3.0123456));
  expect_said(odd, "in place of", false);
}

TEST(TwoChanges, OfANumberAndACutAreToldTogether) {
  const auto roelands = [](double scale_pressure, double most) {
    return [=](const In& in) -> json {
      const double scale = log(in("viscosity")) + 9.67;
      const double z = in("pressure_viscosity") * scale_pressure / scale;
      const double p = std::min(in("pressure"), most);
      return in("viscosity") * exp(scale * (pow(1 + p / scale_pressure, z) - 1));
    };
  };
  expect_told({{"roelands_viscosity",
                "with 1.98e+08 in place of 1.96e+08, and with p = 1e+09 wherever it is greater: it "
                "is cut off there",
                roelands(1.98e8, 1e9)}});
  const std::string odd = said_of("roelands_viscosity", roelands(1.9812345e8, 1e9));
  expect_said(odd, "in place of", false);
}

// Moes' film of lines, with other numbers, and with U in place of 2U in M.
Formula moes(double times_u, double of_elastic, double exponent) {
  return [=](const In& in) -> json {
    const double modulus = 2 * in("effective_modulus"), radius = in("reduced_radius");
    const double u = 2 * in("speed") * in("viscosity") / (modulus * radius);
    const double m = in("load_per_length") / (modulus * radius) / sqrt(times_u * u);
    const double l = in("pressure_viscosity") * modulus * pow(u, 0.25);
    const double ri = 3 / m, ei = of_elastic * pow(m, -0.2), rp = 1.287 * pow(l, exponent);
    const double ep = 1.311 * pow(m, -0.125) * pow(l, 0.75);
    const double s = (7 + 8 * exp(-2 * ei / ri)) / 5;
    const double rigid = pow(pow(ri, 7.0 / 3) + pow(ei, 7.0 / 3), 3 * s / 7);
    const double thick = pow(pow(rp, -3.5) + pow(ep, -3.5), -2 * s / 7);
    return pow(rigid + thick, 1 / s) * radius * sqrt(u);
  };
}

TEST(ThreeChanges, OfALawAreToldTogether) {
  expect_told(
      {{"moes_line",
        "0.5 F/L/(E* R √U) in place of 0.5 F/L/(E* R √2U), and 2.261 in place of 2.621, and "
        "L^0.75 in place of L^(2/3)",
        moes(0.5, 2.261, 0.75)}});
  const std::string odd = said_of("moes_line", moes(0.5, 2.2612345, 0.7512345));
  expect_said(odd, "in place of", false);
}

TEST(OneFactor, OfAConstantThatIsRoundedIsToldWithIt) {
  const auto summits = [](double constant) {
    return [=](const In& in) -> json {
      return {{"summit_density", constant * in("m4") / in("m2")}};
    };
  };
  expect_told(
      {{"summits_from_spectral_moments", "with 0.0306 π in place of 0.096225", summits(0.0306)}});
  const std::string odd = said_of("summits_from_spectral_moments", summits(0.03061234567));
  expect_said(odd, "in place of", false);
}

// Solvers that do not read the word of an argument, and always take the same word.
TEST(Words, ThatAreNotReadAreTold) {
  for (const auto& [name, argument, words] :
       {std::tuple{"nijenbanning_venner_moes", "exponent",
                   "the exponent `ei_over_ri` where `ei_over_ep` is asked for"},
        std::tuple{"nijenbanning_venner_moes", "bracket",
                   "the bracket `three_halves` where `three_halves_of_s` is asked for"},
        std::tuple{"load_sharing", "asperity",
                   "the model `greenwood_tripp` where `greenwood_williamson` is asked for"}})
    expect_told({{name, words, [name = name, argument = argument](const In& in) -> json {
                    return results_of(name, in, [&](json& inputs) {
                      inputs.erase(argument);
                      if (std::string_view(name) == "load_sharing")
                        inputs[argument] = "greenwood_tripp";
                    })[0];
                  }}});
}

Formula moment_of(double (*read)(double d)) {
  return [=](const In& in) -> json {
    return gaussian_moment(static_cast<Order>(std::lround(2 * in("order"))), read(in("argument")));
  };
}

TEST(Inputs, WithoutTheirSignAreToldAndNotAsNumerics) {
  expect_told({{"gaussian_moment", "with |d| in place of d (",
                moment_of([](double d) { return std::abs(d); })},
               {"reduced_radius", "with the size of each of R₁x, R₂x, R₁y, R₂y, without its sign",
                [](const In& in) -> json {
                  const auto both = [&](const char* one, const char* other, auto read) {
                    return 1 / (1 / read(in(one)) + 1 / read(in(other)));
                  };
                  const auto same = [](double x) { return x; };
                  const auto size = [](double x) { return std::abs(x); };
                  const double x = both("first_radius_x", "second_radius_x", size);
                  const double y = both("first_radius_y", "second_radius_y", size);
                  return {{"radius_x", both("first_radius_x", "second_radius_x", same)},
                          {"radius_y", both("first_radius_y", "second_radius_y", same)},
                          {"reduced_radius", 1 / (1 / x + 1 / y)}};
                }}});
  expect_said(said_of("gaussian_moment", moment_of([](double d) { return std::abs(d); })),
              "as of a quadrature", false);
}

TEST(Inputs, ThatOneCaseShowsCutOffAreToldWhereTheEndHasFewDigits) {
  const auto film = [](double end) {
    return [=](const In& in) -> json {
      return results_of("hamrock_dowson_minimum", in, [&](json& inputs) {
        inputs["ellipticity"] = std::min(inputs.value("ellipticity", 1.0), end);
      })[0];
    };
  };
  const std::string words = "wherever it is greater: it is cut off there (1 of 1";
  const std::string said = said_of("hamrock_dowson_minimum", film(8));
  expect_said(said, "with k = 8 " + words);
  const std::string odd = said_of("hamrock_dowson_minimum", film(7.9123));
  expect_said(odd, words, false);
}

// Axes and pressures of an ellipse of the axis ratio k. `area` stands for the π in its area.
Formula ellipse_of(double (*ratio)(double alpha), double area) {
  return [=](const In& in) -> json {
    const double x = in("radius_x"), y = in("radius_y"), load = in("load");
    const double k = ratio(std::max(x, y) / std::min(x, y));
    const auto [b, d] = detail::associated_integrals(k);
    const double minor = std::cbrt(3 * (b + d / k / k) * load / (1 / x + 1 / y) /
                                   (pi * k * in("effective_modulus")));
    const double mean = load / (area * k * minor * minor);
    return {{"semi_axis_x", y < x ? k * minor : minor},
            {"semi_axis_y", y < x ? minor : k * minor},
            {"ellipticity", y < x ? 1 / k : k},
            {"mean_pressure", mean},
            {"peak_pressure", 1.5 * mean}};
  };
}

TEST(Axes, ThatFollowFromAWrongRatioAreToldByItAndTheRestIsJudgedByIt) {
  const std::string follows = "This follows from its ellipticity";
  const auto root = [](double alpha) { return sqrt(alpha); };
  const std::string said = said_of("hertz_ellipse", ellipse_of(root, pi));
  expect_said(said, follows);
  expect_said(said, "are (R_y/R_x)^(0.5)");
  expect_said(said, "as of a quadrature", false);
  expect_said(said, "mean_pressure", false);
  const std::string of_area = said_of("hertz_ellipse", ellipse_of(root, 4));
  expect_said(of_area,
              "mean_pressure is 21.5 % low everywhere. It is too small by a factor of 4/π");
  // Right axes beside a wrong ellipticity do not follow from it.
  const Formula right =
      ellipse_of([](double alpha) { return ellipse_shape(alpha).ellipticity; }, pi);
  const std::string alone = said_of("hertz_ellipse", [&](const In& in) {
    json given = right(in);
    given["ellipticity"] = sqrt(in("radius_y") / in("radius_x"));
    return given;
  });
  expect_said(alone, follows, false);
}

// A further factor that is near 1 for small L is not told as an inexact quadrature.
TEST(Growth, OfAFactorIsNotToldAsNumerics) {
  for (const double times : {0.31, 0.47}) {
    const std::string said = said_of("gupta_thermal_reduction", [=](const In& in) -> json {
      const double l = in("temperature_viscosity") * in("viscosity") * pow(in("speed"), 2) /
                       in("thermal_conductivity");
      return (1 - 6.6 * in("peak_pressure") / in("effective_modulus") * pow(l, 0.42)) /
             (1 + 0.213 * (1 + 2.23 * pow(in("slide_roll_ratio"), 0.83)) * pow(l, 0.64)) *
             (1 + times * log(1 + l));
    });
    expect_said(said, "quadrature", false);
  }
}

Formula film_times(const char* name, const char* input, double times, double factor) {
  return [=](const In& in) -> json {
    return factor * results_of(name, in, [&](json& inputs) {
             inputs[input] = times * inputs[input].get<double>();
           })[0];
  };
}

TEST(OneFactor, IsToldByPrintedNumbersAndFactorsOfInputsThatPeopleKnow) {
  expect_told({{"hamrock_dowson_central", "2.96 in place of 2.69, and R/2 in place of R",
                film_times("hamrock_dowson_central", "reduced_radius", 0.5, 2.96 / 2.69)},
               {"pan_hamrock_minimum", "with 1000 F/L in place of F/L (",
                film_times("pan_hamrock_minimum", "load_per_length", 1000, 1)}});
  // Almost any number of a law can be changed to give a factor. Only a printed number is told.
  for (int i = 0; i < 8; ++i) {
    const double factor = 0.7123456789 + 0.0312345678 * i;
    const std::string said =
        said_of("hamrock_dowson_central", film_times("hamrock_dowson_central", "speed", 1, factor));
    expect_said(said, "in place of", false);
  }
}

TEST(TwoChanges, ThatSpoilRightResultsAreNotTold) {
  const std::string said = said_of("hertz_line", [](const In& in) -> json {
    const Numbers right = results_of("hertz_line", in);
    return {{"half_width", right[0]},
            {"mean_pressure", right[1] * 2 / pi},
            {"peak_pressure", right[2]},
            {"peak_shear", right[3]}};
  });
  expect_said(said, "1/π in place of 0.5, in 0.5 F/L/b");
  expect_said(said, "4 F/L", false);  // half_width would be wrong, too
}

TEST(Mistakes, AreNoSetWhereAllAnswersAreOneNumber) {
  const std::string said = said_of("starvation_ratio", [](const In& in) -> json {
    if (in.inputs.at("closure") == "flooded_inlet" && in("flooded_over_inlet") >= 1) return 1;
    return results_of("starvation_ratio", in)[0];
  });
  expect_said(said, "wrong answers are 1: a floor, a cap, a guard");
  expect_said(said, "mistakes give together", false);
}

// A left-out input keeps its number of the question before, as in a global variable.
TEST(Defaults, ThatAreKeptFromTheQuestionBeforeAreTold) {
  struct Kept {
    const char *function, *input;
    double by_default;
    const char* words;
  };
  for (const Kept& one : {Kept{"hamrock_dowson_soft_minimum", "ellipticity", 1,
                               "k of the question before where it is left out: it is kept"},
                          Kept{"starvation_ratio", "damiens_exponent", 3,
                               "of the question before where it is left out: it is kept"}}) {
    for (const bool is_kept : {true, false}) {
      double kept = one.by_default;
      const std::string said = said_of(one.function, [&](const In& in) -> json {
        return results_of(one.function, in, [&](json& inputs) {
          if (!inputs.contains(one.input))
            inputs[one.input] = is_kept ? kept : one.by_default + 0.5;
          kept = inputs[one.input];
        })[0];
      });
      expect_said(said, one.words, is_kept);
      expect_said(said, fmt::format("{} where it is left out", one.by_default + 0.5), !is_kept);
    }
  }
}

// An input that is read in another unit, such as per cent, though its default is right.
TEST(Defaults, ThatAreRightStandBesideAnInputInAnotherUnit) {
  expect_told({{"hamrock_dowson_soft_minimum", "with k/100 in place of k where it is given",
                [](const In& in) -> json {
                  return results_of("hamrock_dowson_soft_minimum", in, [](json& inputs) {
                    if (inputs.contains("ellipticity"))
                      inputs["ellipticity"] = inputs["ellipticity"].get<double>() / 100;
                  })[0];
                }}});
}

TEST(Cuts, OfARatioHoldWhereItIsZeroToo) {
  expect_told({{"subsurface_shear", "with z/a = 0.05 wherever it is less: it is cut off there",
                [](const In& in) -> json {
                  return results_of("subsurface_shear", in, [](json& inputs) {
                    inputs["depth"] = std::max(inputs["depth"].get<double>(),
                                               0.05 * inputs["radius"].get<double>());
                  })[0];
                }}});
}

// Answers with noise have none of these causes, and none is told.
TEST(GeneralMeans, SayNothingOfNoise) {
  std::size_t number = 0;
  const auto noisy = [&](double right) {
    return right * (1 + 1e-2 * std::sin(1e3 * static_cast<double>(++number)));
  };
  for (const catalogue::Function& function : catalogue::functions()) {
    std::map<std::string, json> answers;
    for (const TestCase& one : cases_of(function.name)) {
      json fields;
      for (const Expected& expected : one.expected) fields[expected.field] = noisy(expected.high);
      answers[one.inputs.dump()] = std::move(fields);
    }
    const std::string said = said_of(std::string(function.name),
                                     [&](const In& in) { return answers.at(in.inputs.dump()); });
    EXPECT_FALSE(said.empty());
    for (const char* const words :
         {"The answers are the right ones with", "These are the numbers", "whole steps",
          "whole multiples", "as of an iteration that stops", " the right ones."})
      expect_said(said, words, false);
  }
}

}  // namespace
}  // namespace tribo::conformance
