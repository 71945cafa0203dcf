// SPDX-License-Identifier: Apache-2.0
// The onsets of starvation of scenes as rows, one row for each criterion.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "messages.hpp"
#include "table.hpp"
#include "tribo/onset.hpp"
#include "validity_writers.hpp"

namespace tribo::cli {

struct OnsetsAsked {
  std::vector<std::string> criteria = {};  // empty: all
  double departure = default_departure;
};

bool is_asked(const OnsetsAsked& asked, OnsetCriterion criterion);

constexpr bool is_departure(double departure) { return departure > 0 && departure < 1; }
inline constexpr std::string_view departure_allowed = "a number above 0 and below 1";

inline constexpr std::size_t criterion_width = width_of_words(onset_criterion_words);

// format: "table", "csv" or "json".
void write_onsets(std::string_view format, std::span<const Scene> scenes, const OnsetsAsked& asked,
                  const Warnings& warnings, OutputStream& output);

}  // namespace tribo::cli
