// SPDX-License-Identifier: Apache-2.0
// The solved film at the corners of (M, L), where its asymptotes are known: rigid bodies and a
// liquid of constant viscosity (RI), elastic and piezoviscous (EP), rigid and piezoviscous (RP);
// and dry contact.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "ehl/films.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using ehl::SolvedFilm;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The film at the outlet over the least film, between a plane and a rigid parabola. This film is
// H = H₀(1 + tan²γ), so that the ratio is 1 + tan²γ_c. At the outlet γ_c the pressure and its slope
// are 0: the integral of cos²γ − cos⁴γ/cos²γ_c from −π/2 to γ_c is 0.
double rigid_film_ratio() {
  const auto pressure = [](double g) {
    const double square = std::cos(g) * std::cos(g);
    const double start = g + std::numbers::pi / 2;
    return start / 2 + std::sin(2 * g) / 4 -
           (3 * start / 8 + std::sin(2 * g) / 4 + std::sin(4 * g) / 32) / square;
  };
  double low = 0.1, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((pressure(low) > 0) == (pressure(middle) > 0) ? low : high) = middle;
  }
  return 1 + std::tan(low) * std::tan(low);
}

// With rigid bodies the load gives the film number 3/M at the greatest pressure. The outlet has the
// same film, so that the least film number is 3/M over rigid_film_ratio(). Elastic bodies change
// both by a part that is proportional to M².
TEST(FilmLimits, RigidBodiesAndConstantViscosity) {
  const double ratio = rigid_film_ratio();
  EXPECT_TRUE(is_within(3 / ratio, 2.44748, 0.000005));
  const auto at = [](double m) {
    const ehl::LineContact contact = ehl::barus_contact(m, 0);
    SolvedFilm film = solved(contact);
    for (ehl::Estimate* e : {&film.minimum, &film.at_greatest_pressure}) {
      e->value = m * contact.film_number(e->value);
      e->error = m * contact.film_number(e->error);
    }
    return film;
  };
  const SolvedFilm coarse = at(0.02), fine = at(0.01);
  const auto tends_to = [&](ehl::Estimate SolvedFilm::*film, double limit) {
    const ehl::Estimate &one = coarse.*film, &two = fine.*film;
    return is_estimated(
        {two.value + (two.value - one.value) / 3, two.error * 4 / 3 + one.error / 3}, limit, 0);
  };
  EXPECT_TRUE(tends_to(&SolvedFilm::minimum, 3 / ratio));
  EXPECT_TRUE(tends_to(&SolvedFilm::at_greatest_pressure, 3));
}

// The constant of a least-squares fit of columns to values, and its error: the most that the
// values' errors can move it, and the standard error of the fit.
ehl::Estimate fitted_constant(const MatrixXd& columns, const VectorXd& values,
                              const VectorXd& errors) {
  const MatrixXd inverse = (columns.transpose() * columns).inverse();
  const VectorXd fit = inverse * columns.transpose() * values;
  const double freedom = static_cast<double>(columns.rows() - columns.cols());
  const double variance = (values - columns * fit).squaredNorm() / freedom;
  const VectorXd weights = (inverse * columns.transpose()).row(0).transpose();
  return {fit[0], weights.cwiseAbs().dot(errors) + std::sqrt(variance * inverse(0, 0))};
}

// The limit of H_p / (M^{of_load} L^{of_material}), where H_p is the film number at the greatest
// pressure. It comes from a fit to the columns of columns_of(contact, H). The first column is 1;
// the others go to 0 in the limit.
template <class Columns>
ehl::Estimate fitted_limit(const std::vector<std::array<double, 2>>& contacts, double of_load,
                           double of_material, double tolerance, const Columns& columns_of) {
  const auto count = static_cast<Eigen::Index>(contacts.size());
  MatrixXd columns;
  VectorXd values(count), errors(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [m, l] = contacts[static_cast<std::size_t>(i)];
    const ehl::LineContact contact = ehl::barus_contact(m, l);
    const ehl::Estimate film =
        solved(contact, {.tolerance = tolerance, .greatest_cells = 2048}).at_greatest_pressure;
    const double unit = contact.film_number(1) / (std::pow(m, of_load) * std::pow(l, of_material));
    values[i] = unit * film.value;
    errors[i] = unit * film.error;
    const Eigen::RowVectorXd row = columns_of(contact, film.value);
    columns.conservativeResize(count, row.size());
    columns.row(i) = row;
  }
  return fitted_constant(columns, values, errors);
}

