// SPDX-License-Identifier: Apache-2.0
// U, G, W, Moes' M and L, g_V, g_E and the regimes of lubrication, each computed in a second way;
// the roughness and the least film of which Λ is made.
#include "tribo/similarity_numbers.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/hertz.hpp"
#include "tribo/hertz_line.hpp"
#include "tribo/roughness.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::verification {
namespace {

constexpr double pi = boost::math::constants::pi<double>();

// A contact with numbers that are usual in machines.
struct Machine {
  explicit Machine(Sampler& sampler)
      : speed(sampler.log_uniform(1e-3, 30)),
        viscosity(sampler.log_uniform(1e-3, 1)),
        pressure_viscosity(sampler.log_uniform(5e-9, 4e-8)),
        load(sampler.log_uniform(0.1, 1e5)),
        modulus(sampler.log_uniform(1e10, 3e11)),
        radius(sampler.log_uniform(1e-3, 0.1)) {}

  SimilarityNumbers<double> numbers() const {
    return similarity_numbers(speed, viscosity, pressure_viscosity, load, modulus, radius);
  }

  double speed, viscosity, pressure_viscosity, load, modulus, radius;
};

// αp₀ = (L/π)(3M/2)^{1/3} of a circle (Venner and Lubrecht), and L √M/√(2π) of a line. The pressure
// is that of Hertz' formulas, which do not use M and L.
TEST(MoesNumbers, GiveThePressureOfHertz) {
  Sampler sampler(7);
  for (int i = 0; i < 200; ++i) {
    const Machine one(sampler);
    const MoesNumbers<double> point = moes_numbers(one.numbers(), false);
    const double of_point =
        one.pressure_viscosity * hertz_point(one.load, one.modulus, one.radius).peak_pressure;
    EXPECT_TRUE(is_within(point.material / pi * std::cbrt(1.5 * point.load) / of_point, 1, 1e-13));
    // The load number of a line 1 m long is that of a point times R over 1 m.
    SimilarityNumbers<double> numbers = one.numbers();
    numbers.load *= one.radius;
    const MoesNumbers<double> line = moes_numbers(numbers, true);
    const double of_line =
        one.pressure_viscosity * hertz_line(one.load, one.modulus, one.radius).peak_pressure;
    EXPECT_TRUE(
        is_within(line.material * std::sqrt(line.load) / std::sqrt(2 * pi) / of_line, 1, 1e-13));
  }
}

// The film of a law follows from U, G and W alone.
TEST(SimilarityNumbers, GiveTheFilmOfTheLaw) {
  Sampler sampler(8);
  for (int i = 0; i < 200; ++i) {
    const Machine one(sampler);
    const auto [u, g, w] = one.numbers();
    const double film =
        film_thickness(hamrock_dowson_minimum_law, one.speed, one.viscosity, one.pressure_viscosity,
                       one.load, one.modulus, one.radius, 1.0);
    const double by_numbers = one.radius * 3.63 * std::pow(u, 0.68) * std::pow(g, 0.49) *
                              std::pow(w, -0.073) * (1 - std::exp(-0.68));
    EXPECT_TRUE(is_within(film / by_numbers, 1, 2e-14));
  }
}

// 3.42 g_V^0.49 g_E^0.17 and 3.63 U^0.68 G^0.49 W^−0.073 (W/U)² are one fit, apart from the
// constant and a factor W^(11/3000), as their exponents show.
TEST(RegimeNumbers, AreTheGroupsOfTheMinimumFilm) {
  Sampler sampler(9);
  for (int i = 0; i < 200; ++i) {
    const Machine one(sampler);
    const auto [u, g, w] = one.numbers();
    const auto [viscosity, elasticity] = regime_numbers(one.numbers());
    const double in_groups = 3.42 * std::pow(viscosity, 0.49) * std::pow(elasticity, 0.17);
    const double as_law = 3.63 * std::pow(u, 0.68 - 2) * std::pow(g, 0.49) * std::pow(w, 2 - 0.073);
    EXPECT_TRUE(
        is_within(in_groups / as_law / (3.42 / 3.63 * std::pow(w, -11.0 / 3000)), 1, 5e-14));
  }
}

// Limits: stiff bodies are rigid, a liquid whose viscosity does not rise is isoviscous, and a steel
// ball in oil is neither.
TEST(LubricationRegimes, AreThoseOfTheirLimits) {
  const auto of_point = [](double speed, double alpha, double load, double modulus) {
    return point_regime(regime_numbers(similarity_numbers(speed, 0.02, alpha, load, modulus, 0.01)),
                        1.0, 1.0);
  };
  EXPECT_EQ(of_point(1, 2e-8, 50, 1.1e11), LubricationRegime::piezoviscous_elastic);
  EXPECT_EQ(of_point(1, 0, 50, 1.1e11), LubricationRegime::isoviscous_elastic);
  EXPECT_EQ(of_point(1, 2e-8, 50, 1e6), LubricationRegime::isoviscous_elastic);  // rubber
  EXPECT_EQ(of_point(1, 0, 50, 1e19), LubricationRegime::isoviscous_rigid);
  EXPECT_EQ(of_point(1, 2e-8, 2, 1e19), LubricationRegime::piezoviscous_rigid);
  EXPECT_EQ(of_point(1e4, 2e-8, 1e-3, 1.1e11), LubricationRegime::isoviscous_rigid);
  const auto of_line = [](double load, double material) {
    return line_regime(MoesNumbers<double>{load, material});
  };
  EXPECT_EQ(of_line(1e-3, 1e-3), LubricationRegime::isoviscous_rigid);
  EXPECT_EQ(of_line(1e3, 0), LubricationRegime::isoviscous_elastic);
  EXPECT_EQ(of_line(2, 100), LubricationRegime::piezoviscous_rigid);
  EXPECT_EQ(of_line(1e3, 10), LubricationRegime::piezoviscous_elastic);
}

// Far inside a regime of the map of lines, Moes' film is the limit of that regime.
TEST(LubricationRegimes, OfALineNameTheLimitOfTheFilm) {
  std::size_t far_inside = 0;
  for (const double load : {1e-6, 1e-3, 1.0, 1e3, 1e6, 1e12})
    for (const double material : {1e-12, 1e-6, 1e-3, 1.0, 1e3, 1e6}) {
      const MoesNumbers<double> numbers{load, material};
      const MoesFilms<double> films = moes_films(load, material);
      const double limit = line_regime(numbers) == LubricationRegime::isoviscous_rigid ? films.rigid
                           : line_regime(numbers) == LubricationRegime::isoviscous_elastic
                               ? films.elastic
                           : line_regime(numbers) == LubricationRegime::piezoviscous_rigid
                               ? films.rigid_piezoviscous
                               : films.elastic_piezoviscous;
      const double film = moes_line_number(load, material);
      EXPECT_TRUE(is_within(std::log(film / limit), 0, 1));  // near a border all four add
      if (std::abs(film / limit - 1) < 0.02) ++far_inside;
    }
  EXPECT_GE(far_inside, 20u);
}

TEST(Roughness, OfGaussianHeightsIsThatOfTheirMeanAndMeanSquare) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double rms = 3e-7;
  // Ra is the mean of |z|: twice the integral over z from 0 to 40 Rq.
  const double average =
      2 * rms *
      quadrature.integrate([](double z) { return z * std::exp(-z * z / 2) / std::sqrt(2 * pi); },
                           0.0, 40.0);
  EXPECT_TRUE(is_within(rms_from_average_roughness(average) / rms, 1, 1e-13));
  for (const double first : {1e-200, 1e-7, 3.0, 1e200})
    for (const double second : {1e-200, 1e-7, 4.0, 1e200})
      EXPECT_TRUE(
          is_within(composite_roughness(first, second) / std::hypot(first, second), 1, 1e-15));
}

