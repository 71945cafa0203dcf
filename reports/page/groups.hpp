// SPDX-License-Identifier: Apache-2.0
// The groups of report.json that are not made by Python (groups/report.py), one function each.
// Where a group cannot be made, its function throws std::exception: the page says why in place of
// the group.
#pragma once

#include <string>
#include <vector>

#include "page/group.hpp"
#include "page/project_files.hpp"
#include "page/solved_case.hpp"
#include "reproduction/ledger.hpp"

namespace tribo::report {

// The published scenes solved: inputs, curves, onsets, and each beside what the paper reports.
Group paper_group(const ReportPlaces& places, const std::vector<SolvedCase>& solved);
// The paper's claims under each reading.
Group ledger_group(const ReportPlaces& places, const reproduction::Ledger& ledger);
// Onsets drawn within the precision of Table 1, by a sweep that is run here.
Group onset_uncertainty_group(const ReportPlaces& places, const reproduction::Ledger& ledger);
// Scenes of a circle, an ellipse and a line, solved: reference/scenes.
Group contacts_group(const ReportPlaces& places);
// Film formulas of a line contact beside its solved film: reference/ehl, reference/scenes.
Group line_films_group(const ReportPlaces& places);
// Published fits to Hertz' ellipse beside the ellipse.
Group ellipse_fits_group(const ReportPlaces& places);
// Evaluations that scenes with fewer outputs save.
Group skipped_work_group(const ReportPlaces& places, const std::vector<SolvedCase>& solved);

}  // namespace tribo::report
