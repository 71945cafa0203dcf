/* SPDX-License-Identifier: Apache-2.0
 *
 * The interface of a solver as a shared library, which tribocheck checks and times. The solver is
 * written in C99, C++, Fortran (bind(C)) or any other language that can export C functions:
 *
 *   cc -O2 -shared -fPIC -I PREFIX/include solver.c -o libsolver.so -lm
 *   tribocheck verify --plugin ./libsolver.so
 *   tribocheck bench --plugin ./libsolver.so
 *
 * PREFIX is where tribocheck is installed. `tribocheck init subject --language c` writes a file to
 * start from, and prints the command with the right folder. The library exports
 * tribocheck_plugin_version() and any of the functions below; the others are skipped. Arrays belong
 * to the caller and have `count` >= 1 numbers each. They do not overlap, and the library must not
 * keep them. It is called from one thread, in any order and with any count. For each case it writes
 * one status and, if this is TRIBOCHECK_DONE, the results. A case without a status has failed. Text
 * that the library prints to stdout goes to stderr.
 *
 * All numbers are in SI units. A result that is left as the caller has set it is not offered; a
 * function with one result always offers it. An infinity means that the result does not exist at
 * this point. A NaN that the library writes is an error; a case that it does not offer, for example
 * out of its range, has the status TRIBOCHECK_NOT_OFFERED. NaN is no error only if the film has
 * collapsed and no floor keeps the faces apart. Then nothing balances the load, both load shares
 * and friction are NaN, and the regime is TRIBOCHECK_NO_FILM. These values are not judged.
 *
 * Formulas, symbols, ranges and the sections named below: model/README.md. */
#ifndef TRIBOCHECK_PLUGIN_H
#define TRIBOCHECK_PLUGIN_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header. It grows if plug-ins built with an older one would be misread. */
enum { TRIBOCHECK_PLUGIN_VERSION = 3 };

/* The status of a case. */
enum {
  TRIBOCHECK_DONE = 0,
  TRIBOCHECK_NOT_OFFERED = 1, /* such as a closure that the solver lacks: the case is skipped */
  TRIBOCHECK_UNDEFINED = 2,   /* the result does not exist there */
  TRIBOCHECK_FAILED = 3       /* the input is refused, or an iteration did not converge */
};

/* Codes of words: in a scene, a point, and as arguments of functions. */
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
enum {
  TRIBOCHECK_BOUNDARY = 0,
  TRIBOCHECK_MIXED = 1,
  TRIBOCHECK_ELASTOHYDRODYNAMIC = 2,
  TRIBOCHECK_NO_FILM = 3 /* no film, and no floor that keeps the faces apart */
};
enum { TRIBOCHECK_FLOODED = 0, TRIBOCHECK_STARVED = 1, TRIBOCHECK_COLLAPSED = 2 };
/* In place of a code in tribocheck_point: it is not offered, or there is none at this point. */
enum { TRIBOCHECK_NO_CODE = -1, TRIBOCHECK_UNDEFINED_CODE = -2 };

/* Required; returns TRIBOCHECK_PLUGIN_VERSION. */
int tribocheck_plugin_version(void);

/* The name of the solver in results: UTF-8, ends with 0, lives as long as the library. Without this
 * function the name of the file is used. */
const char* tribocheck_plugin_name(void);

/* Answers any function of `tribocheck functions` by its name; `tribocheck functions NAME` lists its
 * arguments and results. argument[k][i] is argument k of case i, counted from 0 in that order; a
 * word is given by its code. result[k][i] is for result k of case i. The caller sets all results to
 * a special NaN before, and so knows those that are left out. Returns 0 if the function of this
 * name is not offered, and else another number.
 *
 *   if (strcmp(name, "gaussian_moment") != 0) return 0;
 *   for (size_t i = 0; i < count; ++i) {
 *     result[0][i] = my_moment(argument[0][i], argument[1][i]);
 *     status[i] = TRIBOCHECK_DONE;
 *   }
 *   return 1; */
int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status);

/* One contact, its lubricant and its supply of oil. Numbers are > 0 and finite unless noted. The
 * contact is a circle, and its film law hamrock_dowson_central: other contacts are not asked. */
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

/* One operating point. The caller sets all numbers to the special NaN and both codes to
 * TRIBOCHECK_NO_CODE before. */
typedef struct tribocheck_point {
  double film_flooded;        /* h_ff, m: fully flooded, with load sharing */
  double film;                /* h*, m: behind the starved inlet */
  double separation;          /* of the mean planes, m */
  double film_parameter;      /* h* over sigma_s */
  double asperity_load_share; /* A, in [0, 1] */
  double fluid_load_share;    /* 1 - A */
  double real_area_ratio;     /* real area of contact over Hertz' */
  double summit_count;        /* summits in contact */
  double friction;            /* coefficient */
  int regime;                 /* TRIBOCHECK_BOUNDARY ... */
  int inlet;                  /* TRIBOCHECK_FLOODED ... */
} tribocheck_point;

/* Solves one scene at `count` speeds, so that the scene need be prepared only once. */
void tribocheck_operating_point(const tribocheck_scene* scene, size_t count,
                                const double* speed, /* u > 0, m/s: the mean of the surfaces' */
                                tribocheck_point* point, int* status);

#ifdef __cplusplus
}
#endif

#endif
