// SPDX-License-Identifier: Apache-2.0
// The elliptical contacts at which ways are timed and judged: R_y/R_x in 1…1e4.
#pragma once

#include <cstddef>
#include <vector>

#include "cases/errors.hpp"
#include "cases/measured.hpp"
#include "contenders/ellipse_contender.hpp"

namespace tribo::benchmarks {

// Random ellipses with R_y/R_x log-uniform in 1…1e4.
std::vector<EllipseCase> random_ellipses(std::size_t count);

// Over the semi-axis a_x and the peak pressure of the certified rows (reference/exact).
Errors judge(const EllipseContender& contender);

// Each contender at its job.
std::vector<Measured> jobs_of(const std::vector<EllipseContender>& contenders);

}  // namespace tribo::benchmarks
