// SPDX-License-Identifier: Apache-2.0
// Writes numbers as texts, and escapes texts for CSV, HTML and Markdown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tribo::report {

// A text that reads back to the same double; "NaN" for an undefined number.
std::string exact(double value);

// `digits` significant digits and all before the point; as −1.8 × 10⁻¹⁰ below 10⁻⁴ and from 10⁶ on.
std::string rounded(double value, int digits);

// The form of rounded(), with as many digits as it takes to read back to the same double.
std::string unrounded(double value);

// 12345678 as 12 345 678, with narrow spaces at which no line breaks; only from five digits on.
std::string grouped(std::uint64_t count);

// A cell of comma-separated values (RFC 4180, with "\n" as line end). It is quoted where the format
// demands it, and where a spreadsheet would take the text for a formula; some spreadsheets take
// even quoted texts for formulas.
std::string csv_text(std::string_view text);

// Escape the signs that have a meaning in Markdown, or in HTML and XML. Control signs are escaped
// as by printable(), but escape_html() keeps line ends and tabs.
std::string escape_markdown(std::string_view text);
std::string escape_html(std::string_view text);

}  // namespace tribo::report