// The outputs that a point does not hold, in double and by the templates in long double. The least
// film is the solved film times the ratio of the smooth films by the two laws.
TEST(SmoothContact, GivesPressuresLeastFilmAndLambda) {
  Sampler sampler(10);
  std::size_t collapsed = 0;
  for (int i = 0; i < 400; ++i) {
    const Scene scene = random_scene(sampler);
    const double speed = scene.speeds.list[0];
    const MixedContact<double> solved(scene);
    const SmoothContact contact(solved);
    const double film_of_point = solved.solve(speed).film;
    const auto numbers = detail::numbers_of<long double>(scene);
    const ContactShape shape = scene.bodies.shape();
    const auto hold = [&](Output output, long double expected, double most) {
      const double value = contact.value(output, speed, film_of_point);
      if (expected == 0) {
        EXPECT_EQ(value, 0) << info(output).name << describe_scene(scene);
        return;
      }
      const auto part = static_cast<double>(value / expected);
      EXPECT_TRUE(is_within(part, 1, most)) << info(output).name << describe_scene(scene);
    };
    const bool is_line = shape == ContactShape::line;
    const long double area =
        is_line ? 2 * hertz_contact(shape, numbers).semi_axis_x * numbers.across
                : static_cast<long double>(pi) * hertz_contact(shape, numbers).semi_axis_x *
                      hertz_contact(shape, numbers).semi_axis_y;
    hold(Output::mean_pressure, numbers.load / area, 5e-15);
    hold(Output::peak_pressure,
         numbers.load / area * (is_line ? 4 / static_cast<long double>(pi) : 1.5L), 5e-15);
    const FilmLaw& law = film_law(scene.closures.film);
    const long double part =
        smooth_film<long double>(minimum_film_law(law), shape, numbers, speed) /
        smooth_film<long double>(law, shape, numbers, speed);
    const long double film = solved.in<long double>().solve(speed).film * part;
    const double film_error = 2e-14;  // operating_point_contract and the laws' contracts
    hold(Output::minimum_film, film, film_error);
    hold(Output::lambda_ratio,
         film / (1.25L * static_cast<long double>(scene.surface.summit_height_sd)), film_error);
    const double least = contact.value(Output::minimum_film, speed, film_of_point);
    EXPECT_GE(least, 0) << describe_scene(scene);
    if (part <= 1) {
      EXPECT_LE(least, film_of_point) << describe_scene(scene);
    }
    if (film_of_point == 0) ++collapsed;
  }
  EXPECT_GE(collapsed, 10u);
}

TEST(SmoothContact, TakesTheLeastFilmOfTheScenesLaw) {
  const auto least = [](FilmFormula formula) { return &minimum_film_law(film_law(formula)); };
  EXPECT_EQ(least(FilmFormula::hamrock_dowson_central), &hamrock_dowson_minimum_law);
  EXPECT_EQ(least(FilmFormula::hamrock_dowson_soft_central), &hamrock_dowson_soft_minimum_law);
  EXPECT_EQ(least(FilmFormula::dowson_toyoda_central), &dowson_higginson_minimum_law);
  EXPECT_EQ(least(FilmFormula::pan_hamrock_central), &pan_hamrock_minimum_law);
  for (std::size_t i = 0; i < named_film_laws.size(); ++i)
    if (film_formula_words[i].ends_with("_minimum")) {
      EXPECT_EQ(least(static_cast<FilmFormula>(i)), named_film_laws[i].law);
    }
}

}  // namespace
}  // namespace tribo::verification
