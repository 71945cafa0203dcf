/* SPDX-License-Identifier: Apache-2.0 */
/* A solver that knows Hertz' contact, for tribocheck's tests. */
#include <math.h>
#include <tribocheck_plugin.h>

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }

void tribocheck_hertz_point(size_t count, const double* load, const double* effective_modulus,
                            const double* reduced_radius, double* radius, double* mean_pressure,
                            double* peak_pressure, double* approach, int* status) {
  const double pi = 3.14159265358979323846;
  for (size_t i = 0; i < count; ++i) {
    const double a = cbrt(0.75 * load[i] * reduced_radius[i] / effective_modulus[i]);
    radius[i] = a;
    mean_pressure[i] = load[i] / (pi * a * a);
    peak_pressure[i] = 1.5 * mean_pressure[i];
    approach[i] = a * a / reduced_radius[i];
    status[i] = TRIBOCHECK_DONE;
  }
}
