/* SPDX-License-Identifier: Apache-2.0 */
/* Preloaded into the program by test_sweep_files.py: as where `ulimit -u` or a container allows only
   MOST_THREADS threads beside the first, and no process at all if NO_PROCESSES is set. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

static int threads;

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) {
  const char* const most = getenv("MOST_THREADS");
  if (most != NULL && __atomic_add_fetch(&threads, 1, __ATOMIC_SEQ_CST) > atoi(most)) return EAGAIN;
  return ((__typeof__(&pthread_create))dlsym(RTLD_NEXT, "pthread_create"))(thread, attributes, start,
                                                                           argument);
}

pid_t fork(void) {
  if (getenv("NO_PROCESSES") == NULL) return ((__typeof__(&fork))dlsym(RTLD_NEXT, "fork"))();
  errno = EAGAIN;
  return -1;
}