// The limit 1.31106 M^{−1/8} L^{3/4} is far away: at M = 1e4 and L = 20 the film is 1.6 % off. A
// fit extrapolates the ratio to 1/(ᾱ√δ) = 0 and δ = 0, where δ = H^{2/3} is the width of the inlet.
TEST(FilmLimits, ElasticAndPiezoviscous) {
  std::vector<std::array<double, 2>> contacts{{10000, 10}, {10000, 20}};
  for (const double m : {300.0, 1000.0, 3000.0})
    for (const double l : {10.0, 20.0, 40.0}) contacts.push_back({m, l});
  const ehl::Estimate limit =
      fitted_limit(contacts, -0.125, 0.75, 1e-4, [](const ehl::LineContact& contact, double film) {
        const double d = std::pow(film, 2. / 3), e = 1 / (contact.fluid.exponent * std::sqrt(d));
        return Eigen::RowVectorXd{{1, e, d, e * e, e * d, d * d}};
      });
  EXPECT_TRUE(is_estimated(limit, 1.31106, 0.000005));
  EXPECT_LT(limit.error, 2e-3);
}

// The limit is 1.28667 L^{2/3} as two numbers go to 0: ML^{−2/3}, the effect of elastic bodies, and
// 1/(ML^{2/3}), the effect of a liquid whose viscosity rises too little.
TEST(FilmLimits, RigidAndPiezoviscous) {
  const ehl::Estimate limit = fitted_limit(
      {{0.25, 200},
       {0.25, 400},
       {0.5, 100},
       {0.5, 200},
       {0.75, 100},
       {0.75, 200},
       {1, 100},
       {1, 200},
       {1.5, 200}},
      0, 2. / 3, 1e-3, [](const ehl::LineContact& contact, double) {
        const double power = std::pow(contact.material_number, 2. / 3);
        const double a = contact.load_number / power, b = 1 / (contact.load_number * power);
        return Eigen::RowVectorXd{{1, a, a * a, a * b}};
      });
  EXPECT_TRUE(is_estimated(limit, 1.28667, 0.000005));
  EXPECT_LT(limit.error, 2e-3);
}

// Inlet and constriction have the width δ = H^{2/3}, and a pressure of about √δ, so that the area
// between the film's pressure and the dry one falls with δ^{3/2}.
TEST(FilmLimits, PressureTendsToThatOfDryContact) {
  double before = 0, width_before = 0;
  for (const double m : {10.0, 100.0, 1000.0}) {
    const SolvedFilm film = solved(ehl::barus_contact(m, 0), {.tolerance = 1e-3});
    const ehl::Numbers& x = film.film.x;
    double area = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
      const double dry = std::sqrt(std::max(0.0, 1 - x[i] * x[i]));
      area += std::abs(film.film.pressure[static_cast<Eigen::Index>(i)] - dry) *
              (x[i + 1] - x[i - 1]) / 2;
    }
    const double width = std::pow(film.at_greatest_pressure.value, 2. / 3);
    EXPECT_LT(area, 5 * std::pow(width, 1.5)) << "M = " << m;
    if (before > 0) {
      EXPECT_TRUE(is_within(std::log(before / area) / std::log(width_before / width), 1.5, 0.15))
          << "M = " << m;
    }
    before = area;
    width_before = width;
  }
}

}  // namespace
}  // namespace tribo::verification
