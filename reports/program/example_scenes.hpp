// SPDX-License-Identifier: Apache-2.0
// The examples of the help name scenes that are there, wherever it is asked for.
#pragma once

#include <functional>
#include <string>

namespace tribo::cli {

// The footer of a help text. Where the current folder has no reference/published, or no
// reference/scenes, that is replaced by the full path of the project's or the installed program's.
std::function<std::string()> footer_with_scenes(std::string text);

}  // namespace tribo::cli
