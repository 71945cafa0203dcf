// SPDX-License-Identifier: Apache-2.0
// Manufactured solutions: pressure, film and missing liquid are given functions. Sources of liquid
// make them a solution of all equations of a point contact, and the solver has to find it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ehl/films.hpp"
#include "ehl/point_film.hpp"

namespace tribo::verification {
namespace {

using std::numbers::pi;

// The pressure P = A(1 − r²)^{5/2} of the load ∬P = 2πk/3, over bodies of any shape. Its integral
// ∬P/distance is a polynomial for r < 1, and a hypergeometric series outside: K. L. Johnson:
// Contact Mechanics (1985), section 3.4.
class GivenFilm {
 public:
  GivenFilm(const ehl::PointContact& contact, double least)
      : contact_(contact),
        numbers_(ehl::numbers_of(contact)),
        peak_(7. / 3 * numbers_.ellipticity) {
    for (double x = -1.5; x <= 1.5; x += 0.05)
      for (double y = 0; y <= 1.5; y += 0.05)
        separation_ = std::max(separation_, least - gap(x, y));
  }

  double separation() const { return separation_; }
  double film(double x, double y) const { return separation_ + gap(x, y); }
  double pressure(double x, double y) const {
    return peak_ * std::pow(std::max(0., 1 - x * x - y * y), 2.5);
  }
  // 0 where there is pressure. Elsewhere it grows with the distance, up to half of the film.
  double missing(double x, double y) const {
    const double beyond = std::max(0., x * x + y * y - 1), square = beyond * beyond;
    return contact_.is_starved() ? film(x, y) / 2 * square / (0.3 + square) : 0;
  }
  // The flow of liquid along X; across(): along Y.
  double along(double x, double y) const {
    const double dragged = contact_.fluid.density(pressure(x, y)) * film(x, y) - missing(x, y);
    return dragged + x * by_slope(x, y);
  }
  double across(double x, double y) const { return y * by_slope(x, y); }

 private:
  // −ρ̄H³/(η̄λ̄) (dP/dr)/r.
  double by_slope(double x, double y) const {
    const double p = pressure(x, y), h = film(x, y), square = std::max(0., 1 - x * x - y * y);
    return contact_.fluid.density(p) * h * h * h * std::exp(-contact_.fluid.log_viscosity(p)) /
           numbers_.wedge * 5 * peak_ * std::pow(square, 1.5);
  }
  // The film without H₀.
  double gap(double x, double y) const {
    const double square = x * x + y * y;
    double integral = 5 * pi * pi / 16 * (1 + square * (-1.5 + square * (1.125 - square * 0.3125)));
    if (square > 1) {
      double term = 2 * pi / 7 / std::sqrt(square);
      integral = 0;
      for (int n = 0; n < 400; ++n) {
        integral += term;
        term *= (n + 0.5) * (n + 0.5) / ((n + 4.5) * (n + 1)) / square;
      }
    }
    return x * x / 2 + y * y / (2 * contact_.radius_ratio) + numbers_.deflection * peak_ * integral;
  }

