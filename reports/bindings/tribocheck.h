/* SPDX-License-Identifier: Apache-2.0
 *
 * tribocheck as a library, libtribocheck.so, in C99: each function of the model by its name, with
 * arguments and results in columns; operating points, curves, onsets and solved films of scenes; and a
 * solver of yours put to the tests within your own program.
 *
 *   cc -std=c99 solver.c $(pkg-config --cflags --libs tribocheck) -o solver
 *
 * SI units throughout. No exception and no memory crosses this interface, and any number of threads
 * may call at once. Texts are UTF-8, and end with 0. A text that is told goes into the caller's
 * `text`, of which `size` bytes are used at most, cut off where it is longer; its whole length, without
 * the 0, goes to `length`. `text` may be null where `size` is 0, and `length` may be null.
 *
 * Formulas, symbols and ranges: model/README.md; `tribocheck functions NAME` has them of each function. */
#ifndef TRIBOCHECK_H
#define TRIBOCHECK_H

#include <stddef.h>

#include "tribocheck_plugin.h" /* statuses of points, codes of words */

#ifdef __cplusplus
extern "C" {
#endif

/* The code that a call returns, as the program's exit code; tribocheck_call() has others. */
enum {
  TRIBOCHECK_OK = 0,     /* done; of a verdict: all that is offered holds */
  TRIBOCHECK_WRONG = 1,  /* of a verdict: something fails, or nothing was answered */
  TRIBOCHECK_REFUSED = 2 /* nothing was done, and `text` is one line that says why; of a scene a line each */
};

/* "0.2.0"; lives as long as the library. */
const char* tribocheck_version(void);

/* The catalogue of functions with names, units, ranges and sources, as `tribocheck functions --format
 * json` has it: reference/schemas/functions.schema.json. */
int tribocheck_describe(char* text, size_t size, size_t* length);

/* The function of this name at `count` points. argument[k][i] is argument k of point i, in the order
 * of the catalogue, of a word its code (its place in the catalogue's list, from 0); where step[k] is 0
 * and not 1, argument[k][0] is that of all points, and a null `step` means 1 for each. result[k][i] and
 * status[i] belong to the caller, and overlap nothing else; `status` may be null. A point has the status
 * TRIBOCHECK_DONE and its results, to the error bound of the catalogue, with the bits that `tribocheck
 * stream` gives; an infinity is a result that no double holds. Or an argument is out of its range, NaN or
 * infinite: then it has TRIBOCHECK_FAILED, and NaN. Returns 0 where no function has this name, 1 where
 * all points are done, and 2 where some are refused. */
int tribocheck_call(const char* name, size_t count, const double* const* argument,
                    const size_t* step, double* const* result, int* status);

/* The fault in the arguments of one point, as "load: -3 is not allowed; allowed: a number above
 * 0, in N", with TRIBOCHECK_REFUSED; TRIBOCHECK_OK where tribocheck_call() takes them. */
int tribocheck_fault(const char* name, const double* arguments, char* text, size_t size,
                     size_t* length);

/* The number in the SI unit `unit` that a text with a unit means: 0.0202 of "20.2 mPa s" in "Pa·s". */
int tribocheck_number(const char* with_unit, const char* unit, double* number);

/* A scene is its text, TOML or JSON (that whose first sign is {), at most 1 MiB, as in files:
 * model/README.md, section 1. Each fault in one is told in a line, "scene: load: -3 is not allowed;
 * allowed: a number above 0, in N", with TRIBOCHECK_REFUSED. Told here: {"id": "a ball"
 * or null, "speeds": how many, "outputs": all that there are, each with its name, whether the scene
 * asks for it ("asked"), unit, words (in the order of their codes; none: a number) and meaning, "warnings": the limits of the model that it
 * exceeds, as in the documents of the program, "notes": lines about what has no effect}. A scene that
 * has enough for solved films alone asks for no output. */
int tribocheck_describe_scene(const char* scene, char* text, size_t size, size_t* length);

/* Operating points of a scene at `count` speeds in m/s, whatever its own are; null: at its own, in
 * their order, and `count` is their number. names[k] is "speed" or an output, whether the scene asks for
 * it or not, and result[k][i] belongs to the caller: that output of point i with the bits of `tribocheck
 * solve`, of a word its code, NaN where it is undefined. `text` gets a fault, or is empty. */
int tribocheck_solve(const char* scene, size_t count, const double* speeds, size_t columns,
                     const char* const* names, double* const* result, char* text, size_t size,
                     size_t* length);

/* The same of the Stribeck curve, `tribocheck curve`: at a list of speeds the least first, at a range
 * evenly in the logarithm of the speed. `count` is the number of the scene's speeds. */
int tribocheck_curve(const char* scene, size_t count, size_t columns, const char* const* names,
                     double* const* result, char* text, size_t size, size_t* length);

/* The onsets of starvation as `tribocheck onset --format json` has them, reference/schemas/onset.schema.json.
 * `departure`: above 0 and below 1, of film_departure; the program's default is 0.05. */
int tribocheck_onset(const char* scene, double departure, char* text, size_t size, size_t* length);

/* Called before each step of a solve, on a grid of `cells` cells; the solve stops where it returns
 * another number than 0. */
typedef int (*tribocheck_watch)(void* user, int cells, int step);

/* Solved films of a scene as `tribocheck film --format json` has them, reference/schemas/film.schema.json.
 * TRIBOCHECK_WRONG where one is not solved, or not to its tolerance: its "reason" says why. That takes
 * from a tenth of a second to minutes; give a text of some megabytes where there is a profile, as one
 * that is cut off costs another solve. `watch` may be null; where it stops the solve, TRIBOCHECK_REFUSED.
 * `request` is a JSON object, with any of these:
 *
 *   "speed": 0.5                       m/s; without it: all speeds of the scene
 *   "tolerance": 1e-4                  relative, from 1e-6 to 1e-2, as --tolerance has it
 *   "viscosity": "barus"               or "roelands"; without it: the scene's
 *   "density": "incompressible"        or "dowson_higginson"
 *   "flooded": true                    whatever supply the scene has; refused where it has none
 *   "profile": true                    pressure and film along the middle, too */
int tribocheck_film(const char* scene, const char* request, tribocheck_watch watch, void* user,
                    char* text, size_t size, size_t* length);

/* Questions to a solver: certified cases, as lines of JSON of `tribocheck verify --save-cases`, each with
 * an id of its own; some come once more at the end. `request` is a JSON object, with any of these:
 *
 *   "functions": ["hertz_point"]       of these alone; operating_point is one too; without it: all
 *   "tolerance": "engineering"         or "strict", or the path of a file, as --tolerance has it
 *   "modulus": "E*", "ellipticity": "k", "sample": 0        as these options of `tribocheck verify`
 *   "subject": "my solver"             its name in the verdict
 *   "format": "table"                  of the verdict; or "json", "markdown"
 *   "reference": "/path/reference"     the folder with exact, published and mistakes.toml; without
 *                                      it: that in the data of the installed tribocheck */
int tribocheck_cases(const char* request, char* text, size_t size, size_t* length);

/* The verdict on answers to the questions that tribocheck_cases() gives for the same request, the worst
 * case of each quantity that fails, and why its numbers are off, as `tribocheck verify --subject` finds it.
 * `answers` are lines of JSON, each with the id of its question: {"id": "f0001", "value": 1.5e-7},
 * {"id": …, "skip": "why"} or {"id": …, "error": "why"}. A diagnosis may take a second: give a text of
 * a megabyte, as one that is cut off costs another call. */
int tribocheck_judge(const char* request, const char* answers, char* text, size_t size,
                     size_t* length);

#ifdef __cplusplus
}
#endif

#endif
