// SPDX-License-Identifier: Apache-2.0
// Cells of the ledger's tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reproduction/ledger.hpp"

namespace tribo::report::ledger_cells {

inline constexpr const char* no_entry = "–";

// Rounded, or no_entry.
std::string number(const std::optional<double>& value, int digits = 4);
std::string percent(double part);
// "0.5 m/s"; without a unit or a number as it is.
std::string with_unit(const std::string& number, const std::string& unit);
// The number or the comparison that the item asks for.
std::string asked(const reproduction::Item& item);
// The computed number, or least … greatest over speeds.
std::string computed(const reproduction::Item& item, const reproduction::ItemResult& result);
// "4.19 times" the paper's number; of a comparison "at 72.5 % of speeds", where it holds.
std::string against_the_paper(const reproduction::Item& item,
                              const reproduction::ItemResult& result);
// The verdict, with why there is no number, or that the verdict is not decided.
std::string verdict(const reproduction::ItemResult& result);
// The margin of a verdict, with its numerical error: "0.282 ± 1e-13".
std::string margin(const reproduction::ItemResult& result);
std::string list(const std::vector<std::string>& names);
// All claims are wanted where none is named.
bool is_wanted(const std::vector<std::string>& claims, const std::string& claim);

}  // namespace tribo::report::ledger_cells
