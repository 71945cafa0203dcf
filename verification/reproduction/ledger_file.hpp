// SPDX-License-Identifier: Apache-2.0
// The ledger as comma-separated values: what `tribocheck reproduce --format csv` writes, and what
// is committed as reference/baselines/ledger.csv.
#pragma once

#include <string>
#include <vector>

#include "reproduction/ledger.hpp"

namespace tribo::reproduction {

std::string ledger_csv(const Ledger& ledger, const std::vector<NamedReading>& readings,
                       const std::vector<std::string>& claims);

struct LedgerChanges {
  std::vector<std::string> verdicts;  // one line each; a reading that is another one is among them
  std::vector<std::string> numbers;   // moved by more than 1e-6 of themselves, verdict unchanged
};
// Against the committed ledger: the readings and items that both have. Throws std::runtime_error
// with one line.
LedgerChanges changes_since(const std::string& path, const Ledger& ledger,
                            const std::vector<NamedReading>& readings,
                            const std::vector<std::string>& claims);

}  // namespace tribo::reproduction
