// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "page/groups.hpp"

namespace tribo::report {
namespace {
[[noreturn]] Group unwritten() { throw std::runtime_error("this group is not written yet"); }
}  // namespace
Group onset_uncertainty_group(const ReportPlaces&, const reproduction::Ledger&) { unwritten(); }
}  // namespace tribo::report
