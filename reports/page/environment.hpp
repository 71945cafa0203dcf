// SPDX-License-Identifier: Apache-2.0
// Where and when the page was made, and how old what it shows is. Nothing else of the page depends
// on it.
#pragma once

#include <string>

#include "page/project_files.hpp"
#include "page/section.hpp"

namespace tribo::report {

// "AMD EPYC", and "g++ 12.2.0"; "unknown" where the machine does not tell.
std::string processor_name();
std::string compiler_name();

// `commit`: what was built, where it is known. The date is today's, or that of SOURCE_DATE_EPOCH.
Section environment_section(const ReportPlaces& places, const std::string& commit);

}  // namespace tribo::report
