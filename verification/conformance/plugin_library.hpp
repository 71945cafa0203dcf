// SPDX-License-Identifier: Apache-2.0
// A shared library made for tribocheck_plugin.h, loaded into this process.
#pragma once

#include <stdexcept>
#include <string>

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

}  // namespace tribo::conformance
