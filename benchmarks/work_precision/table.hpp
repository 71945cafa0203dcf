// SPDX-License-Identifier: Apache-2.0
// Tables of what was measured: for gnuplot as TSV, for the baseline as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::benchmarks {

// Each row is a JSON object, and all rows have the same keys. A value is null where there is none.
using Rows = std::vector<nlohmann::ordered_json>;

// Rounds to four digits: a measured number holds no more.
double four_digits(double x);

// The rows as TSV, under the names of the columns; null is empty.
std::string tsv(const Rows& rows);

// The same for gnuplot: a block for each value of `key`, with that value as its title, and two
// blank lines between blocks; null is NaN.
std::string tsv_blocks(const Rows& rows, std::string_view key);

// Throws std::runtime_error.
void write_text(const std::string& path, std::string_view text);

}  // namespace tribo::benchmarks
