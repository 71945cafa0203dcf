// SPDX-License-Identifier: Apache-2.0
// Pictures of a sweep's result: which of them there are follows from what the sweep holds.
//
//   onset_distribution    histograms of the onset speed by each criterion, a lane each
//   sensitivity_<column>  Sobol indices of a scalar column, the greatest on top
//   film_map              the film over speed and one field, where a scene is a grid of that field
//                         alone, has three speeds or more and keeps its points
//   curve_band_<column>   median and 95 % band of an output over speed, where fields are drawn
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "page/data_file.hpp"
#include "page/figure.hpp"
#include "page/project_files.hpp"
#include "sweep/result_file.hpp"

namespace tribo::report {

struct SweepPictures {
  std::vector<Figure> figures;
  std::vector<DataFile> data;  // that they are drawn from
};

// `path`: of the result, from which kept points are read where a picture needs them.
SweepPictures sweep_pictures(const sweep::SweepResult& result, const std::string& path);

// Draws the pictures as SVG and PNG into a folder, with their data beside them; makes the folder if
// it is missing. told(line) gets the reason why a picture could not be drawn.
struct DrawnPictures {
  std::vector<std::string> paths;
  bool failed = false;  // a picture that there is to draw is missing
};
DrawnPictures draw_sweep_pictures(const sweep::SweepResult& result, const std::string& path,
                                  const std::string& folder,
                                  const std::function<void(std::string_view)>& told);

}  // namespace tribo::report
