// SPDX-License-Identifier: Apache-2.0
// The line contacts among the scenes of some folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/project_files.hpp"
#include "page/solved_case.hpp"
#include "tribo/scene.hpp"

namespace tribo::report {

struct LineScene {
  std::string name;  // of its file, without .toml
  std::string file;  // as provenance names it
  Scene scene;
  SpeedRange range;
};

// Of the folder's *.toml that are scenes with speeds, in the order of their names.
std::vector<LineScene> line_scenes(const ReportPlaces& places, const std::filesystem::path& folder);

}  // namespace tribo::report