  ehl::PointContact contact_;
  ehl::PointNumbers numbers_;
  double peak_, separation_ = -1e300;
};

struct Errors {
  std::array<double, 3> film{}, pressure{}, missing{}, separation{};
};

// The greatest errors on three grids.
Errors errors_of(ehl::PointContact contact, double least) {
  Errors errors;
  const GivenFilm given(contact, least);
  for (std::size_t level = 0; level < 3; ++level) {
    const int cells = 12 << level;
    const ehl::PlaneGrid grid{3 * cells / 2, 3 * cells / 2, 3 * cells / 2, 1. / cells, 1. / cells};
    // The flow out of a node's surroundings less the flow in: no liquid is lost between nodes.
    contact.source = [&](double x, double y) {
      const double h = grid.dx / 2;
      // Liquid is taken away outside of r = 1, so that there is no pressure.
      if (!contact.is_starved() && x * x + y * y >= 1) return -5 * grid.dx;
      const double before = x - h < grid.x(0) ? contact.inlet_film : given.along(x - h, y);
      return given.along(x + h, y) - before + given.across(x, y + h) - given.across(x, y - h);
    };
    ehl::PointFilm start;
    start.grid = grid;
    start.separation = given.separation();
    start.pressure = start.film = Eigen::VectorXd(grid.size());
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i < grid.count_x(); ++i) {
        start.pressure[grid.node(i, j)] = given.pressure(grid.x(i), grid.y(j));
        start.film[grid.node(i, j)] = given.film(grid.x(i), grid.y(j));
      }
    const ehl::PointFilm film = ehl::solve_on(contact, grid, start, {});
    EXPECT_EQ(film.outcome, ehl::Outcome::solved) << cells << " cells: " << film.last_change;
    errors.separation[level] = std::fabs(film.separation - given.separation());
    for (int j = 0; j + 1 < grid.count_y(); ++j)
      for (int i = 1; i + 1 < grid.count_x(); ++i) {
        const double x = grid.x(i), y = grid.y(j), r = std::hypot(x, y);
        const Eigen::Index n = grid.node(i, j);
        const auto note = [&](double& worst, double off) {
          worst = std::fmax(worst, std::fabs(off));
        };
        note(errors.film[level], film.film[n] - given.film(x, y));
        if (r < 0.9) note(errors.pressure[level], film.pressure[n] - given.pressure(x, y));
        if (contact.is_starved() && r > 1.1)
          note(errors.missing[level], film.missing[n] - given.missing(x + grid.dx / 2, y));
      }
  }
  return errors;
}

// The error on the finest grid is at most `most`, absolutely, and is of second order.
void expect_second_order(const std::array<double, 3>& errors, double most, const char* of,
                         double ratio) {
  EXPECT_TRUE(is_within(errors[2], 0, most)) << of << ", R_y/R_x = " << ratio;
  EXPECT_TRUE(is_within(std::log2(errors[1] / errors[2]), 2, 0.3))
      << of << ", R_y/R_x = " << ratio << ": errors " << errors[1] << " and " << errors[2];
}

// At the peak of the pressure the viscosity is e² times that at 0.
ehl::PointContact contact_of(double load, double ratio, double inlet_film,
                             double density_pressure) {
  ehl::PointContact contact{load, 0, ratio};
  contact.fluid.exponent = 6. / (7 * ehl::numbers_of(contact).ellipticity);
  contact.fluid.density_pressure = density_pressure;
  contact.inlet_film = inlet_film;
  return contact;
}

// The load is so great that the far inlet's pressure at the ends of the grid is nearly 0.
TEST(PointSolver, FindsAGivenPressureAndFilmAtSecondOrder) {
  constexpr double ratio = 0.4;
  const Errors errors = errors_of(contact_of(1e4, ratio, INFINITY, 0), 0.03);
  expect_second_order(errors.film, 6e-4, "film", ratio);
  expect_second_order(errors.pressure, 3e-3, "pressure", ratio);
}

// The edge of the pressure cuts a cell in each row: missing liquid has an error of first order.
TEST(PointSolver, FindsGivenMissingLiquidBesideThePressure) {
  for (const double ratio : {1., 3., 0.4}) {
    const Errors errors = errors_of(contact_of(30, ratio, 0.5, ratio > 1 ? 1 : 0), 0.1);
    expect_second_order(errors.film, 1.5e-3, "film", ratio);
    expect_second_order(errors.pressure, 5e-3, "pressure", ratio);
    expect_second_order(errors.separation, 3e-4, "separation", ratio);
    EXPECT_TRUE(is_within(errors.missing[2], 0, 0.03)) << "R_y/R_x = " << ratio;
    EXPECT_LT(errors.missing[2], 0.6 * errors.missing[1]) << "R_y/R_x = " << ratio;
  }
}

}  // namespace
}  // namespace tribo::verification
