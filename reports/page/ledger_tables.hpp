// SPDX-License-Identifier: Apache-2.0
// The ledger of the paper's claims (verification/reproduction) as tables and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/text_table.hpp"
#include "reproduction/ledger.hpp"

namespace tribo::report {

// One reading, part by part. `claims` names the claims to show; empty: all.
TextTable reading_table(const reproduction::Ledger& ledger,
                        const reproduction::NamedReading& reading,
                        const std::vector<std::string>& claims = {});
// The statement of each part of a claim, its place, and how it is computed.
TextTable statement_table(const reproduction::Ledger& ledger,
                          const std::vector<std::string>& claims = {});
// "10 of the paper's 17 claims are reproduced, 2 partly, 5 not"
std::string verdict_sentence(const reproduction::Ledger& ledger,
                             const reproduction::NamedReading& reading);
// The same counts for the other choices of E9, between which nothing in the paper decides, and a
// sentence on the meaning of “partly”.
std::string other_planes_sentence(const reproduction::Ledger& ledger);
inline constexpr const char* arithmetic_words =
    "(arithmetic): follows from a formula as printed, whatever the model.";
// The items of claims.tsv that stand first in each text about the claims.
inline constexpr std::string_view headline_items[] = {"C1.smooth", "C1.medium", "C1.rough",
                                                      "C2.smooth", "C4.rough",  "C4.smooth"};
// Whether the number of this item is a ratio at each of many speeds.
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
// How many claims each reading reproduces with narrower and wider tolerances.
TextTable tolerance_table(const reproduction::Ledger& ledger);
TextTable switch_table();
TextTable identification_table(const reproduction::Ledger& ledger);
std::vector<TextTable> argument_tables(const reproduction::Ledger& ledger);
// The single-input changes that would make each failing item hold.
std::vector<TextTable> requirement_tables(const reproduction::Ledger& ledger,
                                          const std::vector<std::string>& claims = {});
TextTable departure_table(const reproduction::Ledger& ledger);
TextTable uncertainty_table(const reproduction::Ledger& ledger);
std::vector<TextTable> errata_tables(const reproduction::Ledger& ledger);
TextTable independent_table(const reproduction::Ledger& ledger);

// The whole ledger as JSON. `readings` are the columns; `claims` names the claims; empty: all.
nlohmann::ordered_json ledger_json(const reproduction::Ledger& ledger,
                                   const std::vector<reproduction::NamedReading>& readings,
                                   const std::vector<std::string>& claims = {});

// Cells of the tables.
namespace ledger_cells {

inline constexpr const char* no_entry = "–";
inline constexpr const char* surface_names[] = {"rough", "medium", "smooth"};

// Rounded, or no_entry.
std::string number(const std::optional<double>& value, int digits = 4);
std::string percent(double part);
// "0.5 m/s". If there is no unit or no number: `number` as it is.
std::string with_unit(const std::string& number, const std::string& unit);
// The number or the comparison that the item asks for.
std::string asked(const reproduction::Item& item);
// The computed number, or least … greatest over speeds.
std::string computed(const reproduction::Item& item, const reproduction::ItemResult& result);
// The computed number over the paper's, as "4.19 times"; for a comparison the part of the speeds at
// which it holds, as "at 72.5 % of speeds".
std::string against_the_paper(const reproduction::Item& item,
                              const reproduction::ItemResult& result);
// The verdict, with the reason if there is no number, and with a note if it is not decided.
std::string verdict(const reproduction::ItemResult& result);
// The margin of a verdict, with its numerical error: "0.282 ± 1e-13".
std::string margin(const reproduction::ItemResult& result);
// The text, marked where arithmetic alone decides: "constant of the film (arithmetic)".
std::string with_nature(const std::string& text, bool is_arithmetic);
std::string list(const std::vector<std::string>& names);
// All claims are wanted where none is named.
bool is_wanted(const std::vector<std::string>& claims, const std::string& claim);

}  // namespace ledger_cells

}  // namespace tribo::report
