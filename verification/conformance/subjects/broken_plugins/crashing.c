/* SPDX-License-Identifier: Apache-2.0
 * Answers 1 for Hertz' radius, and aborts if it is asked for a Gaussian moment. */
#include <stdlib.h>
#include <string.h>

#include "tribocheck_plugin.h"

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  (void)argument;
  if (strcmp(name, "gaussian_moment") == 0) abort();
  if (strcmp(name, "hertz_point") != 0) return 0;
  for (size_t i = 0; i < count; ++i) {
    result[0][i] = 1;
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
