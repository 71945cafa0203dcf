// SPDX-License-Identifier: Apache-2.0
// The families of moment_contenders(), one a source file.
#pragma once

#include <vector>

#include "contenders/moment_contender.hpp"

namespace tribo::benchmarks {

std::vector<MomentContender> gsl_quadratures(Settings settings);
std::vector<MomentContender> gsl_special_functions();
std::vector<MomentContender> boost_quadratures(Settings settings);
std::vector<MomentContender> bessel_forms();
std::vector<MomentContender> gauss_laguerre_rules(Settings settings);
std::vector<MomentContender> splines(Settings settings);
std::vector<MomentContender> published_fits();
std::vector<MomentContender> own_moments();

}  // namespace tribo::benchmarks
