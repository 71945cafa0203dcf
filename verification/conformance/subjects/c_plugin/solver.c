/* SPDX-License-Identifier: Apache-2.0
 * A solver in C99: Hertz, the film, moments by a quadrature of its own, the starved inlet.
 *
 *   cc -std=c99 -O2 -shared -fPIC -I verification/conformance \
 *     verification/conformance/subjects/c_plugin/solver.c -o libsolver.so -lm
 *   tribocheck verify --plugin libsolver.so */
#include <math.h>
#include <string.h>

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

static void hertz_point(double load, double effective_modulus, double reduced_radius,
                        double* radius, double* mean_pressure, double* peak_pressure,
                        double* approach) {
  const double a = cbrt(3 * load * reduced_radius / (4 * effective_modulus));
  *radius = a;
  *mean_pressure = load / (pi * a * a);
  *peak_pressure = 1.5 * *mean_pressure;
  *approach = a * a / reduced_radius;
}

static double central_film(double speed, double viscosity, double pressure_viscosity, double load,
                           double effective_modulus, double reduced_radius, double ellipticity) {
  const double modulus = 2 * effective_modulus; /* E' of the formula */
  const double u = viscosity * speed / (modulus * reduced_radius);
  const double g = pressure_viscosity * modulus;
  const double w = load / (modulus * reduced_radius * reduced_radius);
  return 2.69 * reduced_radius * pow(u, 0.67) * pow(g, 0.53) * pow(w, -0.067) *
         (1 - 0.61 * exp(-0.73 * ellipticity));
}

static double film_ratio(double psi) { return 2 / pi * atan(2.7 * psi); }

/* 1/r at the inlet length psi, for both closures. It falls to 0 as psi does. */
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

/* Answers one case: takes its arguments, writes its results, returns its status. */
typedef int function_of_case(const double* argument, double* result);

static int moment_case(const double* argument, double* result) {
  if (argument[1] < -10) return TRIBOCHECK_NOT_OFFERED;
  result[0] = moment(argument[0], argument[1]);
  return TRIBOCHECK_DONE;
}

static int hertz_case(const double* argument, double* result) {
  hertz_point(argument[0], argument[1], argument[2], result, result + 1, result + 2, result + 3);
  return TRIBOCHECK_DONE;
}

static int film_case(const double* argument, double* result) {
  result[0] = central_film(argument[0], argument[1], argument[2], argument[3], argument[4],
                           argument[5], argument[6]);
  return TRIBOCHECK_DONE;
}

static int starvation_case(const double* argument, double* result) {
  result[0] = starvation_ratio((int)argument[0], argument[1], argument[2]);
  return TRIBOCHECK_DONE;
}

static const struct {
  const char* name;
  int arguments, results;
  function_of_case* answer;
} functions[] = {{"gaussian_moment", 2, 1, moment_case},
                 {"hertz_point", 3, 4, hertz_case},
                 {"hamrock_dowson_central", 7, 1, film_case},
                 {"starvation_ratio", 3, 1, starvation_case}};

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  for (size_t f = 0; f < sizeof functions / sizeof functions[0]; ++f) {
    if (strcmp(name, functions[f].name) != 0) continue;
    for (size_t i = 0; i < count; ++i) {
      double given[7], found[4];
      for (int k = 0; k < functions[f].arguments; ++k) given[k] = argument[k][i];
      status[i] = functions[f].answer(given, found);
      for (int k = 0; k < functions[f].results && status[i] == TRIBOCHECK_DONE; ++k)
        result[k][i] = found[k];
    }
    return 1;
  }
  return 0;
}
