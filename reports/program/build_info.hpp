// SPDX-License-Identifier: Apache-2.0
// The version and the commit of this program, and the head of every JSON document that it writes.
#pragma once

#include <string>
#include <string_view>

namespace tribo::cli {

// Forty hexadecimal digits, with "-dirty" where the sources were changed after it; "unknown" where
// the program was built outside of a checkout.
std::string_view program_commit();

// "tribocheck 0.2.0 (commit 9d7fa6d…)".
std::string version_line();

// `"schema": "solve/1", "version": "0.2.0"`, the members with which a JSON document begins.
// `schema` names the file of reference/schemas that describes the document, and its number, which
// grows when a member is taken away, renamed, or given another meaning.
std::string document_head(std::string_view schema);

}  // namespace tribo::cli
