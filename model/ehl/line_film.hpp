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
  not_converged,  // the greatest number of steps was made
  stopped         // the caller said so
};

struct LineFilm {
  Outcome outcome = Outcome::not_converged;
  Numbers x;                       // nodes
  Eigen::VectorXd pressure, film;  // P and H there
  double mass_flow = 0;            // ρ̄H where dP/dX = 0
  double separation = 0;           // H₀
  int steps = 0;                   // of Newton's method, with those on the way to this contact
  double last_change = 0;          // of the pressure, in the last step
  std::size_t bytes = 0;           // what the matrices took
};

// Told before every step of Newton's method; false: stop.
struct Step {
  LineContact contact;  // on the way: often another than the one asked for
  int cells;
  int step;
  double change;  // of the pressure in the step before
};
using Watch = std::function<bool(const Step&)>;

struct NewtonLimits {
  int steps = 60;
  double change = 1e-10;  // of P and of H₀, that a converged step stays below
};

// From a guess: pressures ≥ 0 at the nodes, 0 at both ends, and H₀.
LineFilm solve_from(const LineContact& contact, const Numbers& x, const Eigen::VectorXd& guess,
                    double separation, const NewtonLimits& limits, const Watch& watch);

// From nothing: on a coarse grid by way of contacts of smaller load number with a liquid of
// constant viscosity, and then of smaller material number.
LineFilm solve_from_nothing(const LineContact& contact, int cells, const Scales& scales,
                            const Watch& watch);

// A solved film on other nodes.
LineFilm solve_on(const LineContact& contact, const Numbers& x, const LineFilm& film,
                  const Watch& watch);

}  // namespace tribo::ehl
