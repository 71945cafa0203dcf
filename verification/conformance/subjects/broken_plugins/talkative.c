/* SPDX-License-Identifier: Apache-2.0
 * Prints to stdout while it is loaded, at each call and at the end; its answers are 1. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "tribocheck_plugin.h"

__attribute__((constructor)) static void greet(void) { puts("{\"id\": \"greeting\"}"); }
__attribute__((destructor)) static void part(void) { puts("{\"id\": \"farewell\"}"); }

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }
const char* tribocheck_plugin_name(void) { return "talkative/plug-in"; }

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  const char line[] = "{\"id\": \"past the library\"}\n";
  if (strcmp(name, "gaussian_moment") != 0) return 0;
  printf("{\"id\": \"%g at %g and on\"}\n", argument[0][0], argument[1][0]);
  fflush(stdout);
  if (write(STDOUT_FILENO, line, sizeof line - 1) < 0) perror("write");
  for (size_t i = 0; i < count; ++i) {
    result[0][i] = 1;
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
