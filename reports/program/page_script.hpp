// SPDX-License-Identifier: Apache-2.0
// The scripts in Python that make pages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "messages.hpp"

namespace tribo::cli {

// Runs the script, writes its text to stdout, and returns its exit code. Where python3 is missing,
// a line says that no `made` (the word for what the script makes) can be made.
int run_page_script(const std::filesystem::path& script, const std::vector<std::string>& arguments,
                    const char* made, OutputStream& output);

}  // namespace tribo::cli
