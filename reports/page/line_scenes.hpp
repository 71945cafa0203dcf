// SPDX-License-Identifier: Apache-2.0
// The line contacts among the scenes of some folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/project_files.hpp"
#include "tribo/scene.hpp"

namespace tribo::report {

struct SpeedRange {
  double low;   // m/s
  double high;  // m/s
};

struct LineScene {
  std::string name;  // the file's, without .toml
  std::string file;  // as provenance names it
  Scene scene;
  SpeedRange range;
};

// The folder's *.toml that are scenes with speeds, in the order of their names.
std::vector<LineScene> line_scenes(const ReportPlaces& places, const std::filesystem::path& folder);

}  // namespace tribo::report
