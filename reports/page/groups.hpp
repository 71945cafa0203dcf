// SPDX-License-Identifier: Apache-2.0
// The groups of report.json that are not made by Python (groups/report.py) alone, one function
// each: whole groups, and facts of scenes that Python makes a group of. Where a group cannot be
// made, its function throws std::exception: the page says why in place of the group.
#pragma once

#include <string>
#include <vector>

#include "page/cases.hpp"
#include "page/group.hpp"
#include "page/project_files.hpp"

namespace tribo::report {

// The published scenes: their inputs, and what is known before they are solved. Throws ReportError
// where claims.tsv cannot be read.
Group paper_facts(const ReportPlaces& places, const std::vector<Case>& cases);
// Scenes of a circle, an ellipse and a line, before they are solved: reference/scenes.
Group contacts_facts(const ReportPlaces& places);
// Film formulas of a line contact beside its solved film: reference/ehl, reference/scenes.
Group line_films_group(const ReportPlaces& places);
// Published fits to Hertz' ellipse beside the ellipse.
Group ellipse_fits_group(const ReportPlaces& places);
// Evaluations that scenes with fewer outputs save.
Group skipped_work_group(const std::vector<Case>& cases);

}  // namespace tribo::report
