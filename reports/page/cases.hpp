// SPDX-License-Identifier: Apache-2.0
// The six scenes of the report: three surfaces, each as Greenwood–Tripp and Greenwood–Williamson.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "page/project_files.hpp"
#include "tribo/scene.hpp"

namespace tribo::report {

inline constexpr std::array<std::string_view, 3> surfaces{"rough", "medium", "smooth"};

struct Case {
  std::string_view surface;  // one of `surfaces`
  AsperityModel model;
  std::string file;  // as provenance names it
  Scene scene;

  std::string_view short_model() const {
    return model == AsperityModel::greenwood_tripp ? "GT" : "GW";
  }
  std::string stem() const;  // "smooth_gw": of the scene and of its data
};

struct ReadCases {
  std::vector<Case> cases;            // GT rough, medium, smooth, then GW likewise
  std::vector<std::string> warnings;  // one line each, for all scenes that have it
};

// Throws ReportError with every problem of every scene.
ReadCases read_cases(const ReportPlaces& places);

}  // namespace tribo::report
