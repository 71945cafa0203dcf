// SPDX-License-Identifier: Apache-2.0
// tribocheck's own model as a plug-in: the suite has to find the same of it as without.
#include <cmath>
#include <limits>
#include <span>

#include "conformance/plugin_scene.hpp"
#include "conformance/tribocheck_plugin.h"
#include "tribo/film_thickness.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/operating_points.hpp"
#include "tribo/starvation.hpp"

namespace {

using namespace tribo;

constexpr double none = std::numeric_limits<double>::infinity();

double or_undefined(double number) { return std::isfinite(number) ? number : none; }

// One function of a case's place, for all cases.
template <class Function>
void for_each(size_t count, double* value, int* status, Function function) {
  for (size_t i = 0; i < count; ++i) {
    value[i] = or_undefined(function(i));
    status[i] = TRIBOCHECK_DONE;
  }
}

template <class Word>
int code(Word word, double rests_on) {
  return std::isfinite(rests_on) ? static_cast<int>(word) : int{TRIBOCHECK_UNDEFINED_CODE};
}

tribocheck_point plugin_point(const OperatingPoint<double>& point) {
  return {or_undefined(point.film_flooded),
          or_undefined(point.film),
          or_undefined(point.separation),
          or_undefined(point.film_parameter),
          or_undefined(point.asperity_load_share),
          or_undefined(point.fluid_load_share),
          or_undefined(point.real_area_ratio),
          or_undefined(point.summit_count),
          point.friction_undefined ? none : or_undefined(point.friction),
          code(point.regime, point.asperity_load_share + point.fluid_load_share),
          code(point.inlet, point.film)};
}

}  // namespace

int tribocheck_plugin_version() { return TRIBOCHECK_PLUGIN_VERSION; }

const char* tribocheck_plugin_name() { return "own model"; }

void tribocheck_gaussian_moment(size_t count, const double* order, const double* argument,
                                double* value, int* status) {
  for_each(count, value, status, [=](size_t i) {
    return gaussian_moment(static_cast<Order>(static_cast<int>(2 * order[i])), argument[i]);
  });
}

void tribocheck_hertz_point(size_t count, const double* load, const double* effective_modulus,
                            const double* reduced_radius, double* radius, double* mean_pressure,
                            double* peak_pressure, double* approach, int* status) {
  for (size_t i = 0; i < count; ++i) {
    const HertzPoint<double> hertz = hertz_point(load[i], effective_modulus[i], reduced_radius[i]);
    radius[i] = or_undefined(hertz.radius);
    mean_pressure[i] = or_undefined(hertz.mean_pressure);
    peak_pressure[i] = or_undefined(hertz.peak_pressure);
    approach[i] = or_undefined(hertz.approach);
    status[i] = TRIBOCHECK_DONE;
  }
}

void tribocheck_hamrock_dowson_central(size_t count, const double* speed, const double* viscosity,
                                       const double* pressure_viscosity, const double* load,
                                       const double* effective_modulus,
                                       const double* reduced_radius, const double* ellipticity,
                                       double* value, int* status) {
  for_each(count, value, status, [=](size_t i) {
    return hamrock_dowson_central(speed[i], viscosity[i], pressure_viscosity[i], load[i],
                                  effective_modulus[i], reduced_radius[i], ellipticity[i]);
  });
}

void tribocheck_starvation_ratio(size_t count, const int* closure, const double* flooded_over_inlet,
                                 const double* damiens_exponent, double* value, int* status) {
  for_each(count, value, status, [=](size_t i) {
    return starvation_ratio(static_cast<StarvationClosure>(closure[i]), flooded_over_inlet[i],
                            damiens_exponent[i]);
  });
}

void tribocheck_load_sharing(size_t count, const int* asperity,
                             const double* flooded_film_parameter, const double* stiffness,
                             const double* offset, double* value, int* status) {
  for_each(count, value, status, [=](size_t i) {
    const LoadSharing<double> sharing(static_cast<AsperityModel>(asperity[i]), stiffness[i],
                                      offset[i]);
    return sharing.solve(flooded_film_parameter[i]).film_parameter;
  });
}

void tribocheck_operating_point(const tribocheck_scene* scene, size_t count, const double* speed,
                                tribocheck_point* point, int* status) {
  const Scene own = conformance::model_scene(*scene);
  OutputSet outputs = OutputSet::all();
  if (!has_friction_inputs(own)) outputs.erase(Output::friction);
  OperatingPoints points;
  points.resize(count, outputs);
  solve(MixedContact<double>(own), std::span(speed, count), outputs, points);
  for (size_t i = 0; i < count; ++i) {
    point[i] = plugin_point(points[i]);
    status[i] = TRIBOCHECK_DONE;
  }
}
