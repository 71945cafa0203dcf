/* SPDX-License-Identifier: Apache-2.0 */
/* A solver that knows Hertz' contact, for tribocheck's tests. */
#include <math.h>
#include <string.h>
#include <tribocheck_plugin.h>

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  const double pi = 3.14159265358979323846;
  const double *load = argument[0], *effective_modulus = argument[1], *reduced_radius = argument[2];
  double *radius = result[0], *mean_pressure = result[1], *peak_pressure = result[2];
  double* approach = result[3];
  if (strcmp(name, "hertz_point") != 0) return 0;
  for (size_t i = 0; i < count; ++i) {
    const double a = cbrt(0.75 * load[i] * reduced_radius[i] / effective_modulus[i]);
    radius[i] = a;
    mean_pressure[i] = load[i] / (pi * a * a);
    peak_pressure[i] = 1.5 * mean_pressure[i];
    approach[i] = a * a / reduced_radius[i];
    status[i] = TRIBOCHECK_DONE;
  }
  return 1;
}
