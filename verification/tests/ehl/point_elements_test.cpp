// SPDX-License-Identifier: Apache-2.0
// Points solved by finite elements (generators/point_elements.hpp): their parts, and the films
// against those of model/ehl.
#include "generators/point_elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ehl/films.hpp"
#include "ehl/solved_point.hpp"
#include "generators/point_mesh.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

// ∬ P/r of P = (1 + X² + Y²)^{−3/2} is 2π/√(1 + X² + Y²) on the plane.
TEST(FilmMatrix, IsTheIntegralOfAPressureThatHasAClosedForm) {
  const auto pressure = [](double x, double y) { return std::pow(1 + x * x + y * y, -1.5); };
  for (const double step : {0.25, 0.125}) {
    const reference::PointMesh mesh{reference::graded(50, 50, 0.5, 0.5, step),
                                    reference::graded(0, 50, 0.5, 0.5, step)};
    EXPECT_TRUE(is_within(-mesh.x.front(), 50, 1e-10)) << "sides of " << step;
    EXPECT_TRUE(is_within(mesh.y.back(), 50, 1e-10)) << "sides of " << step;
    Eigen::VectorXf p(mesh.size());
    for (Eigen::Index j = 0; j < mesh.ny(); ++j)
      for (Eigen::Index i = 0; i < mesh.nx(); ++i)
        p[mesh.node(i, j)] =
            static_cast<float>(pressure(mesh.x[reference::at(i)], mesh.y[reference::at(j)]));
    const Eigen::VectorXf film = reference::film_matrix(mesh) * p;
    for (Eigen::Index j = 0; j < mesh.ny(); j += 3)
      for (Eigen::Index i = 0; i < mesh.nx(); i += 3) {
        const double x = mesh.x[reference::at(i)], y = mesh.y[reference::at(j)];
        if (std::hypot(x, y) > 5) continue;
        // Elements of the side h interpolate P to the second order; the rest lies beyond 50.
        EXPECT_TRUE(is_within(static_cast<double>(film[mesh.node(i, j)]),
                              2 * std::numbers::pi / std::hypot(1, x, y), 2.5 * step * step + 0.01))
            << "sides of " << step << ", " << x << ", " << y;
      }
  }
}

TEST(PointElements, FilmsAreThoseOfTheSolverWithinBothErrors) {
  for (const double ratio : {1., 4.}) {
    const ehl::PointContact contact = ehl::barus_point(20, 2.5, ratio);
    const ehl::SolvedPoint expected = solve_point_film(contact, {.tolerance = 1e-2});
    const reference::ElementFilm film =
        reference::solve_point_film_by_elements(contact, {.cells = 5, .reach = 100});
    ASSERT_EQ(expected.outcome, ehl::Outcome::solved) << expected.reason;
    ASSERT_TRUE(film.is_solved) << film.reason;
    EXPECT_TRUE(is_estimated(film.central, expected.central.value, expected.central.error))
        << "central film H of M = 20, L = 2.5, R_y/R_x = " << ratio;
    EXPECT_TRUE(is_estimated(film.minimum, expected.minimum.value, expected.minimum.error))
        << "least film H of M = 20, L = 2.5, R_y/R_x = " << ratio;
    // Errors so great that every film agrees would show nothing.
    EXPECT_LE(film.central.relative_error(), 0.01);
    EXPECT_LE(film.minimum.relative_error(), 0.1);
  }
}

}  // namespace
}  // namespace tribo::verification
