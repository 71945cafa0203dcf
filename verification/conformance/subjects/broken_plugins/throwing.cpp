// SPDX-License-Identifier: Apache-2.0
// Answers 1 for Hertz' radius, but throws an exception where the load is 13.
#include <stdexcept>
#include <string_view>

#include "tribocheck_plugin.h"

int tribocheck_plugin_version() { return TRIBOCHECK_PLUGIN_VERSION; }

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  if (name != std::string_view("hertz_point")) return 0;
  for (size_t i = 0; i < count; ++i) {
    if (argument[0][i] == 13) throw std::runtime_error("bad luck");
    result[0][i] = 1;
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
