// SPDX-License-Identifier: Apache-2.0
// Switches of mutants, in generated copies of the tree only. TRIBOCHECK_MUTANT has the numbers of
// the mutants that are on, with commas between; TRIBOCHECK_MUTANTS_REACHED names a file in which
// byte n becomes 1 where mutant n is reached, and 2 where it would change a value.
#ifndef TRIBOCHECK_MUTANTS_SWITCH_HPP
#define TRIBOCHECK_MUTANTS_SWITCH_HPP
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <type_traits>

namespace tribocheck_mutants {

constexpr int most = 1 << 16;
constinit inline bool is_read = false;
constinit inline unsigned char is_on[most] = {};
constinit inline unsigned char* reached = nullptr;
constinit inline int reached_size = 0;

[[gnu::cold, gnu::noinline]] inline void read_environment() {
  for (const char* at = std::getenv("TRIBOCHECK_MUTANT"); at != nullptr && *at != 0;) {
    char* end = nullptr;
    const long number = std::strtol(at, &end, 10);
    if (end == at) break;
    if (number >= 0 && number < most) is_on[number] = 1;
    at = *end == ',' ? end + 1 : end;
  }
  if (const char* const name = std::getenv("TRIBOCHECK_MUTANTS_REACHED")) {
    const int file = ::open(name, O_RDWR | O_CLOEXEC);
    struct stat about {};
    if (file >= 0 && ::fstat(file, &about) == 0) {
      const auto size = static_cast<std::size_t>(about.st_size);
      void* const at = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
      if (at != MAP_FAILED) {
        reached_size = static_cast<int>(size);
        reached = static_cast<unsigned char*>(at);
      }
    }
    if (file >= 0) ::close(file);
  }
  is_read = true;
}

inline void mark(int n, unsigned char how) {
  if (n < reached_size && reached[n] < how) reached[n] = how;
}

inline bool late_on(int n) {
  if (!is_read) [[unlikely]]
    read_environment();
  if (reached != nullptr) [[unlikely]]
    mark(n, 2);
  return is_on[n] != 0;
}

// No mutant is on at compile time.
constexpr bool on(int n) { return std::is_constant_evaluated() ? false : late_on(n); }

template <class T>
constexpr bool same(T a, T b) {
  if constexpr (std::is_floating_point_v<T>) {
    if (a != a || b != b) return a != a && b != b;
    return a == b && std::signbit(a) == std::signbit(b);
  } else {
    return a == b;
  }
}

template <class A, class B>
inline A late_choose(int n, const A& original, const B& other) {
  if constexpr (std::is_arithmetic_v<A>) {
    if (!is_read) [[unlikely]]
      read_environment();
    const A changed = static_cast<A>(other);
    if (reached != nullptr) [[unlikely]]
      mark(n, same<A>(original, changed) ? 1 : 2);
    return is_on[n] != 0 ? changed : original;
  } else {
    return late_on(n) ? A(other) : original;
  }
}

template <class A, class B>
constexpr A choose(int n, const A& original, const B& other) {
  return std::is_constant_evaluated() ? original : late_choose<A>(n, original, other);
}

// The type of an expression's value. Boost.Multiprecision and Eigen return expression templates.
template <class T>
struct ValueOf {
  using type = std::remove_cvref_t<T>;
};
template <class T>
requires requires { typename std::remove_cvref_t<T>::result_type; }
struct ValueOf<T> {
  using type = typename std::remove_cvref_t<T>::result_type;
};
template <class T>
requires requires { typename std::remove_cvref_t<T>::PlainObject; }
struct ValueOf<T> {
  using type = typename std::remove_cvref_t<T>::PlainObject;
};
template <class T>
using value = typename ValueOf<T>::type;

}  // namespace tribocheck_mutants
#endif
