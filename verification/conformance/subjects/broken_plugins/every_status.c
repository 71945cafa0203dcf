/* SPDX-License-Identifier: Apache-2.0
 * The argument of a moment is the status that it gets; from 100 on none is written, and -1 is NaN.
 * A point has a film, no friction there, and the codes of regime and inlet that the load says. */
#include <math.h>

#include "tribocheck_plugin.h"

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }

void tribocheck_gaussian_moment(size_t count, const double* order, const double* argument,
                                double* value, int* status) {
  for (size_t i = 0; i < count; ++i) {
    value[i] = argument[i] < 0 ? NAN : (double)count + order[i];
    if (argument[i] < 100) status[i] = argument[i] < 0 ? TRIBOCHECK_DONE : (int)argument[i];
  }
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
