// SPDX-License-Identifier: Apache-2.0
// A plug-in as a solver, and as a process that answers JSON lines, so that a plug-in can break only
// its own process.
#pragma once

#include <string>

#include "conformance/plugin_library.hpp"
#include "conformance/serve.hpp"

namespace tribo::conformance {

// Calls the plug-in with the cases as arrays.
Solver plugin_solver(const PluginFunctions& functions);

// Loads the plug-in and answers JSON lines from stdin on stdout with it, as serve() does; what the
// plug-in prints, from its loading on, comes out on stderr. Throws PluginRefused.
int host_plugin(const std::string& path);

}  // namespace tribo::conformance
