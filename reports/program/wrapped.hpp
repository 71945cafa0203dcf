// SPDX-License-Identifier: Apache-2.0
// Help on 80 columns: CLI11 2.1 does not wrap.
#pragma once

#include <string>

namespace tribo::cli {

// Lines of a help text broken at words. Descriptions of options go on in their column, paragraphs
// are filled anew; what follows "Example:" stays, as people copy it.
std::string wrapped_help(const std::string& help, std::size_t width = 80);

}  // namespace tribo::cli
