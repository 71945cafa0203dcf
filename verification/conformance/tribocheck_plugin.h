/* SPDX-License-Identifier: Apache-2.0
 *
 * A solver of yours as a shared library that tribocheck checks and times, in C99, C++, Fortran
 * (bind(C)) or whatever else makes functions of C:
 *
 *   cc -O2 -shared -fPIC -I PREFIX/include solver.c -o libsolver.so -lm
 *   tribocheck verify --plugin ./libsolver.so
 *   tribocheck bench --plugin ./libsolver.so
 *
 * PREFIX is where tribocheck is installed; `tribocheck init subject --language c` prints the line for
 * where it is. The library exports tribocheck_plugin_version() and any of the functions below; what it leaves
 * out is skipped. Arrays belong to the caller, hold `count` numbers each, count >= 1, do not
 * overlap, and are not to be kept. Functions are called from one thread, may be called in any order
 * with any count, and write for each case one status and, where it is TRIBOCHECK_DONE, its results.
 * A function that writes no status has failed. What a plug-in prints to stdout comes out on stderr.
 *
 * SI units throughout. A number in a result that is not finite says something: NaN that this result
 * is not offered, an infinity that there is none at this point (as friction, where the film has
 * collapsed). The only result of a function is always offered: NaN there is an error.
 *
 * Formulas, symbols and ranges: model/README.md. */
#ifndef TRIBOCHECK_PLUGIN_H
#define TRIBOCHECK_PLUGIN_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header. It grows when a plug-in built with an older header would be read wrongly. */
enum { TRIBOCHECK_PLUGIN_VERSION = 1 };

/* The status of a case. */
enum {
  TRIBOCHECK_DONE = 0,
  TRIBOCHECK_NOT_OFFERED = 1, /* as a closure that the solver does not have: the case is skipped */
  TRIBOCHECK_UNDEFINED = 2,   /* the result does not exist there */
  TRIBOCHECK_FAILED = 3       /* the input is refused, or an iteration did not converge */
};

/* Codes of words. */
enum { TRIBOCHECK_GREENWOOD_TRIPP = 0, TRIBOCHECK_GREENWOOD_WILLIAMSON = 1 };
enum {
  TRIBOCHECK_FLOODED_INLET = 0, /* 1/r = 1 + psi^(3/2)/c, collapsed for r >= 1; section 7 */
  TRIBOCHECK_STARVED_INLET = 1,
  TRIBOCHECK_PRINTED_EXPONENTS = 2,
  TRIBOCHECK_DAMIENS = 3
};
enum {
  TRIBOCHECK_SUPPLY_FLOODED = 0,   /* supply_value means nothing */
  TRIBOCHECK_INLET_FILM = 1,       /* supply_value is h_oil, m */
  TRIBOCHECK_INLET_FILM_RATIO = 2, /* h_oil/sigma_s */
  TRIBOCHECK_INLET_FLOW = 3        /* q = h_oil u, m^2/s */
};
enum { TRIBOCHECK_EYRING = 0, TRIBOCHECK_LIMITING = 1 };
enum { TRIBOCHECK_BARUS = 0, TRIBOCHECK_AMBIENT = 1, TRIBOCHECK_ROELANDS = 2 };
enum { TRIBOCHECK_BOUNDARY = 0, TRIBOCHECK_MIXED = 1, TRIBOCHECK_ELASTOHYDRODYNAMIC = 2 };
enum { TRIBOCHECK_FLOODED = 0, TRIBOCHECK_STARVED = 1, TRIBOCHECK_COLLAPSED = 2 };
/* Instead of a code in tribocheck_point: not offered, and none at this point. */
enum { TRIBOCHECK_NO_CODE = -1, TRIBOCHECK_UNDEFINED_CODE = -2 };

/* Has to be there: returns TRIBOCHECK_PLUGIN_VERSION. */
int tribocheck_plugin_version(void);

/* What results are to be called: UTF-8, ends with 0, lives as long as the library. Without it: the
 * file's name. */
const char* tribocheck_plugin_name(void);

/* F_n(d), the integral of (s-d)^n phi(s) over s from d to infinity, phi the standard normal
 * density. */
void tribocheck_gaussian_moment(size_t count, const double* order, /* n: 0, 0.5, 1, 1.5, 2 or 2.5 */
                                const double* argument,            /* d: any finite number */
                                double* value, int* status);

