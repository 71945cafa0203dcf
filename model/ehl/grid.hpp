// SPDX-License-Identifier: Apache-2.0
// Nodes across the contact, dense where the pressure bends: at the inlet, at the outlet's
// constriction and at the spike. A grid of 2N cells has all nodes of the grid of N cells, so that
// their films differ by the error of discretisation alone.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "ehl/line_contact.hpp"

namespace tribo::ehl {

using Numbers = std::vector<double>;

// The places of nodes by their density over X, kept as the share of the nodes below each place.
class NodeDensity {
 public:
  // density[i] > 0 holds between place[i] and place[i + 1]; places rise.
  NodeDensity(Numbers place, std::span<const double> density);

  // cells + 1 nodes, the first and the last at the ends of the domain.
  Numbers nodes(int cells) const;

 private:
  Numbers place_, share_;
};

// Lengths of a contact, in X, estimated before it is solved.
struct Scales {
  double edge;        // the width of the inlet and of the constriction, in X
  double inlet_end;   // where the liquid's pressure starts, far from the contact: below −1
  double outlet_end;  // behind the end of the film
  double reach;       // how far pressure reaches from the middle, at least: 1 or more
};
// A film number of the right size, from the four limits that Moes' formula joins (moes_line.hpp):
// the greatest of RI, EI and the lesser of RP and EP, with rounded constants.
double expected_film(const LineContact& contact);
// The inlet is so long that its end changes the film by 3e-7 at most. This change falls with the
// second power of the inlet's length.
Scales scales_of(const LineContact& contact);
// A density for a contact that has not been solved.
NodeDensity first_density(const Scales& scales);

// A density for a solved film, by its slope, by the distance from the middle and by the root of the
// pressure's curvature: the error of pressure that is linear between nodes is proportional to this
// curvature. The density is at most `at_edge` over the width of the outlet's constriction, so that
// a sharp spike does not draw all nodes.
NodeDensity density_of(std::span<const double> x, std::span<const double> pressure,
                       std::span<const double> film, double at_edge);

// Values ≥ 0 at other places, in rising order, by cubics through four nodes. No result is below 0;
// between a value of 0 and its neighbour it stays within these two. Where a cubic departs from the
// straight line between two nodes by more than `greatest_bend` of its rise, the line is taken.
Numbers interpolated(std::span<const double> x, std::span<const double> values,
                     std::span<const double> to,
                     double greatest_bend = std::numeric_limits<double>::infinity());

}  // namespace tribo::ehl
