// SPDX-License-Identifier: Apache-2.0
// The option --picture, which draws a command's answer by a script of reports/page/render. Each of
// these scripts draws one picture.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace tribo::cli {

// `subject` tells in words what is drawn.
void add_picture_option(CLI::App& app, std::string& picture, const std::string& subject);

// Lets render/`script` draw the JSON `data` into the file `picture`. Writes to stderr what was
// drawn, or why the picture was not drawn. Returns whether the picture was drawn.
bool draw_picture(const std::string& script, std::string_view data, const std::string& picture);

}  // namespace tribo::cli
