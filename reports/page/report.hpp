// SPDX-License-Identifier: Apache-2.0
// The report: the paper's scenes solved, its figures redrawn, one page, and a table.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "page/project_files.hpp"

namespace tribo::report {

struct Report {
  std::string tables;                 // what is computed beside what is reported, aligned
  std::string verdict;                // a few lines: the paper's claims, and this software
  std::string folder;                 // where it lies, and
  std::vector<std::string> written;   // every file written, below that folder
  std::vector<std::string> warnings;  // about the scenes
  std::vector<std::string> undrawn;   // why figures are missing; empty when all are there
};

// `progress` is called with the name of each step that begins. Throws ReportError.
Report write_report(const ReportOptions& options,
                    const std::function<void(std::string_view)>& progress);

}  // namespace tribo::report
