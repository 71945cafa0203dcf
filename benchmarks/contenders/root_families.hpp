// SPDX-License-Identifier: Apache-2.0
// The families of the root contenders, one a source file.
#pragma once

#include <vector>

#include "contenders/root_contender.hpp"

namespace tribo::benchmarks {

std::vector<RootContender> bracketing_roots(Settings settings);  // Brent, TOMS 748
std::vector<RootContender> derivative_roots(Settings settings);  // Newton, Halley
std::vector<RootContender> textbook_roots(Settings settings);    // fixed point, Newton on the film
std::vector<RootContender> inverse_tables(Settings settings);    // one surface only
std::vector<RootContender> own_wide_roots();
std::vector<RootContender> own_one_surface_roots();

}  // namespace tribo::benchmarks
