// SPDX-License-Identifier: Apache-2.0
// Solves the equations of a flooded point contact (ehl/point_contact.hpp) in a second way, which
// shares only these equations with model/ehl. It checks that solver, and is the second method of
// the solver's table.
//
// P is bilinear on rectangular elements, and 0 at the far ends of their mesh (point_mesh.hpp).
// Galerkin's equations alone become ∂H/∂X = 0 where the liquid is very viscous, and then do not
// couple neighbouring nodes. Therefore τ ∂w/∂X is added to each test function w, and multiplies the
// whole residual ∂H/∂X − ∇·(ε∇P), with ε = H³/(λ̄η̄). τ = (coth Pe − 1/Pe)h/2 with Pe = ch²/ε, the
// contact's c and the element's length h along X (A. N. Brooks, T. J. R. Hughes: Streamline
// upwind/Petrov–Galerkin formulations. Comput. Methods Appl. Mech. Eng. 32 (1982) 199). ∇·(ε∇P) is
// computed from slopes at the nodes, which are differences of second order, because bilinear
// functions have no second derivatives. A penalty keeps P from falling much below 0.
#pragma once

#include <limits>
#include <string>

#include "ehl/point_contact.hpp"
#include "ehl/solved_film.hpp"

namespace tribo::reference {

struct ElementOptions {
  double cells = 8;      // per unit of X and of Y/k in the middle, on the coarsest mesh of three
  double reach = 300;    // of the elements, in X and Y/k
  double penalty = 1e4;  // on P < 0, per unit of area
};

struct ElementFilm {
  bool is_solved = false;
  std::string reason;              // why it is not solved, in a sentence
  ehl::Estimate central, minimum;  // H at X = Y = 0, and the least H
  int nodes = 0;                   // of the finest mesh
  int steps = 0;                   // of Newton's method, in all
};

// The numbers are Richardson's extrapolation from meshes with 1, 3/2 and 2 times the cells, plus
// their change from half the reach to the reach. (The load beyond the reach falls as 1/reach, so
// that an infinite reach would change the numbers by as much again.) Their error is chosen, not
// proven. It is a sum of three parts: the last change of Richardson's value, twice; its difference
// from the value on the finest mesh, times 1/8 (least film: 1/2); and a quarter of the change by
// the reach. Where Newton's method fails, as with L = 10 at M = 50, L = 5 at M = 200, and L = 5 at
// M = 20 and R_y/R_x = 1/2, `reason` says so. `contact` is flooded and incompressible.
ElementFilm solve_point_film_by_elements(const ehl::PointContact& contact,
                                         const ElementOptions& options = {});

}  // namespace tribo::reference
