// SPDX-License-Identifier: Apache-2.0
// A shared library made for tribocheck_plugin.h, loaded into this process.
//
// The plug-in is used as a solver, or in a process of its own that answers JSON lines, so that it
// can break only this process.
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

// Loads the library until the process ends. Code that the library runs on loading runs in this
// process. A path without a slash is a file in the working directory. Throws PluginRefused.
Plugin load_plugin(const std::string& path);

// Calls the plug-in with the cases as arrays.
Solver plugin_solver(const PluginFunctions& functions);

// Loads the plug-in and answers JSON lines from stdin on stdout with it, as serve() does; what the
// plug-in prints, from its loading on, comes out on stderr. Throws PluginRefused.
int host_plugin(const std::string& path, bool tells_places);

}  // namespace tribo::conformance
