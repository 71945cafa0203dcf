// SPDX-License-Identifier: Apache-2.0
// Pictures, made by the Python scripts of reports/page.
#pragma once

#include <string>
#include <vector>

#include "page/project_files.hpp"

namespace tribo::report {

struct Rendering {
  std::vector<std::string> written;  // below the report's folder
  std::vector<std::string> undrawn;  // a line for each reason why the page or a picture is missing
};

// The Python to run: Debian's own, if it exists. Another one in PATH often lacks Debian's packages.
std::string python();

// Runs render/`script` with these arguments. Where Python or one of its packages is missing, or
// where the script fails, `written` is empty and the one line in `undrawn` says so.
Rendering run_script(const ReportPlaces& places, const std::string& script,
                     const std::vector<std::string>& arguments);

}  // namespace tribo::report
