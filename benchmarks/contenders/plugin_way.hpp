// SPDX-License-Identifier: Apache-2.0
// A user's solver in a shared library (verification/conformance/tribocheck_plugin.h) as a contender
// for the quantities that it offers. The timed work is the call of its function and the check of
// each case's status. A case without the status TRIBOCHECK_DONE has no number.
#pragma once

#include <vector>

#include "conformance/plugin.hpp"
#include "contenders/curve_contender.hpp"
#include "contenders/moment_contender.hpp"
#include "contenders/root_contender.hpp"

namespace tribo::benchmarks {

// These functions first ask the plug-in for one case, to see whether it offers the quantity.
std::vector<MomentContender> plugin_moments(const conformance::Plugin& plugin);
std::vector<RootContender> plugin_roots(const conformance::Plugin& plugin);
// The plug-in has to offer film, load share of the asperities and friction.
std::vector<CurveContender> plugin_curves(const conformance::Plugin& plugin);

}  // namespace tribo::benchmarks
