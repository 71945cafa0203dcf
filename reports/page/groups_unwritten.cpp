// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "page/groups.hpp"

namespace tribo::report {
namespace {
[[noreturn]] Group unwritten() { throw std::runtime_error("this group is not written yet"); }
}  // namespace
Group paper_group(const ReportPlaces&, const std::vector<SolvedCase>&) { unwritten(); }
Group ledger_group(const ReportPlaces&, const reproduction::Ledger&) { unwritten(); }
Group onset_uncertainty_group(const ReportPlaces&, const reproduction::Ledger&) { unwritten(); }
Group certified_group(const ReportPlaces&) { unwritten(); }
Group stress_group(const ReportPlaces&) { unwritten(); }
Group planted_faults_group(const ReportPlaces&) { unwritten(); }
Group work_precision_group(const ReportPlaces&) { unwritten(); }
Group gates_group(const ReportPlaces&) { unwritten(); }
Group sweep_speed_group(const ReportPlaces&) { unwritten(); }
Group skipped_work_group(const ReportPlaces&, const std::vector<SolvedCase>&) { unwritten(); }
}  // namespace tribo::report
