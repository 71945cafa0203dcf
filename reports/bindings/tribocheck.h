/* SPDX-License-Identifier: Apache-2.0
 *
 * The C99 interface of the library libtribocheck.so. It calls each function of the model by its name, with
 * arguments and results in columns. It computes operating points, curves, onsets and solved films of
 * scenes. It tests a solver of yours within your own program.
 *
 *   cc -std=c99 solver.c $(pkg-config --cflags --libs tribocheck) -o solver
 *
 * All numbers are in SI units. No function throws or gives memory to be freed, and any number of threads
 * may call at once. Texts are UTF-8 and end with 0. A call writes its text into the caller's
 * `text` and uses at most `size` bytes there: a longer text is cut off. The whole length, without the 0,
 * goes to `length`. `text` may be null where `size` is 0, and `length` may be null.
 *
 * model/README.md has formulas, symbols and ranges; `tribocheck functions NAME` tells those of a function. */
#ifndef TRIBOCHECK_H
#define TRIBOCHECK_H

#include <stddef.h>

#include "tribocheck_plugin.h" /* statuses of points, codes of words */

#ifdef __cplusplus
extern "C" {
#endif

/* The codes that calls return, the same as the program's exit codes. tribocheck_call() has others. */
enum {
  TRIBOCHECK_OK = 0,     /* done; a verdict: all that the solver offers holds */
  TRIBOCHECK_WRONG = 1,  /* a verdict: something fails, or nothing was answered; a film is not solved */
  TRIBOCHECK_REFUSED = 2 /* nothing was done; `text` says why in a line, or in a line for each fault of a scene */
};

/* The version, as "0.2.0". The text stays as long as the library is loaded. */
const char* tribocheck_version(void);

/* The catalogue of functions with names, units, ranges and sources: the JSON of `tribocheck functions
 * --format json`. Its schema is reference/schemas/functions.schema.json. */
int tribocheck_describe(char* text, size_t size, size_t* length);

/* Computes the function of this name at `count` points. argument[k][i] is argument k of point i, in the
 * order of the catalogue. A word is given by its code, its place from 0 in the catalogue's list. step[k] is
 * 1, or 0 where argument[k][0] is for all points; a null `step` means 1 for each. The arrays result[k] and
 * `status` may overlap nothing else; `status` may be null. A point that is computed has TRIBOCHECK_DONE. Its
 * results keep the error bound of the catalogue and have the bits that `tribocheck stream` gives; a result
 * too large for a double is infinite. A point with an argument that is out of range, NaN or infinite has
 * TRIBOCHECK_FAILED, and its results are NaN. Returns 0 if no function has this name, 1 if all points are
 * computed, and 2 if some are refused. */
int tribocheck_call(const char* name, size_t count, const double* const* argument,
                    const size_t* step, double* const* result, int* status);

/* Tells the fault in the arguments of one point, as "load: -3 is not allowed; allowed: a number above 0,
 * in N", and returns TRIBOCHECK_REFUSED. Returns TRIBOCHECK_OK where tribocheck_call() takes them. */
int tribocheck_fault(const char* name, const double* arguments, char* text, size_t size,
                     size_t* length);

/* Converts a text with a number and its unit into the SI unit `unit`: "20.2 mPa s" in "Pa·s" is 0.0202. */
int tribocheck_number(const char* with_unit, const char* unit, double* number);

/* `scene` is the text of a scene file (model/README.md, section 1) of at most 1 MiB, in JSON if its first
 * character is {, else in TOML. A scene with faults gives TRIBOCHECK_REFUSED and a line for each fault:
 * "scene: load: -3 is not allowed; allowed: a number above 0, in N". This call writes a JSON object: "id", a
 * text or null; "speeds", their number; "outputs", a list of all outputs, each with its name, "asked"
 * (whether the scene asks for it), unit, words (in the order of their codes; none: it is a number) and meaning;
 * "warnings", the limits of the model that the scene exceeds, as in the program's documents; "notes", lines
 * about what has no effect. No output is "asked" if the scene has inputs for solved films only. */
int tribocheck_describe_scene(const char* scene, char* text, size_t size, size_t* length);

/* Operating points of a scene at `count` speeds in m/s. Where `speeds` is null, they are the scene's own
 * speeds in their order, and `count` is their number. names[k] is "speed" or an output, whether the scene
 * asks for it or not. result[k][i] receives it for point i: a number with the bits of `tribocheck solve`,
 * the code of a word, or NaN where it is undefined. `text` receives a fault, or is empty. */
int tribocheck_solve(const char* scene, size_t count, const double* speeds, size_t columns,
                     const char* const* names, double* const* result, char* text, size_t size,
                     size_t* length);

/* The same for the Stribeck curve of `tribocheck curve`: a list of speeds is sorted, the least first; a range
 * is spaced evenly in the logarithm of the speed. `count` is the number of the scene's speeds. */
int tribocheck_curve(const char* scene, size_t count, size_t columns, const char* const* names,
                     double* const* result, char* text, size_t size, size_t* length);

/* The onsets of starvation: the JSON of `tribocheck onset --format json`, reference/schemas/onset.schema.json.
 * `departure`, above 0 and below 1, is for film_departure; the program's default is 0.05. */
int tribocheck_onset(const char* scene, double departure, char* text, size_t size, size_t* length);

/* A function that is called before each step of a solve on a grid of `cells` cells. The solve stops if it
 * returns another number than 0. */
typedef int (*tribocheck_watch)(void* user, int cells, int step);

/* Solved films of a scene: the JSON of `tribocheck film --format json`, reference/schemas/film.schema.json.
 * Returns TRIBOCHECK_WRONG if one is not solved, or not to its tolerance: its "reason" says why. A solve takes
 * from a tenth of a second to minutes. With a profile, give a `text` of some megabytes: if the text is cut off,
 * you have to solve again. `watch` may be null; if it stops the solve, the call returns TRIBOCHECK_REFUSED.
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

/* Questions to a solver: certified cases, as the lines of JSON of `tribocheck verify --save-cases`, each with
 * its id. Some questions are asked a second time at the end. `request` is a JSON object, with any of these:
 *
 *   "functions": ["hertz_point"]       only these; "operating_point" is allowed too; without it: all
 *   "tolerance": "engineering"         or "strict", or the path of a file, as --tolerance has it
 *   "modulus": "E*", "ellipticity": "k", "sample": 0        as these options of `tribocheck verify`
 *   "subject": "my solver"             its name in the verdict
 *   "format": "table"                  of the verdict; or "json", "markdown"
 *   "reference": "/path/reference"     the folder with exact, published and mistakes.toml; without
 *                                      it: that in the data of the installed tribocheck */
int tribocheck_cases(const char* request, char* text, size_t size, size_t* length);

/* The verdict on answers to the questions that tribocheck_cases() gives for the same request, the worst
 * case of each quantity that fails, and why its numbers are wrong, as in `tribocheck verify --subject`.
 * `answers` are lines of JSON, each with the id of its question: {"id": "f0001", "value": 1.5e-7},
 * {"id": …, "skip": "why"} or {"id": …, "error": "why"}. A diagnosis may take a second. Give a `text` of a
 * megabyte: if the text is cut off, you have to call again. */
int tribocheck_judge(const char* request, const char* answers, char* text, size_t size,
                     size_t* length);

#ifdef __cplusplus
}
#endif

#endif
