/* A solver for tribocheck in C. It skips everything: put your own in the place of skip_all(), or
 * take out the functions that you do not have. Arguments, units, ranges: tribocheck_plugin.h, which
 * is in the folder include of an installed tribocheck, and in verification/conformance of its
 * sources.
 *
 *   cc -O2 -shared -fPIC -I PREFIX/include solver.c -o libsolver.so -lm
 *   tribocheck verify --plugin libsolver.so
 *
 * A function that answers:
 *
 *   for (size_t i = 0; i < count; ++i) {
 *     value[i] = my_moment(order[i], argument[i]);
 *     status[i] = TRIBOCHECK_DONE;
 *   }
 */
#include "tribocheck_plugin.h"

static void skip_all(size_t count, int* status) {
  for (size_t i = 0; i < count; ++i) status[i] = TRIBOCHECK_NOT_OFFERED;
}

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }
const char* tribocheck_plugin_name(void) { return "my solver"; }

void tribocheck_gaussian_moment(size_t count, const double* order, const double* argument,
                                double* value, int* status) {
  (void)order, (void)argument, (void)value;
  skip_all(count, status);
}

void tribocheck_hertz_point(size_t count, const double* load, const double* effective_modulus,
                            const double* reduced_radius, double* radius, double* mean_pressure,
                            double* peak_pressure, double* approach, int* status) {
  (void)load, (void)effective_modulus, (void)reduced_radius;
  (void)radius, (void)mean_pressure, (void)peak_pressure, (void)approach;
  skip_all(count, status);
}

void tribocheck_hamrock_dowson_central(size_t count, const double* speed, const double* viscosity,
                                       const double* pressure_viscosity, const double* load,
                                       const double* effective_modulus,
                                       const double* reduced_radius, const double* ellipticity,
                                       double* value, int* status) {
  (void)speed, (void)viscosity, (void)pressure_viscosity, (void)load;
  (void)effective_modulus, (void)reduced_radius, (void)ellipticity, (void)value;
  skip_all(count, status);
}

void tribocheck_starvation_ratio(size_t count, const int* closure, const double* flooded_over_inlet,
                                 const double* damiens_exponent, double* value, int* status) {
  (void)closure, (void)flooded_over_inlet, (void)damiens_exponent, (void)value;
  skip_all(count, status);
}

void tribocheck_load_sharing(size_t count, const int* asperity,
                             const double* flooded_film_parameter, const double* stiffness,
                             const double* offset, double* value, int* status) {
  (void)asperity, (void)flooded_film_parameter, (void)stiffness, (void)offset, (void)value;
  skip_all(count, status);
}

void tribocheck_operating_point(const tribocheck_scene* scene, size_t count, const double* speed,
                                tribocheck_point* point, int* status) {
  (void)scene, (void)speed, (void)point;
  skip_all(count, status);
}
