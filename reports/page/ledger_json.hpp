// SPDX-License-Identifier: Apache-2.0
// The whole ledger as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reproduction/ledger.hpp"

namespace tribo::report {

// `readings` are the columns; `claims` names the claims, all if empty.
nlohmann::ordered_json ledger_json(const reproduction::Ledger& ledger,
                                   const std::vector<reproduction::NamedReading>& readings,
                                   const std::vector<std::string>& claims = {});

}  // namespace tribo::report
