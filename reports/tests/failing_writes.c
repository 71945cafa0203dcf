/* SPDX-License-Identifier: Apache-2.0 */
/* Preloaded into the program by test_sweep_writes.py and test_sweep_ranks.py: makes a call that changes a file fail. The calls that count
   are those on files whose paths begin with FAILING_PATH (the name may have a dot in front), and syncs of the folder of these files. The
   FAILING_CALL-th of them fails; where FAILING_ON is set, all later ones fail too. The file FAILING_COUNT gets the number of calls, the
   call that failed last, and a letter for each call: w for a write, s for a sync of a file, f for a sync of the folder, r for a rename,
   u for a rename of a file with writes that were not synced, o for another call. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static int calls;
static const char* failed = "none";
static char kinds[1 << 16];

static int has_watched_start(const char* path) {
  const char* const start = getenv("FAILING_PATH");
  const char* const name = start == NULL ? NULL : strrchr(start, '/');
  if (name == NULL || strncmp(path, start, (size_t)(name + 1 - start)) != 0) return 0;
  path += name + 1 - start;
  if (*path == '.') ++path;  /* an unfinished file: its name has a dot in front */
  return strncmp(path, name + 1, strlen(name + 1)) == 0;
}

/* The path of an open file or folder; empty if it is not known. */
static const char* path_of(const char* link, char* path, size_t room) {
  const ssize_t size = readlink(link, path, room - 1);
  path[size < 0 ? 0 : size] = '\0';
  return path;
}

static int is_watched(int file) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  return has_watched_start(path_of(link, path, sizeof path));
}

/* True also where a watched file that is open is opened once more, through /proc. */
static int is_watched_path(const char* path) {
  char file[4096];
  return has_watched_start(strncmp(path, "/proc/self/fd/", 14) == 0 ? path_of(path, file, sizeof file)
                                                                    : path);
}

static int is_watched_in(int folder, const char* name) {
  char link[64], path[4096], whole[8200];
  if (name[0] == '/' || folder == AT_FDCWD) return is_watched_path(name);
  snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
  snprintf(whole, sizeof whole, "%s/%s", path_of(link, path, sizeof path), name);
  return is_watched_path(whole);
}

/* Whether the open file is the folder of FAILING_PATH. */
static int is_watched_folder(int file) {
  char link[64], path[4096];
  const char* const start = getenv("FAILING_PATH");
  const char* const name = start == NULL ? NULL : strrchr(start, '/');
  if (name == NULL) return 0;
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  path_of(link, path, sizeof path);
  return strlen(path) == (size_t)(name - start) && strncmp(path, start, (size_t)(name - start)) == 0;
}

/* Files with writes after their last sync. */
static struct stat unsynced[256];
static size_t unsynced_count;
static pthread_mutex_t guard = PTHREAD_MUTEX_INITIALIZER;

/* The letter of a call on the file with this status. A write notes the file, a sync removes it. */
static char kind_by_file(const struct stat* file, char kind) {
  pthread_mutex_lock(&guard);
  size_t i = 0;
  while (i < unsynced_count && (unsynced[i].st_ino != file->st_ino || unsynced[i].st_dev != file->st_dev)) ++i;
  const int is_noted = i < unsynced_count;
  if (kind == 'w' && !is_noted && i < sizeof unsynced / sizeof *unsynced) unsynced[unsynced_count++] = *file;
  if (kind == 's' && is_noted) unsynced[i] = unsynced[--unsynced_count];
  if (kind == 'r' && is_noted) kind = 'u';
  pthread_mutex_unlock(&guard);
  return kind;
}
static char kind_on_file(int file, const char* name) {
  struct stat status;
  const char kind = strstr(name, "write") != NULL ? 'w' : strstr(name, "sync") == NULL ? 'o' : is_watched_folder(file) ? 'f' : 's';
  return fstat(file, &status) == 0 ? kind_by_file(&status, kind) : kind;
}
static char kind_of_rename(int folder, const char* from) {
  struct stat status;
  return fstatat(folder, from, &status, 0) == 0 ? kind_by_file(&status, 'r') : 'r';
}

