// SPDX-License-Identifier: Apache-2.0
// Cells of comma-separated values (RFC 4180, with "\n" as line end).
#pragma once

#include <string_view>

#include "output.hpp"

namespace tribo::cli {

inline void append_csv_text(Text& to, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return append(to, text);
  to.push_back('"');
  for (const char c : text) {
    if (c == '"') to.push_back('"');
    to.push_back(c);
  }
  to.push_back('"');
}

}  // namespace tribo::cli
