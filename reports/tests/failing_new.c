/* SPDX-License-Identifier: Apache-2.0 */
/* Preloaded into the program by test_sweep_ranks.py: there is no memory for the object of C++ that is the
   FAILING_NEW-th of those of a kilobyte or more. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>

void* _Znwm(size_t size) {
  static int objects;
  const char* const failing = getenv("FAILING_NEW");
  if (failing != NULL && size >= 1024 && __atomic_add_fetch(&objects, 1, __ATOMIC_SEQ_CST) == atoi(failing))
    ((void (*)(void))dlsym(RTLD_NEXT, "_ZSt17__throw_bad_allocv"))();
  return ((void* (*)(size_t))dlsym(RTLD_NEXT, "_Znwm"))(size);
}
