// SPDX-License-Identifier: Apache-2.0
// What the groups of report.json are made of by Python (groups/report.py), where no command says
// it. Each function throws std::exception where it cannot be made: the page says why in place of
// the group.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "page/cases.hpp"
#include "page/project_files.hpp"

namespace tribo::report {

using Json = nlohmann::ordered_json;

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
