// SPDX-License-Identifier: Apache-2.0
// How the HTML page looks: on a phone, on a screen, in the dark and on paper.
#pragma once

#include <string_view>

namespace tribo::report {

extern const std::string_view page_style;

}  // namespace tribo::report
