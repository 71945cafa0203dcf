/* SPDX-License-Identifier: Apache-2.0 */
/* Preloaded into the program by test_sweep_join.py: the host's name is HOST_NAME, and where NO_LOCKS is set, no file
   system has locks. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

int gethostname(char* name, size_t size) {
  strncpy(name, getenv("HOST_NAME"), size);
  return 0;
}

int flock(int file, int operation) {
  if (getenv("NO_LOCKS") == NULL)
    return ((int (*)(int, int))dlsym(RTLD_NEXT, "flock"))(file, operation);
  errno = ENOLCK;
  return -1;
}