/* Hertz' circular contact of smooth bodies. */
void tribocheck_hertz_point(size_t count, const double* load, /* F > 0, N */
                            const double* effective_modulus,  /* E* > 0, Pa: 1/E* =
                                                                 (1-nu1^2)/E1 + (1-nu2^2)/E2 */
                            const double* reduced_radius, /* R > 0, m; ball on flat: the ball's */
                            double* radius,               /* a, m */
                            double* mean_pressure,        /* F/(pi a^2), Pa */
                            double* peak_pressure,        /* Pa */
                            double* approach,             /* of the bodies, a^2/R, m */
                            int* status);

/* Central film of the smooth, fully flooded contact after Hamrock and Dowson, m. */
void tribocheck_hamrock_dowson_central(
    size_t count, const double* speed, /* u > 0, m/s: the mean of the surfaces' */
    const double* viscosity,           /* eta_0 > 0, Pa s */
    const double* pressure_viscosity,  /* alpha > 0, 1/Pa */
    const double* load,                /* F > 0, N */
    const double* effective_modulus,   /* E* > 0, Pa */
    const double* reduced_radius,      /* R > 0, m */
    const double* ellipticity,         /* k > 0; circle: 1 */
    double* value, int* status);

/* h over h_ff, film behind the inlet over fully flooded film, in [0, 1]; 0: collapsed. */
void tribocheck_starvation_ratio(
    size_t count, const int* closure, /* TRIBOCHECK_FLOODED_INLET ... */
    const double* flooded_over_inlet, /* r = h_ff/h_oil > 0 */
    const double* damiens_exponent,   /* gamma > 0; the others ignore it */
    double* value, int* status);

/* The film parameter lambda that carries the load together with the asperities; section 6. */
void tribocheck_load_sharing(size_t count, const int* asperity, /* TRIBOCHECK_GREENWOOD_TRIPP ... */
                             const double* flooded_film_parameter, /* lambda_0 = h_0/sigma_s > 0 */
                             const double* stiffness,              /* K >= 0; section 4 */
                             const double* offset,                 /* delta = m D_d/sigma_s >= 0 */
                             double* value, int* status);

/* One contact, its lubricant and its supply of oil. All > 0 and finite unless said. */
typedef struct tribocheck_scene {
  double load;                 /* F, N */
  double summit_density;       /* n, 1/m^2 */
  double summit_radius;        /* beta, m */
  double summit_height_sd;     /* sigma_s, m */
  double summit_plane_offset;  /* D_d/sigma_s >= 0 */
  double effective_modulus;    /* E*, Pa */
  double reduced_radius;       /* R, m */
  double ellipticity;          /* k */
  double viscosity;            /* eta_0, Pa s, at ambient pressure */
  double pressure_viscosity;   /* alpha, 1/Pa */
  double eyring_stress;        /* tau_0, Pa; NaN: not given, friction is not asked for */
  double supply_value;         /* see supply */
  double boundary_coefficient; /* mu_b >= 0; NaN: not given, friction is not asked for */
  double slide_roll_ratio;     /* S >= 0: the sliding speed is S u */
  double damiens_exponent;     /* gamma */
  int offset_planes;           /* m: 0, 1 or 2 */
  int supply;                  /* TRIBOCHECK_SUPPLY_FLOODED ... */
  int asperity;                /* TRIBOCHECK_GREENWOOD_TRIPP ... */
  int starvation;              /* TRIBOCHECK_FLOODED_INLET ... */
  int fluid;                   /* TRIBOCHECK_EYRING ... */
  int viscosity_law;           /* TRIBOCHECK_BARUS ... */
} tribocheck_scene;

/* One operating point. The caller has set all numbers to NaN and both codes to TRIBOCHECK_NO_CODE.
 */
typedef struct tribocheck_point {
  double film_flooded;        /* h_ff, m: fully flooded, with load sharing */
  double film;                /* h*, m: behind the starved inlet */
  double separation;          /* of the mean planes, m */
  double film_parameter;      /* h* over sigma_s */
  double asperity_load_share; /* A, in [0, 1] */
  double fluid_load_share;    /* 1 - A */
  double real_area_ratio;     /* real area of contact over Hertz' */
  double summit_count;        /* summits in contact */
  double friction;            /* coefficient; infinite where the film has collapsed to nothing */
  int regime;                 /* TRIBOCHECK_BOUNDARY ... */
  int inlet;                  /* TRIBOCHECK_FLOODED ... */
} tribocheck_point;

/* One scene at `count` speeds, so that it need be prepared once. */
void tribocheck_operating_point(const tribocheck_scene* scene, size_t count,
                                const double* speed, /* u > 0, m/s: the mean of the surfaces' */
                                tribocheck_point* point, int* status);

#ifdef __cplusplus
}
#endif

#endif
