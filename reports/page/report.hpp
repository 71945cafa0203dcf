// SPDX-License-Identifier: Apache-2.0
// The report: the paper's scenes solved and all else that its page shows, as report.json and files
// of data; then the page and its figures, which render/render.py makes of them.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "page/project_files.hpp"

namespace tribo::report {

struct Report {
  std::string verdict;  // some lines: the paper's first numbers and claims, and this software
  std::string folder;   // where the report lies, and
  std::vector<std::string> written;   // every file written, below that folder
  std::vector<std::string> warnings;  // about the scenes
  std::vector<std::string> undrawn;  // why the page or its figures are missing; empty: all is there
  bool has_page = false;
};

// `progress` is called with the name of each step that begins. Throws ReportError, or
// protocol::OutputFailed where a file cannot be written.
Report write_report(const ReportOptions& options,
                    const std::function<void(std::string_view)>& progress);

// The machine and the compiler, as the page and the baselines of `tribocheck bench` name them.
// "AMD EPYC", and "g++ 12.2.0"; "unknown" where the machine does not tell.
std::string processor_name();
std::string compiler_name();

}  // namespace tribo::report
