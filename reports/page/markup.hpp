// SPDX-License-Identifier: Apache-2.0
// Plain text where signs of Markdown, or of HTML and XML, would have a meaning. Control signs are
// escaped as by printable(); HTML and XML keep line ends and tabs.
#pragma once

#include <string>
#include <string_view>

namespace tribo::report {

std::string escape_markdown(std::string_view text);
std::string escape_html(std::string_view text);

}  // namespace tribo::report
