// SPDX-License-Identifier: Apache-2.0
// Pictures of a command's answer: the option --picture, and the scripts of reports/page/render that
// draw one picture each.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace tribo::cli {

// `subject` tells in words what is drawn.
void add_picture_option(CLI::App& app, std::string& picture, const std::string& subject);

// Lets render/`script` draw the JSON `data` into the file `picture`. Tells on stderr what was
// drawn, and why something was not. Returns whether the picture was drawn.
bool draw_picture(const std::string& script, std::string_view data, const std::string& picture);

}  // namespace tribo::cli
