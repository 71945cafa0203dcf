// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all: written beside their place, then renamed into it.
#pragma once

#include <filesystem>
#include <string_view>

#include "sweep/output_file.hpp"

namespace tribo::report {

// Replaces the file that is there, unless told otherwise, or the one that a symbolic link there
// leads to (output_behind_links()). Both throw protocol::OutputFailed.
void write_file(const std::filesystem::path& target, std::string_view content,
                const sweep::Replaceable& replaceable = {.any = true, .only = {}});
void make_folder(const std::filesystem::path& folder);

}  // namespace tribo::report
