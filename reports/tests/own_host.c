/* SPDX-License-Identifier: Apache-2.0 */
/* Preloaded into the program by test_sweep_join.py and test_sweep_files.py: the host's name is HOST_NAME if that is
   set; where NO_LOCKS is set, no file system has locks; where OTHER_OWNER is set, all files seem to belong to
   another user; where RENAME_ERROR is set, a rename with flags fails with this error. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

int gethostname(char* name, size_t size) {
  if (getenv("HOST_NAME") == NULL)
    return ((int (*)(char*, size_t))dlsym(RTLD_NEXT, "gethostname"))(name, size);
  strncpy(name, getenv("HOST_NAME"), size);
  return 0;
}

uid_t geteuid(void) {
  const uid_t user = ((uid_t(*)(void))dlsym(RTLD_NEXT, "geteuid"))();
  return getenv("OTHER_OWNER") == NULL ? user : user + 1;
}

int flock(int file, int operation) {
  if (getenv("NO_LOCKS") == NULL)
    return ((int (*)(int, int))dlsym(RTLD_NEXT, "flock"))(file, operation);
  errno = ENOLCK;
  return -1;
}

int renameat2(int from_folder, const char* from, int folder, const char* to, unsigned flags) {
  if (flags != 0 && getenv("RENAME_ERROR") != NULL) {
    errno = atoi(getenv("RENAME_ERROR"));
    return -1;
  }
  return ((int (*)(int, const char*, int, const char*, unsigned))dlsym(RTLD_NEXT, "renameat2"))(
      from_folder, from, folder, to, flags);
}
