// SPDX-License-Identifier: Apache-2.0
// Texts of numbers, and texts as CSV, HTML and Markdown have them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tribo::report {

// Reads back to the same double; NaN for what is undefined.
std::string exact(double value);

// `digits` significant digits; −1.8 × 10⁻¹⁰, where the plain number would be long.
std::string rounded(double value, int digits);

// The form of rounded(), with as many digits as it takes to read back to the same double.
std::string unrounded(double value);

// 12345678 as 12 345 678, with narrow blanks that do not break.
std::string grouped(std::uint64_t count);

// A cell of comma-separated values (RFC 4180, with "\n" as line end): quoted where it has to be,
// and where a spreadsheet would take it for a formula, which it may do all the same.
std::string csv_text(std::string_view text);

// Plain text where signs of Markdown, or of HTML and XML, would have a meaning. Control signs are
// escaped as by printable(); HTML and XML keep line ends and tabs.
std::string escape_markdown(std::string_view text);
std::string escape_html(std::string_view text);

}  // namespace tribo::report
