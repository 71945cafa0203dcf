// SPDX-License-Identifier: Apache-2.0
// The ledger of the paper's claims (verification/reproduction) as tables, for page and command
// line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "page/text_table.hpp"
#include "reproduction/ledger.hpp"

namespace tribo::report {

// One reading, part by part; `claims` names those to show, all if empty.
TextTable reading_table(const reproduction::Ledger& ledger,
                        const reproduction::NamedReading& reading,
                        const std::vector<std::string>& claims = {});
// The statement of each part of a claim, its place, and how it is computed.
TextTable statement_table(const reproduction::Ledger& ledger,
                          const std::vector<std::string>& claims = {});
// "10 of the paper's 17 claims are reproduced, 2 partly, 5 not"
std::string verdict_sentence(const reproduction::Ledger& ledger,
                             const reproduction::NamedReading& reading);
// The items of claims.tsv that stand first wherever the claims are told.
inline constexpr std::string_view headline_items[] = {"C1.smooth", "C1.medium", "C1.rough",
                                                      "C2.smooth", "C4.rough",  "C4.smooth"};
// Is the number of this item a ratio at each of many speeds?
bool is_over_speeds(const reproduction::Item& item);
inline constexpr const char* no_reading_sentence =
    "no combination of interpretations gives all three speeds.";
// Each claim in a sentence with its verdict under each reading, and how many of all readings
// reproduce it.
TextTable verdict_table(const reproduction::Ledger& ledger,
                        const std::vector<reproduction::NamedReading>& readings,
                        const std::vector<std::string>& claims = {});
// The readings, and where each departs from the corrected one.
TextTable readings_table(const reproduction::Ledger& ledger,
                         const std::vector<reproduction::NamedReading>& readings);

TextTable ranking_table(const reproduction::Ledger& ledger);
TextTable switch_table();
TextTable identification_table(const reproduction::Ledger& ledger);
std::vector<TextTable> argument_tables(const reproduction::Ledger& ledger);
// The single-input changes that would make each failing item hold.
std::vector<TextTable> requirement_tables(const reproduction::Ledger& ledger,
                                          const std::vector<std::string>& claims = {});
TextTable departure_table(const reproduction::Ledger& ledger);
TextTable uncertainty_table(const reproduction::Ledger& ledger);
TextTable errata_table(const reproduction::Ledger& ledger);
TextTable independent_table(const reproduction::Ledger& ledger);

}  // namespace tribo::report
