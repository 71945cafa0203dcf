// SPDX-License-Identifier: Apache-2.0
// The version and the commit of this program, and the head of every JSON document that it writes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace tribo::cli {

// Forty hexadecimal digits, with "-dirty" if the sources were changed after the commit; "unknown"
// if the program was built outside of a checkout.
std::string_view program_commit();

// "tribocheck 0.2.0 (commit 9d7fa6d…, instruction set AVX2)", by the name of instruction_set().
std::string version_line();

std::string today();  // in UTC, as 2026-11-26

// `"schema": "solve/1", "version": "0.2.0"`, the members with which a JSON document begins.
// `schema` is the name of the file in reference/schemas that describes the document, and a number,
// which grows when a member is taken away, renamed, or given another meaning.
std::string document_head(std::string_view schema);

// A document: its head, then these members.
nlohmann::ordered_json document(std::string_view schema, const nlohmann::ordered_json& members);

// A document of one list can be written row by row: these are the texts before the first row,
// between two rows, and after the last.
std::string list_start(std::string_view schema, std::string_view member);
inline constexpr std::string_view list_comma = ",\n", list_end = "\n]}\n";
// The end of such a document with members after its list.
std::string list_end_with(const nlohmann::ordered_json& members);

}  // namespace tribo::cli
