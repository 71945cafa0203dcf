// SPDX-License-Identifier: Apache-2.0
#include "ehl/point_needs.hpp"

#include <algorithm>
#include <cmath>

namespace tribo::ehl {

PlaneGrid PointNeeds::finest(int grids) const {
  PlaneGrid grid = coarsest;
  for (int i = 1; i < grids; ++i) grid = grid.finer();
  return grid;
}

PointNeeds needs_of(const PointContact& contact, const PointOptions& options) {
  PointNeeds needs;
  // The solver itself says which grid it begins with, or why it does not begin.
  int first_cells = 0;
  const SolvedPoint begun = solve_point_film(contact, options, [&](const Step& step) {
    first_cells = step.cells;
    return false;
  });
  if (begun.outcome != Outcome::stopped) {
    needs.reason = begun.reason;
    return needs;
  }
  int cells = 1;  // along the length that the pressure covers
  while ((needs.coarsest = grid_for(contact, cells)).count_x() - 1 < first_cells) ++cells;
  while (needs.finest(needs.most_grids + 1).size() <= options.greatest_nodes) ++needs.most_grids;
  for (double longer = 1; longer < greatest_length; longer *= length_step) {
    PlaneGrid grid = grid_for(contact, cells, longer);
    while (4 * grid.size() <= options.greatest_nodes) grid = grid.finer();
    needs.most_nodes = std::max(needs.most_nodes, grid.size());
  }
  // The solver may begin again with more cells if only three grids fit and their error is too
  // great.
  if (needs.most_grids > 3) return needs;
  for (int i = 1; i < most_coarsest_grids; ++i) {
    cells = more_cells(contact, cells, options);
    if (cells > 0)
      needs.most_nodes =
          std::max(needs.most_nodes, grid_for(contact, cells).finer().finer().size());
  }
  return needs;
}

double point_memory(Eigen::Index nodes) {
  const auto count = static_cast<double>(nodes);
  return 1400 * count * std::pow(count / 20'000, 0.075);
}

double point_seconds(const PointContact& contact, Eigen::Index nodes) {
  const double l = contact.material_number / 9;
  // A starved contact's flooded film is solved, too, and takes as long on the same number of nodes.
  const double films = contact.is_starved() ? 2 : 1;
  return films * 10e-6 * static_cast<double>(nodes) * std::pow(contact.load_number, 0.2) *
         (1 + l * l);
}

}  // namespace tribo::ehl
