// SPDX-License-Identifier: Apache-2.0
// Pressure and film of a line contact on one grid: Newton's method for all nodes at once, in which
// each node is either free (its mass balances) or broken (its pressure is 0).
#pragma once

#include <Eigen/Dense>

#include "ehl/grid.hpp"
#include "ehl/line_contact.hpp"
#include "ehl/solve_step.hpp"

namespace tribo::ehl {

struct LineFilm {
  Outcome outcome = Outcome::not_converged;
  Numbers x;                       // nodes
  Eigen::VectorXd pressure, film;  // P and H there
  double mass_flow = 0;            // ρ̄H where dP/dX = 0
  double separation = 0;           // H₀
  int steps = 0;                   // with the steps on the grids before, and the steps in time
  double last_change = 0;          // of P or H₀, in the last step
};

// Starts from a guess: pressures ≥ 0 at the nodes, 0 at both ends, and H₀.
LineFilm solve_from(const LineContact& contact, const Numbers& x, const Eigen::VectorXd& guess,
                    double separation, const NewtonLimits& limits, const Watch& watch);

// Starts from the pressure of dry contact over a film of the expected thickness, and follows the
// film in time until it is steady. If the film does not come to rest, the solver starts again with
// a liquid whose viscosity rises less with pressure; then the rise grows in strides, each solved by
// Newton's method.
LineFilm solve_from_nothing(const LineContact& contact, int cells, const Scales& scales,
                            const Watch& watch);

// Takes a solved film to other nodes: by Newton's method, or, where that does not converge, by
// following the film in time.
LineFilm solve_on(const LineContact& contact, const Numbers& x, const LineFilm& film,
                  const Watch& watch);

}  // namespace tribo::ehl
