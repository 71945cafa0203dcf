/* SPDX-License-Identifier: Apache-2.0
 * A solver in C that the library judges within this program; the library called by four threads.
 *
 *   library_user moments ORDER D...   the status and the moment of each D, a line each
 *   library_user judge right|wrong    the verdict on a right or wrong radius of Hertz' circle
 *   library_user threads FILE         exit code 0 if four threads get the same as one alone
 *   library_user texts                exit code 0 if texts of any size are as the header says */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tribocheck.h"

enum { POINTS = 5000, ROUNDS = 40, THREADS = 4, ROOM = 1 << 22 };

static const char* const request = "{\"functions\": [\"hertz_point\"], \"subject\": \"circle in C\"}";

static double number_in(const char* line, const char* name) {
  const char* found = strstr(line, name);
  return strtod(found + strlen(name) + 2, NULL);
}

/* The answers to the questions, a line each. A factor of 1 makes them right. */
static char* answers_to(char* questions, double factor) {
  char* answers = malloc(ROOM);
  char* end = answers;
  char* line = strtok(questions, "\n");
  for (; line != NULL; line = strtok(NULL, "\n")) {
    const char* id = strstr(line, "\"id\":") + 5;
    const double load = number_in(line, "\"load"), modulus = number_in(line, "effective_modulus"),
                 radius = number_in(line, "reduced_radius");
    end += sprintf(end, "{\"id\":%.*s, \"radius\":%.17g}\n", (int)strcspn(id, ",}"), id,
                   cbrt(0.75 * load * radius / (factor * modulus)));
  }
  return answers;
}

static int judge(double factor) {
  char *questions = malloc(ROOM), *verdict = malloc(ROOM), *answers;
  int code = tribocheck_cases(request, questions, ROOM, NULL);
  if (code == TRIBOCHECK_OK) {
    answers = answers_to(questions, factor);
    code = tribocheck_judge(request, answers, verdict, ROOM, NULL);
    puts(verdict);
    free(answers);
  } else {
    puts(questions);
  }
  free(questions);
  free(verdict);
  return code;
}

static void fill(double* order, double* d, double* result, int* status) {
  const double* argument[2];
  int i;
  for (i = 0; i < POINTS; ++i) {
    order[i] = 0.5 * (i / 1000);
    d[i] = -10 + 20.0 * i / POINTS;
  }
  argument[0] = order;
  argument[1] = d;
  tribocheck_call("gaussian_moment", POINTS, argument, NULL, &result, status);
}

/* The text of a file, which the caller frees. */
static char* text_of_file(const char* path) {
  char* text = calloc(1, ROOM);
  FILE* file = fopen(path, "rb");
  if (file == NULL || fread(text, 1, ROOM - 1, file) == 0) exit(2);
  fclose(file);
  return text;
}

struct job {
  const double* expected;
  const char *verdict, *scene, *onsets;
  int failures;
};

static void* work(void* given) {
  struct job* const job = given;
  double *order = malloc(sizeof(double) * POINTS), *d = malloc(sizeof(double) * POINTS),
         *result = malloc(sizeof(double) * POINTS);
  int* status = malloc(sizeof(int) * POINTS);
  char* text = malloc(ROOM);
  int round;
  for (round = 0; round < ROUNDS; ++round) {
    fill(order, d, result, status);
    job->failures += memcmp(result, job->expected, sizeof(double) * POINTS) != 0;
    job->failures += tribocheck_onset(job->scene, 0.05, text, ROOM, NULL) != TRIBOCHECK_OK;
    job->failures += strcmp(text, job->onsets) != 0;
    if (round % 10 != 0) continue;
    job->failures += tribocheck_judge(request, "", text, ROOM, NULL) != TRIBOCHECK_WRONG;
    job->failures += strcmp(text, job->verdict) != 0;
  }
  free(order);
  free(d);
  free(result);
  free(status);
  free(text);
  return NULL;
}

static int threads(const char* path) {
  static double order[POINTS], d[POINTS], expected[POINTS];
  static int status[POINTS];
  char *verdict = malloc(ROOM), *onsets = malloc(ROOM), *scene = text_of_file(path);
  pthread_t thread[THREADS];
  struct job job[THREADS];
  int i, failures = 0;
  fill(order, d, expected, status);
  tribocheck_judge(request, "", verdict, ROOM, NULL);
  tribocheck_onset(scene, 0.05, onsets, ROOM, NULL);
  for (i = 0; i < THREADS; ++i) {
    job[i].expected = expected;
    job[i].verdict = verdict;
    job[i].scene = scene;
    job[i].onsets = onsets;
    job[i].failures = 0;
    pthread_create(&thread[i], NULL, work, &job[i]);
  }
  for (i = 0; i < THREADS; ++i) {
    pthread_join(thread[i], NULL);
    failures += job[i].failures;
  }
  free(verdict);
  free(onsets);
  free(scene);
  printf("%d of %d rounds differ\n", failures, THREADS * ROUNDS);
  return failures != 0;
}

static int texts(void) {
  char small[8] = "unset!!";
  size_t length = 0, again = 0;
  char* whole;
  int failures = 0;
  failures += tribocheck_describe(NULL, 0, &length) != TRIBOCHECK_OK || length < 1000;
  whole = malloc(length + 1);
  failures += tribocheck_describe(whole, length + 1, &again) != TRIBOCHECK_OK;
  failures += again != length || strlen(whole) != length;
  tribocheck_describe(small, sizeof small, NULL);
  failures += strlen(small) != 7 || strncmp(small, whole, 7) != 0;
  failures += tribocheck_cases("no JSON", small, sizeof small, &length) != TRIBOCHECK_REFUSED;
  failures += length < 8 || strlen(small) != 7;
  failures += tribocheck_call(NULL, 0, NULL, NULL, NULL, NULL) != 0;
  failures += tribocheck_fault(NULL, NULL, small, sizeof small, NULL) != TRIBOCHECK_REFUSED;
  free(whole);
  printf("%d failures\n", failures);
  return failures != 0;
}

int main(int count, char** words) {
  int i;
  if (count > 2 && strcmp(words[1], "moments") == 0) {
    for (i = 3; i < count; ++i) {
      const double order = atof(words[2]), d = atof(words[i]);
      const double* argument[2];
      double moment = 0, *result = &moment;
      int status = -1;
      argument[0] = &order;
      argument[1] = &d;
      if (!tribocheck_call("gaussian_moment", 1, argument, NULL, &result, &status)) return 2;
      printf("%d %.17g\n", status, moment);
    }
    return 0;
  }
  if (count > 2 && strcmp(words[1], "judge") == 0) return judge(strcmp(words[2], "wrong") == 0 ? 2 : 1);
  if (count > 2 && strcmp(words[1], "threads") == 0) return threads(words[2]);
  if (count > 1 && strcmp(words[1], "texts") == 0) return texts();
  return 2;
}
