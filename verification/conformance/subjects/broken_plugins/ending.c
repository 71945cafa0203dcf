/* SPDX-License-Identifier: Apache-2.0
 * If it is asked for a moment, it ends the calling process with the exit code in TRIBOCHECK_ENDING,
 * or hangs if this is no number. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tribocheck_plugin.h"

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  const char* const code = getenv("TRIBOCHECK_ENDING");
  (void)count, (void)argument, (void)result, (void)status;
  if (strcmp(name, "gaussian_moment") != 0) return 0;
  if (code != NULL && code[0] >= '0' && code[0] <= '9') exit(atoi(code));
  for (;;) pause();
}
