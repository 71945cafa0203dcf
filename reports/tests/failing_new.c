/* SPDX-License-Identifier: Apache-2.0 */
/* test_sweep_ranks.py preloads this into the program. The FAILING_NEW-th call of operator new for 1024 bytes or
   more throws std::bad_alloc. Calls are counted from the start of main() on: before it some libraries allocate,
   on some processors only, and the program could not yet report the failure by a line. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>

typedef int Main(int, char**, char**);

static int begun;
static Main* program;

static int counted_main(int count, char** arguments, char** environment) {
  begun = 1;
  return program(count, arguments, environment);
}

int __libc_start_main(Main* main, int count, char** arguments, void (*begin)(void), void (*end)(void),
                      void (*unload)(void), void* stack) {
  program = main;
  int (*const start)(Main*, int, char**, void (*)(void), void (*)(void), void (*)(void), void*) =
      (int (*)(Main*, int, char**, void (*)(void), void (*)(void), void (*)(void), void*))dlsym(RTLD_NEXT, "__libc_start_main");
  return start(counted_main, count, arguments, begin, end, unload, stack);
}

void* _Znwm(size_t size) {
  static int objects;
  const char* const failing = getenv("FAILING_NEW");
  if (begun && failing != NULL && size >= 1024 && __atomic_add_fetch(&objects, 1, __ATOMIC_SEQ_CST) == atoi(failing))
    ((void (*)(void))dlsym(RTLD_NEXT, "_ZSt17__throw_bad_allocv"))();
  return ((void* (*)(size_t))dlsym(RTLD_NEXT, "_Znwm"))(size);
}
