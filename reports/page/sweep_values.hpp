// SPDX-License-Identifier: Apache-2.0
// What tables and pictures of a sweep read from its result.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sweep/result_file.hpp"

namespace tribo::report {

// The p-quantile, of one of sweep::quantile_levels.
const sweep::Quantile& quantile(const sweep::ColumnResult::Value& value, double level);

// In how many cases a column of words had each of its words.
std::vector<std::uint64_t> word_counts(const sweep::ColumnResult::Value& value, std::size_t words);

// A unit that leaves few zeros, for people: nm where all values are films.
struct ReadableUnit {
  std::string name;
  double factor;  // of a number in the column's unit
};
ReadableUnit readable_unit(const sweep::ColumnResult& column);

// "0.712 ± 0.011"
std::string with_error(const sweep::SobolIndex& index);

// "onset.film_maximum.speed" as "onset.film_maximum" and "speed"; without a dot the first is empty.
std::pair<std::string_view, std::string_view> split_name(std::string_view column);

}  // namespace tribo::report
