// SPDX-License-Identifier: Apache-2.0
// Pressure and film of a point contact on one grid: Newton's method for all nodes at once. The
// linear equations of a step are solved by GMRES. Its preconditioner is their sparse part,
// factored: there a node's pressure lifts the film of that node alone. The pressures at the grid's
// ends and the load outside follow the film from step to step; their derivatives are left out.
#pragma once

#include <Eigen/Dense>

#include "ehl/plane_grid.hpp"
#include "ehl/point_contact.hpp"
#include "ehl/solve_step.hpp"

namespace tribo::ehl {

struct PointFilm {
  Outcome outcome = Outcome::not_converged;
  PlaneGrid grid{};
  Eigen::VectorXd pressure, film;  // P and H at the nodes
  // The liquid that each node lacks of what a full gap would drag to the next one, in the unit of
  // H. Empty for flooded contacts.
  Eigen::VectorXd missing;
  double separation = 0;   // H₀
  int steps = 0;           // with the steps on the grids before, and the steps in time
  double last_change = 0;  // of P or H₀, in the last step
};

// An estimate of H before the contact is solved: of the right size or below it, from the limits for
// a circle.
double expected_film(const PointContact& contact);
// How far pressure reaches from the middle along X, at least: 1, or more where the bodies hardly
// flatten.
double reach_of(const PointContact& contact);

// The pressure of a film at the nodes of another grid, by cubics along X and then along Y.
Eigen::VectorXd pressure_on(const PlaneGrid& grid, const PointFilm& film);

// Starts from the pressure of dry contact over a film of the expected thickness, and follows the
// film in time until it is steady.
PointFilm solve_from_nothing(const PointContact& contact, const PlaneGrid& grid,
                             const Watch& watch);
// Takes a solved film to another grid: by Newton's method, or, where that does not converge, by
// following the film in time.
PointFilm solve_on(const PointContact& contact, const PlaneGrid& grid, const PointFilm& film,
                   const Watch& watch);

}  // namespace tribo::ehl
