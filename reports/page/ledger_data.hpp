// SPDX-License-Identifier: Apache-2.0
// Data of the ledger's figures, and the ledger itself, as .tsv and .csv.
#pragma once

#include <vector>

#include "page/data_file.hpp"
#include "reproduction/ledger.hpp"

namespace tribo::report {

DataFile ledger_surfaces_data(const reproduction::Ledger& ledger);
DataFile ledger_law_data(const reproduction::Ledger& ledger);
DataFile ledger_scores_data(const reproduction::Ledger& ledger);

}  // namespace tribo::report
