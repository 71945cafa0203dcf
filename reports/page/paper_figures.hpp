// SPDX-License-Identifier: Apache-2.0
// The paper's figures, redrawn: what stands over, under and beside each.
#pragma once

#include <vector>

#include "page/captions.hpp"
#include "page/figure.hpp"

namespace tribo::report {

std::vector<Figure> paper_figures(const Findings& findings);

}  // namespace tribo::report
