/* SPDX-License-Identifier: Apache-2.0
 * The functions of tribocheck.h for Octave, in one MEX file that the scripts of this folder call. It is no
 * Octave extension (.oct): it uses only the MEX interface, which MATLAB also has, and links no library of Octave.
 *
 *   [fault, place, result…] = library ("call", name, column…)     columns as called.m makes them
 *   [text, code] = library ("describe"), ("cases", request), ("judge", request, answers)
 *   [number, code] = library ("number", text, unit)
 *
 * `fault` is empty, or tells what is wrong at the point `place`, counted from 1. Octave allocates all
 * memory, and frees it when an error ends the function. */
#include <string.h>

#include "mex.h"
#include "tribocheck.h"

enum { MOST = 16 }; /* columns of a function */

static char* text_of(int count, const mxArray* given[], int place) {
  char* const text = place < count ? mxArrayToString(given[place]) : NULL;
  if (text == NULL) mexErrMsgIdAndTxt("tribocheck:library", "argument %d is no text", place + 1);
  return text;
}

static int ask(const char* what, char* const* word, const double* numbers, char* text, size_t size,
               size_t* length) {
  if (strcmp(what, "describe") == 0) return tribocheck_describe(text, size, length);
  if (strcmp(what, "cases") == 0) return tribocheck_cases(word[0], text, size, length);
  if (strcmp(what, "judge") == 0) return tribocheck_judge(word[0], word[1], text, size, length);
  return tribocheck_fault(word[0], numbers, text, size, length);
}

/* The text that a call writes. A text longer than a megabyte needs a second call. */
static mxArray* told(const char* what, char* const* word, const double* numbers, int* code) {
  size_t room = (size_t)1 << 20, length = 0;
  char* text = mxMalloc(room);
  mxArray* made;
  *code = ask(what, word, numbers, text, room, &length);
  if (length >= room) {
    room = length + 1;
    text = mxRealloc(text, room);
    *code = ask(what, word, numbers, text, room, &length);
  }
  made = mxCreateString(text);
  mxFree(text);
  return made;
}

/* Sets fault, place and results of a function at all points. A column is one number or has the common shape. */
static void call(char* name, int results, mxArray* to[], int columns, const mxArray* column[]) {
  static const mwSize one[] = {1, 1};
  const mwSize* shape = one;
  mwSize dimensions = 2;
  size_t step[MOST] = {0}, count = 1, place = 0;
  const double* argument[MOST] = {NULL};
  double *result[MOST] = {NULL}, numbers[MOST] = {0};
  int k, code;
  if (results < 1 || results > MOST || columns > MOST)
    mexErrMsgIdAndTxt("tribocheck:library", "a function with too many columns");
  for (k = 0; k < columns; ++k) {
    const size_t size = mxGetNumberOfElements(column[k]);
    if (!mxIsDouble(column[k]) || mxIsComplex(column[k]) || mxIsSparse(column[k]))
      mexErrMsgIdAndTxt("tribocheck:library", "column %d has no plain numbers", k + 1);
    argument[k] = mxGetPr(column[k]);
    step[k] = size != 1;
    if (size == 1) continue;
    if (shape != one && size != count)
      mexErrMsgIdAndTxt("tribocheck:library", "column %d has another size", k + 1);
    count = size;
    shape = mxGetDimensions(column[k]);
    dimensions = mxGetNumberOfDimensions(column[k]);
  }
  for (k = 0; k < results; ++k) {
    to[k + 2] = mxCreateNumericArray(dimensions, shape, mxDOUBLE_CLASS, mxREAL);
    result[k] = mxGetPr(to[k + 2]);
  }
  code = tribocheck_call(name, count, argument, step, result, NULL);
  if (code == 2) {
    int* const status = mxMalloc(count * sizeof *status);
    tribocheck_call(name, count, argument, step, result, status);
    while (status[place] == TRIBOCHECK_DONE) ++place;
    mxFree(status);
    for (k = 0; k < columns; ++k) numbers[k] = argument[k][step[k] * place];
  }
  to[0] = code == 1 ? mxCreateString("") : told("fault", &name, numbers, &code);
  to[1] = mxCreateDoubleScalar((double)(place + 1));
}

void mexFunction(int results, mxArray* to[], int count, const mxArray* given[]) {
  const char* const what = text_of(count, given, 0);
  char* word[2] = {NULL, NULL};
  int code = TRIBOCHECK_OK;
  if (strcmp(what, "call") == 0) {
    call(text_of(count, given, 1), results - 2, to, count - 2, given + 2);
    return;
  }
  if (strcmp(what, "describe") != 0) word[0] = text_of(count, given, 1);
  if (strcmp(what, "judge") == 0 || strcmp(what, "number") == 0) word[1] = text_of(count, given, 2);
  if (strcmp(what, "number") == 0) {
    double number = 0;
    code = tribocheck_number(word[0], word[1], &number);
    to[0] = mxCreateDoubleScalar(number);
  } else {
    to[0] = told(what, word, NULL, &code);
  }
  if (results > 1) to[1] = mxCreateDoubleScalar(code);
}
