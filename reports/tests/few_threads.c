/* SPDX-License-Identifier: Apache-2.0 */
/* Preloaded into the program by test_sweep_files.py: allows only MOST_THREADS threads beside the
   first, as `ulimit -u` or a container may do. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>

static int threads;

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) {
  const char* const most = getenv("MOST_THREADS");
  if (most != NULL && __atomic_add_fetch(&threads, 1, __ATOMIC_SEQ_CST) > atoi(most)) return EAGAIN;
  return ((__typeof__(&pthread_create))dlsym(RTLD_NEXT, "pthread_create"))(thread, attributes, start,
                                                                           argument);
}
