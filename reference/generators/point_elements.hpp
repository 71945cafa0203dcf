// SPDX-License-Identifier: Apache-2.0
// The equations of a flooded point contact (ehl/point_contact.hpp) solved a second way, which
// shares nothing with model/ehl but these equations: a check of that solver, and the second method
// of its table.
//
// P is bilinear on rectangular elements (point_mesh.hpp) that reach so far that P is 0 at their
// ends. Galerkin's equations alone leave every second node to itself where the liquid is so viscous
// that they are ∂H/∂X = 0. So each test function w has τ ∂w/∂X added, times the whole residual,
// ∂H/∂X − ∇·(ε∇P): τ = (coth Pe − 1/Pe)h/2 with Pe = ch²/ε (A. N. Brooks, T. J. R. Hughes:
// Streamline upwind/Petrov–Galerkin formulations. Comput. Methods Appl. Mech. Eng. 32 (1982) 199),
// where c and ε are those of the contact. ∇·(ε∇P) is made of slopes at the nodes, by differences of
// second order, because bilinear functions have no second derivatives. A penalty keeps P from
// falling much below 0.
#pragma once

#include <limits>
#include <string>

#include "ehl/point_contact.hpp"
#include "ehl/solved_film.hpp"

namespace tribo::reference {

struct ElementOptions {
  double cells = 8;      // along 1 of X and of Y/k in the middle, on the coarsest mesh of three
  double reach = 300;    // of the elements, in X and Y/k
  double penalty = 1e4;  // on P < 0, for 1 of area
};

struct ElementFilm {
  bool is_solved = false;
  std::string reason;              // why it is not solved, in a sentence
  ehl::Estimate central, minimum;  // H at X = Y = 0, and the least H
  int nodes = 0;                   // of the finest mesh
  int steps = 0;                   // of Newton's method, in all
};

// The numbers are Richardson's extrapolation from meshes with 1, 3/2 and 2 times the cells, plus
// the change from half the reach to the reach: the load beyond the reach falls as 1/reach, so that
// all of the rest would change the numbers by as much again. Their error is the sum of twice the
// last change of Richardson's value, an eighth (least film: half) of what it adds to the value on
// the finest mesh, and a quarter of the change by the reach; it is chosen, not proven. Where
// Newton's method fails, as with L = 10 at M = 50, L = 5 at M = 200, and L = 5 at M = 20 and
// R_y/R_x = 1/2, `reason` says so.
// `contact` is flooded and incompressible.
ElementFilm solve_point_film_by_elements(const ehl::PointContact& contact,
                                         const ElementOptions& options = {});

}  // namespace tribo::reference
