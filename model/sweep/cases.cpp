// SPDX-License-Identifier: Apache-2.0
#include "sweep/cases.hpp"

#include <algorithm>

#include "sweep/correlation.hpp"

namespace tribo::sweep {

CaseGenerator::CaseGenerator(const SceneSweep& sweep)
    : sweep_(sweep), grids_(sweep.variables.size() - sweep.drawn()), drawn_(sweep.drawn()) {
  if (drawn_ == 0) return;
  // With sensitivity one point of twice the dimensions gives A and B.
  points_.emplace(sweep.design, drawn_ * sweep.cases_kept_per_group(), sweep.draws, sweep.seed);
  normals_.resize(drawn_);
}

void CaseGenerator::groups(std::uint64_t first, std::span<double> values) {
  const std::size_t group_size = sweep_.cases_per_group() * sweep_.variables.size();
  const std::size_t count = values.size() / group_size;
  const std::size_t dimensions = drawn_ * sweep_.cases_kept_per_group();
  unit_.resize(count * dimensions);
  draw(first, count);
  for (std::size_t i = 0; i < count; ++i)
    fill_group(first + i, std::span(unit_).subspan(i * dimensions, dimensions),
               values.subspan(i * group_size, group_size));
}

// The same draws for each set of grid values: what changes with the grid is not hidden by chance.
void CaseGenerator::draw(std::uint64_t group, std::size_t count) {
  if (drawn_ == 0) return;
  const std::size_t dimensions = unit_.size() / count;
  for (std::size_t done = 0; done < count;) {
    const std::uint64_t draw = (group + done) % sweep_.draws;
    const auto most =
        static_cast<std::size_t>(std::min<std::uint64_t>(count - done, sweep_.draws - draw));
    points_->points(draw, std::span(unit_).subspan(done * dimensions, most * dimensions));
    done += most;
  }
}

void CaseGenerator::fill_group(std::uint64_t group, std::span<const double> unit,
                               std::span<double> values) {
  const std::size_t variables = sweep_.variables.size();
  std::uint64_t cell = group / sweep_.draws;
  for (std::size_t v = grids_; v-- > 0;) {
    const std::vector<double>& grid = sweep_.variables[v].grid;
    values[v] = grid[cell % grid.size()];
    cell /= grid.size();
  }
  if (drawn_ == 0) return;
  quantiles(unit.first(drawn_), values.subspan(grids_, drawn_));
  if (!sweep_.sensitivity) return;
  const auto a = values.first(variables);
  const auto b = values.subspan(variables, variables);
  quantiles(unit.subspan(drawn_), b);
  for (std::size_t i = 0; i < drawn_; ++i) {
    const auto mixed = values.subspan((2 + i) * variables, variables);
    std::copy(a.begin(), a.end(), mixed.begin());
    mixed[i] = b[i];
  }
}

void CaseGenerator::quantiles(std::span<const double> unit, std::span<double> values) {
  const auto variables = std::span(sweep_.variables).subspan(grids_);
  if (sweep_.correlation_root.empty()) {
    for (std::size_t i = 0; i < drawn_; ++i)
      values[i] = variables[i].distribution.quantile(unit[i]);
    return;
  }
  for (std::size_t i = 0; i < drawn_; ++i) normals_[i] = standard_normal(unit[i]);
  correlate(sweep_.correlation_root, normals_);
  for (std::size_t i = 0; i < drawn_; ++i)
    values[i] = variables[i].distribution.quantile_of_normal(normals_[i]);
}

}  // namespace tribo::sweep
