// SPDX-License-Identifier: Apache-2.0
// Captions: what one sees in each figure, in numbers read off the curves, and what the paper says
// of it. Nothing computed is written down here; C1 to C17 are the claims of reference/published.
#pragma once

#include <string>
#include <string_view>

#include "page/findings.hpp"

namespace tribo::report {

std::string_view closure_name(StarvationClosure closure);

// All markup.
std::string two_slopes_caption(const Findings& findings);  // Figure 4
std::string area_caption(const Findings& findings);        // 7
std::string summits_caption(const Findings& findings);     // 8
std::string shares_caption(const Findings& findings);      // 9
std::string film_caption(const Findings& findings);        // 10
std::string models_caption(const Findings& findings);      // 11
std::string stribeck_caption(const Findings& findings);    // 12

}  // namespace tribo::report
