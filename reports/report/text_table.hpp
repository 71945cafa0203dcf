// SPDX-License-Identifier: Apache-2.0
// A table of texts, and its three renderings.
#pragma once

#include <string>
#include <vector>

namespace tribo::report {

struct TextTable {
  std::string caption;  // these are markup, as are the cells
  std::vector<std::string> headings;
  std::vector<bool> is_number;  // of each column: set to the right
  std::vector<std::vector<std::string>> rows;
  std::string note;
  std::string data = {};  // the same unrounded, a .tsv file below the report's folder; empty: none
};

std::string plain_table(const TextTable& table);
std::string html_table(const TextTable& table);
std::string markdown_table(const TextTable& table);

}  // namespace tribo::report
