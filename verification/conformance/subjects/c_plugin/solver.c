/* SPDX-License-Identifier: Apache-2.0
 * A solver in C99: Hertz, the film, moments by a quadrature of its own, the starved inlet.
 *
 *   cc -std=c99 -O2 -shared -fPIC -I verification/conformance \
 *     verification/conformance/subjects/c_plugin/solver.c -o libsolver.so -lm
 *   tribocheck verify --plugin libsolver.so */
#include <math.h>

#include "tribocheck_plugin.h"

static const double pi = 3.14159265358979323846;

int tribocheck_plugin_version(void) { return TRIBOCHECK_PLUGIN_VERSION; }
const char* tribocheck_plugin_name(void) { return "C example"; }

/* With s = d + e^(2t) the integrand falls off fast on both sides, and the trapezoidal rule
 * converges fast. */
static double moment(double n, double d) {
  const double step = 1.0 / 32;
  const double outside = d > 0 ? exp(-d * d / 2) : 1;
  double sum = 0;
  for (int i = -20 * 32; i <= 2 * 32; ++i) {
    const double t = i * step;
    const double u = exp(2 * t);
    const double exponent = d > 0 ? u * (d + u / 2) : (u + d) * (u + d) / 2;
    sum += exp((2 * n + 2) * t - exponent);
  }
  return 2 * step * outside * sum / sqrt(2 * pi);
}

void tribocheck_gaussian_moment(size_t count, const double* order, const double* argument,
                                double* value, int* status) {
  for (size_t i = 0; i < count; ++i) {
    status[i] = argument[i] < -10 ? TRIBOCHECK_NOT_OFFERED : TRIBOCHECK_DONE;
    if (status[i] == TRIBOCHECK_DONE) value[i] = moment(order[i], argument[i]);
  }
}

void tribocheck_hertz_point(size_t count, const double* load, const double* effective_modulus,
                            const double* reduced_radius, double* radius, double* mean_pressure,
                            double* peak_pressure, double* approach, int* status) {
  for (size_t i = 0; i < count; ++i) {
    const double a = cbrt(3 * load[i] * reduced_radius[i] / (4 * effective_modulus[i]));
    radius[i] = a;
    mean_pressure[i] = load[i] / (pi * a * a);
    peak_pressure[i] = 1.5 * mean_pressure[i];
    approach[i] = a * a / reduced_radius[i];
    status[i] = TRIBOCHECK_DONE;
  }
}

void tribocheck_hamrock_dowson_central(size_t count, const double* speed, const double* viscosity,
                                       const double* pressure_viscosity, const double* load,
                                       const double* effective_modulus,
                                       const double* reduced_radius, const double* ellipticity,
                                       double* value, int* status) {
  for (size_t i = 0; i < count; ++i) {
    const double modulus = 2 * effective_modulus[i]; /* E' of the formula */
    const double u = viscosity[i] * speed[i] / (modulus * reduced_radius[i]);
    const double g = pressure_viscosity[i] * modulus;
    const double w = load[i] / (modulus * reduced_radius[i] * reduced_radius[i]);
    value[i] = 2.69 * reduced_radius[i] * pow(u, 0.67) * pow(g, 0.53) * pow(w, -0.067) *
               (1 - 0.61 * exp(-0.73 * ellipticity[i]));
    status[i] = TRIBOCHECK_DONE;
  }
}

static double film_ratio(double psi) { return 2 / pi * atan(2.7 * psi); }

/* 1/r at an inlet length psi; falls to 0 with it for both closures. */
static double inlet_over_flooded(int closure, double psi) {
  const double c = 3 / (4 * sqrt(2));
  const double y = film_ratio(psi);
  if (closure == TRIBOCHECK_STARVED_INLET) return y + pow(psi, 1.5) / c;
  return y + pow(psi, 1.5) * pow(y, -1.25) / c;
}

static double starved(int closure, double r) {
  double low = -700, high = 700; /* ln psi */
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    if (inlet_over_flooded(closure, exp(middle)) < 1 / r)
      low = middle;
    else
      high = middle;
  }
  return film_ratio(exp(low));
}

static double starvation_ratio(int closure, double r, double gamma) {
  const double c = 3 / (4 * sqrt(2));
  if (closure == TRIBOCHECK_DAMIENS) return pow(1 + pow(r, gamma), -1 / gamma);
  if (closure != TRIBOCHECK_FLOODED_INLET) return starved(closure, r);
  return r < 1 ? film_ratio(pow(c * (1 / r - 1), 2.0 / 3)) : 0;
}

void tribocheck_starvation_ratio(size_t count, const int* closure, const double* flooded_over_inlet,
                                 const double* damiens_exponent, double* value, int* status) {
  for (size_t i = 0; i < count; ++i) {
    value[i] = starvation_ratio(closure[i], flooded_over_inlet[i], damiens_exponent[i]);
    status[i] = TRIBOCHECK_DONE;
  }
}
