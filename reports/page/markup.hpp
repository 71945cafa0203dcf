// SPDX-License-Identifier: Apache-2.0
// Texts are written once, with `code`, ~subscript~ and ^superscript^, and rendered three ways.
#pragma once

#include <string>
#include <string_view>

namespace tribo::report {

std::string to_html(std::string_view markup);
std::string to_markdown(std::string_view markup);
std::string to_plain(std::string_view markup);  // σ~s~ becomes σ_s, u^−1^ becomes u^−1

// Text without markup, for attributes and names.
std::string escape_html(std::string_view text);

}  // namespace tribo::report
