// SPDX-License-Identifier: Apache-2.0
// The paper's misprints, from reference/published/errata.tsv, with what the printed and the right
// form give, so that each can be seen to matter, or not to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reproduction/inputs.hpp"

namespace tribo::reproduction {

struct Erratum {
  std::string id, place, printed, right, settled_by, kind, switch_or_reason;
  std::string evidence;  // what is computed; empty where there is nothing to compute
  std::optional<double> as_printed, as_corrected;
  std::string decided_by;  // the number of the paper, or the bound, that settles it
};

// Throws std::runtime_error: the file must list exactly the errata that the code knows.
std::vector<Erratum> read_errata(const std::string& path, const PaperScenes& scenes);

}  // namespace tribo::reproduction
