// SPDX-License-Identifier: Apache-2.0
// The version and the commit of this program, and the head of every JSON document that it writes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace tribo::cli {

// Forty hexadecimal digits, with "-dirty" where the sources were changed after it; "unknown" where
// the program was built outside of a checkout.
std::string_view program_commit();

// "tribocheck 0.2.0 (commit 9d7fa6d…, instruction set AVX2)", by the name of instruction_set().
std::string version_line();

std::string today();  // in UTC, as 2026-11-26

// `"schema": "solve/1", "version": "0.2.0"`, the members with which a JSON document begins.
// `schema` names the file of reference/schemas that describes the document, and its number, which
// grows when a member is taken away, renamed, or given another meaning.
std::string document_head(std::string_view schema);

// A document of these members after its head.
nlohmann::ordered_json document(std::string_view schema, const nlohmann::ordered_json& members);

// A document of one list, which is written row by row: the text before its rows, between two of
// them, and after the last.
std::string list_start(std::string_view schema, std::string_view member);
inline constexpr std::string_view list_comma = ",\n", list_end = "\n]}\n";
// The end of such a document with members after its list.
std::string list_end_with(const nlohmann::ordered_json& members);

}  // namespace tribo::cli
