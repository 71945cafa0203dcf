// SPDX-License-Identifier: Apache-2.0
// A picture of gnuplot's as part of a page: many of them share one document.
#pragma once

#include <string>
#include <string_view>

namespace tribo::report {

// The <svg> element alone, as one image that is named `title` and described by `description` (both
// without markup). Its identifiers, which gnuplot repeats in every picture, begin with `prefix`.
std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title,
                       std::string_view description);

}  // namespace tribo::report
