// SPDX-License-Identifier: Apache-2.0
// Facts of which Python makes the groups of report.json (groups/report.py), where no command says
// them. Each function throws std::exception where it cannot be made: the page says why in place of
// the group.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/project_files.hpp"
#include "tribo/scene.hpp"

namespace tribo::report {

using Json = nlohmann::ordered_json;

// The six scenes of the report: three surfaces, each as Greenwood–Tripp and Greenwood–Williamson.
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

// null where there is no number. JSON has no NaN and no infinity: they are written as null too.
inline Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// The published scenes before they are solved, by their stems, as `scenes`, and all their `inputs`.
// Throws ReportError where claims.tsv cannot be read.
Json paper_facts(const ReportPlaces& places, const std::vector<Case>& cases);
// Scenes of a circle, an ellipse and a line, before they are solved: reference/scenes.
Json contacts_facts(const ReportPlaces& places);

// Whole groups: their `data`, and the texts of their `files` by the paths below the report's
// folder.

// Published fits to Hertz' ellipse beside the ellipse.
Json ellipse_fits_facts(const ReportPlaces& places);
// Evaluations that scenes with fewer outputs save.
Json skipped_work_facts(const std::vector<Case>& cases);

}  // namespace tribo::report
