// SPDX-License-Identifier: Apache-2.0
// A shared library made for tribocheck_plugin.h, loaded into this process.
//
// A plug-in as a solver, and as a process that answers JSON lines, so that a plug-in can break only
// its own process.
#pragma once

#include <stdexcept>
#include <string>

#include "conformance/serve.hpp"
#include "conformance/tribocheck_plugin.h"

namespace tribo::conformance {

// The functions of a plug-in; null: one that it does not offer.
struct PluginFunctions {
  decltype(&tribocheck_function) function = nullptr;
  decltype(&tribocheck_operating_point) operating_point = nullptr;
};

struct Plugin {
  std::string name;  // as it calls itself, or the file's stem without "lib"
  PluginFunctions functions;
};

// One line that says what is wrong with which file.
struct PluginRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Loads the library for the rest of the process; code that the library runs while it is loaded,
// runs in this process. A path without a slash is a file in the working directory. Throws
// PluginRefused.
Plugin load_plugin(const std::string& path);

// Calls the plug-in with the cases as arrays.
Solver plugin_solver(const PluginFunctions& functions);

// Loads the plug-in and answers JSON lines from stdin on stdout with it, as serve() does; what the
// plug-in prints, from its loading on, comes out on stderr. Throws PluginRefused.
int host_plugin(const std::string& path, bool tells_places);

}  // namespace tribo::conformance
