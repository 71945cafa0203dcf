// SPDX-License-Identifier: Apache-2.0
#include "sweep/cases.hpp"

#include <algorithm>

#include "sweep/correlation.hpp"

namespace tribo::sweep {

CaseGenerator::CaseGenerator(const SceneSweep& sweep)
    : sweep_(sweep), grids_(sweep.variables.size() - sweep.drawn()), drawn_(sweep.drawn()) {
  if (drawn_ == 0) return;
  // With sensitivity a point has twice the dimensions: it gives the cases A and B.
  points_.emplace(sweep.design, drawn_ * sweep.cases_kept_per_group(), sweep.draws, sweep.seed);
}

void CaseGenerator::groups(std::uint64_t first, std::span<double> values) {
  const std::size_t variables = sweep_.variables.size();
  const std::size_t group_size = sweep_.cases_per_group() * variables;
  const std::size_t count = values.size() / group_size;
  const std::size_t dimensions = drawn_ * sweep_.cases_kept_per_group();
  unit_.resize(count * dimensions);
  draw(first, count);
  for (std::size_t i = 0; grids_ > 0 && i < count; ++i)
    take_from_grids(first + i, values.subspan(i * group_size, grids_));
  for (std::size_t matrix = 0; drawn_ > 0 && matrix < sweep_.cases_kept_per_group(); ++matrix)
    quantiles({&unit_[matrix * drawn_], dimensions},
              {&values[matrix * variables + grids_], group_size}, count);
  if (!sweep_.sensitivity) return;
  for (std::size_t i = 0; i < count; ++i) mix(values.subspan(i * group_size, group_size));
}

// Each set of grid values gets the same draws, so that chance does not hide the effect of the grid.
void CaseGenerator::draw(std::uint64_t group, std::size_t count) {
  if (drawn_ == 0 || count == 0) return;
  const std::size_t dimensions = unit_.size() / count;
  for (std::size_t done = 0; done < count;) {
    const std::uint64_t draw = (group + done) % sweep_.draws;
    const auto most =
        static_cast<std::size_t>(std::min<std::uint64_t>(count - done, sweep_.draws - draw));
    points_->points(draw, std::span(unit_).subspan(done * dimensions, most * dimensions));
    done += most;
  }
}

void CaseGenerator::take_from_grids(std::uint64_t group, std::span<double> values) const {
  std::uint64_t cell = group / sweep_.draws;
  for (std::size_t v = grids_; v-- > 0;) {
    const std::vector<double>& grid = sweep_.variables[v].grid;
    values[v] = grid[cell % grid.size()];
    cell /= grid.size();
  }
}

// Works field by field, so that each distribution is asked for many quantiles at once.
void CaseGenerator::quantiles(Rows<const double> unit, Rows<double> values, std::size_t count) {
  const auto variables = std::span(sweep_.variables).subspan(grids_);
  if (sweep_.correlation_root.empty()) {
    for (std::size_t v = 0; v < drawn_; ++v)
      variables[v].distribution.quantiles({unit.first + v, unit.stride},
                                          {values.first + v, values.stride}, count);
    return;
  }
  normals_.resize(count * drawn_);
  for (std::size_t i = 0; i < count; ++i) std::copy_n(unit[i], drawn_, &normals_[i * drawn_]);
  standard_normals(normals_);
  for (std::size_t i = 0; i < count; ++i)
    correlate(sweep_.correlation_root, std::span(normals_).subspan(i * drawn_, drawn_));
  for (std::size_t v = 0; v < drawn_; ++v)
    variables[v].distribution.quantiles_of_normals({&normals_[v], drawn_},
                                                   {values.first + v, values.stride}, count);
}

void CaseGenerator::mix(std::span<double> group) const {
  const std::size_t variables = sweep_.variables.size();
  const auto a = group.first(variables), b = group.subspan(variables, variables);
  for (std::size_t i = 0; i < drawn_; ++i) {
    const auto mixed = group.subspan((2 + i) * variables, variables);
    std::copy(a.begin(), a.end(), mixed.begin());
    mixed[i] = b[i];
  }
}

}  // namespace tribo::sweep
