// SPDX-License-Identifier: Apache-2.0
// The numbers of figures as tab-separated files, from which gnuplot draws them.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "page/comparison.hpp"
#include "page/data_file.hpp"
#include "page/two_slopes.hpp"

namespace tribo::report {

std::vector<DataFile> data_files(const std::vector<SolvedCase>& solved, const TwoSlopes& slopes,
                                 const std::vector<reproduction::Item>& claims,
                                 const std::vector<ComparisonRow>& rows);

// A curve, with the columns of all curves; `file` is the scene's.
DataFile curve_file(std::string_view path, std::string_view file, const std::vector<Point>& curve);

// Points with a name each, in the same columns behind the name.
struct NamedPoint {
  std::string_view name;
  std::optional<Point> point;  // none: left out
};
DataFile points_file(std::string_view path, std::string_view what, std::string_view made_from,
                     const std::vector<NamedPoint>& points);

}  // namespace tribo::report
