// SPDX-License-Identifier: Apache-2.0
// Pressure and film of a line contact on one grid: Newton's method for all nodes at once, in which
// each node is either free (its mass balances) or broken (its pressure is 0).
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <functional>

#include "ehl/grid.hpp"
#include "ehl/line_contact.hpp"

namespace tribo::ehl {

enum class Outcome : std::uint8_t {
  solved,
  not_converged,  // no part of a step helps, or the greatest number of steps was made
  stopped         // the caller said so
};

struct LineFilm {
  Outcome outcome = Outcome::not_converged;
  Numbers x;                       // nodes
  Eigen::VectorXd pressure, film;  // P and H there
  double mass_flow = 0;            // ρ̄H where dP/dX = 0
  double separation = 0;           // H₀
  int steps = 0;                   // with those on the grids before, and those in time
  double last_change = 0;          // of the pressure, in the last step
  std::size_t bytes = 0;           // what the matrices took
};

// Told before every step; false: stop.
struct Step {
  int cells;
  int step;
  double change;  // of the pressure in the step before
};
using Watch = std::function<bool(const Step&)>;

struct NewtonLimits {
  int steps = 40;
  double change = 1e-10;  // of P and of H₀, that is left after a converged step, at most
};

// From a guess: pressures ≥ 0 at the nodes, 0 at both ends, and H₀.
LineFilm solve_from(const LineContact& contact, const Numbers& x, const Eigen::VectorXd& guess,
                    double separation, const NewtonLimits& limits, const Watch& watch);

// From nothing: the pressure of dry contact over a film of the expected thickness, from which the
// film goes on in time until it is steady. Where it does not come to rest, so does that of a liquid
// whose viscosity rises less, and from there Newton's method follows the rise.
LineFilm solve_from_nothing(const LineContact& contact, int cells, const Scales& scales,
                            const Watch& watch);

// A solved film on other nodes: by Newton's method from there, and where it does not converge as
// the film goes on in time from there.
LineFilm solve_on(const LineContact& contact, const Numbers& x, const LineFilm& film,
                  const Watch& watch);

}  // namespace tribo::ehl
