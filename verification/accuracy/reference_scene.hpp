// SPDX-License-Identifier: Apache-2.0
// The scene of a row of reference/exact/operating_point.csv.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

#include "accuracy/reference_table.hpp"

namespace tribo::verification {

// Calls `take` for each field of the row's scene: its place in scene_fields(), and its number or
// the place of its word. Throws std::runtime_error where a column or a word is not known.
void for_each_field(const ReferenceRow& row, const std::function<void(std::size_t, double)>& take);

// The place of a word in `words`, from 0. Throws std::runtime_error where it is none of them.
double place_of(std::string_view word, std::span<const std::string_view> words);

}  // namespace tribo::verification
