/* SPDX-License-Identifier: Apache-2.0
 * A moment's argument is its status. From 100 on no status is written; below 0 the result is NaN.
 * A point has a film and undefined friction. Its load less 2 is the code of regime and inlet. */
#include <math.h>
#include <string.h>

#include "tribocheck_plugin.h"

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  if (strcmp(name, "gaussian_moment") != 0) return 0;
  for (size_t i = 0; i < count; ++i) {
    const double d = argument[1][i];
    result[0][i] = d < 0 ? NAN : (double)count + argument[0][i];
    if (d < 100) status[i] = d < 0 ? TRIBOCHECK_DONE : (int)d;
  }
  return 1;
}

void tribocheck_operating_point(const tribocheck_scene* scene, size_t count, const double* speed,
                                tribocheck_point* point, int* status) {
  for (size_t i = 0; i < count; ++i) {
    point[i].film = speed[i] * (double)count;
    point[i].friction = INFINITY;
    point[i].regime = (int)scene->load - 2;
    point[i].inlet = (int)scene->load - 2;
    status[i] = TRIBOCHECK_DONE;
  }
}