static int fails(int watched, const char* name, char kind) {
  if (!watched) return 0;
  const int call = __atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST);
  if ((size_t)call < sizeof kinds) kinds[call - 1] = kind;
  const char* const wanted = getenv("FAILING_CALL");
  const int failing = wanted == NULL ? 0 : atoi(wanted);
  if (failing == 0 || call < failing || (call > failing && getenv("FAILING_ON") == NULL)) return 0;
  failed = name;
  errno = getenv("FAILING_ON") == NULL ? EIO : ENOSPC;
  return 1;
}

static int fails_on_file(int file, const char* name) {
  const int watched = is_watched(file) || (strstr(name, "sync") != NULL && is_watched_folder(file));
  return watched && fails(1, name, kind_on_file(file, name));
}

__attribute__((destructor)) static void tell(void) {
  const char* const path = getenv("FAILING_COUNT");
  FILE* const file = path == NULL ? NULL : fopen(path, "w");
  if (file == NULL) return;
  fprintf(file, "%d %s %s\n", calls, failed, kinds);
  fclose(file);
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define ON_A_FILE(result, name, parameters, arguments) \
  result name parameters { return fails_on_file(file, #name) ? -1 : NEXT(name) arguments; }

ON_A_FILE(ssize_t, write, (int file, const void* from, size_t size), (file, from, size))
ON_A_FILE(ssize_t, pwrite, (int file, const void* from, size_t size, off_t at), (file, from, size, at))
ON_A_FILE(ssize_t, pwrite64, (int file, const void* from, size_t size, off64_t at), (file, from, size, at))
ON_A_FILE(ssize_t, writev, (int file, const struct iovec* from, int count), (file, from, count))
ON_A_FILE(ssize_t, pwritev, (int file, const struct iovec* from, int count, off_t at),
          (file, from, count, at))
ON_A_FILE(ssize_t, pwritev64, (int file, const struct iovec* from, int count, off64_t at),
          (file, from, count, at))
ON_A_FILE(int, fsync, (int file), (file))
ON_A_FILE(int, fdatasync, (int file), (file))
ON_A_FILE(int, ftruncate, (int file, off_t size), (file, size))
ON_A_FILE(int, ftruncate64, (int file, off64_t size), (file, size))

/* The file is closed even where its close fails, as on Linux. */
int close(int file) {
  const int failing = fails_on_file(file, "close");
  const int error = errno, result = NEXT(close)(file);
  if (!failing) return result;
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) {
  return fails(is_watched_path(to), "rename", kind_of_rename(AT_FDCWD, from)) ? -1 : NEXT(rename)(from, to);
}
int unlink(const char* path) { return fails(is_watched_path(path), "unlink", 'o') ? -1 : NEXT(unlink)(path); }
int remove(const char* path) { return fails(is_watched_path(path), "remove", 'o') ? -1 : NEXT(remove)(path); }

int unlinkat(int folder, const char* name, int flags) {
  return fails(is_watched_in(folder, name), "unlinkat", 'o') ? -1 : NEXT(unlinkat)(folder, name, flags);
}
int renameat(int from_folder, const char* from, int folder, const char* to) {
  return fails(is_watched_in(folder, to), "renameat", kind_of_rename(from_folder, from))
             ? -1
             : NEXT(renameat)(from_folder, from, folder, to);
}
int renameat2(int from_folder, const char* from, int folder, const char* to, unsigned flags) {
  return fails(is_watched_in(folder, to), "renameat2", kind_of_rename(from_folder, from))
             ? -1
             : NEXT(renameat2)(from_folder, from, folder, to, flags);
}
int openat(int folder, const char* name, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  const int writes = (flags & O_ACCMODE) != O_RDONLY && is_watched_in(folder, name);
  return fails(writes, "openat", 'o') ? -1 : NEXT(openat)(folder, name, flags, mode);
}

#define OPENS(name)                                                             \
  int name(const char* path, int flags, ...) {                                  \
    va_list more;                                                               \
    va_start(more, flags);                                                      \
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;      \
    va_end(more);                                                               \
    const int writes = (flags & O_ACCMODE) != O_RDONLY && is_watched_path(path); \
    return fails(writes, #name, 'o') ? -1 : NEXT(name)(path, flags, mode);                  \
  }
OPENS(open)
OPENS(open64)
