// A solver for tribocheck in C++. It skips everything: give a function below what you have, and
// leave the others as they are. Units and ranges: tribocheck_plugin.h, which is in the folder
// include of an installed tribocheck, and in verification/conformance of its sources.
//
//   c++ -std=c++17 -O2 -shared -fPIC -I PREFIX/include solver.cpp -o libsolver.so
//   tribocheck verify --plugin libsolver.so
#include <optional>

#include "tribocheck_plugin.h"

namespace {

constexpr std::nullopt_t not_offered = std::nullopt;

std::optional<double> gaussian_moment(double /*order*/, double /*argument*/) {
  return not_offered;  // return my_moment(order, argument);
}

struct Hertz {
  double radius, mean_pressure, peak_pressure, approach;
};
std::optional<Hertz> hertz_point(double /*load*/, double /*effective_modulus*/,
                                 double /*reduced_radius*/) {
  return not_offered;
}

std::optional<double> hamrock_dowson_central(double /*speed*/, double /*viscosity*/,
                                             double /*pressure_viscosity*/, double /*load*/,
                                             double /*effective_modulus*/,
                                             double /*reduced_radius*/, double /*ellipticity*/) {
  return not_offered;
}

std::optional<double> starvation_ratio(int /*closure*/, double /*flooded_over_inlet*/,
                                       double /*damiens_exponent*/) {
  return not_offered;
}

std::optional<double> load_sharing(int /*asperity*/, double /*flooded_film_parameter*/,
                                   double /*stiffness*/, double /*offset*/) {
  return not_offered;
}

// Sets what you have of the point's numbers and codes; false where you have none.
bool operating_point(const tribocheck_scene& /*scene*/, double /*speed*/,
                     tribocheck_point& /*point*/) {
  return false;  // point.film = my_film(scene, speed); return true;
}

// What follows hands the arrays of tribocheck to the functions above, case by case.
void answer(std::optional<double> result, double& value, int& status) {
  status = result ? TRIBOCHECK_DONE : TRIBOCHECK_NOT_OFFERED;
  if (result) value = *result;
}

}  // namespace

int tribocheck_plugin_version() { return TRIBOCHECK_PLUGIN_VERSION; }
const char* tribocheck_plugin_name() { return "my solver"; }

void tribocheck_gaussian_moment(size_t count, const double* order, const double* argument,
                                double* value, int* status) {
  for (size_t i = 0; i < count; ++i)
    answer(gaussian_moment(order[i], argument[i]), value[i], status[i]);
}

void tribocheck_hertz_point(size_t count, const double* load, const double* effective_modulus,
                            const double* reduced_radius, double* radius, double* mean_pressure,
                            double* peak_pressure, double* approach, int* status) {
  for (size_t i = 0; i < count; ++i) {
    const std::optional<Hertz> hertz =
        hertz_point(load[i], effective_modulus[i], reduced_radius[i]);
    status[i] = hertz ? TRIBOCHECK_DONE : TRIBOCHECK_NOT_OFFERED;
    if (!hertz) continue;
    radius[i] = hertz->radius;
    mean_pressure[i] = hertz->mean_pressure;
    peak_pressure[i] = hertz->peak_pressure;
    approach[i] = hertz->approach;
  }
}

void tribocheck_hamrock_dowson_central(size_t count, const double* speed, const double* viscosity,
                                       const double* pressure_viscosity, const double* load,
                                       const double* effective_modulus,
                                       const double* reduced_radius, const double* ellipticity,
                                       double* value, int* status) {
  for (size_t i = 0; i < count; ++i)
    answer(hamrock_dowson_central(speed[i], viscosity[i], pressure_viscosity[i], load[i],
                                  effective_modulus[i], reduced_radius[i], ellipticity[i]),
           value[i], status[i]);
}

void tribocheck_starvation_ratio(size_t count, const int* closure, const double* flooded_over_inlet,
                                 const double* damiens_exponent, double* value, int* status) {
  for (size_t i = 0; i < count; ++i)
    answer(starvation_ratio(closure[i], flooded_over_inlet[i], damiens_exponent[i]), value[i],
           status[i]);
}

void tribocheck_load_sharing(size_t count, const int* asperity,
                             const double* flooded_film_parameter, const double* stiffness,
                             const double* offset, double* value, int* status) {
  for (size_t i = 0; i < count; ++i)
    answer(load_sharing(asperity[i], flooded_film_parameter[i], stiffness[i], offset[i]), value[i],
           status[i]);
}

void tribocheck_operating_point(const tribocheck_scene* scene, size_t count, const double* speed,
                                tribocheck_point* point, int* status) {
  for (size_t i = 0; i < count; ++i)
    status[i] =
        operating_point(*scene, speed[i], point[i]) ? TRIBOCHECK_DONE : TRIBOCHECK_NOT_OFFERED;
}
