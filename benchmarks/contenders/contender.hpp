// SPDX-License-Identifier: Apache-2.0
// All contenders share the choice of their tolerances and numbers of points or knots, and the
// counting of evaluations of an integrand or a moment.
#pragma once

#include <cstdint>
#include <exception>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace tribo::benchmarks {

enum class Settings : std::uint8_t {
  usual,  // settings that people write
  swept,  // from coarse to fine, for error against work
};

template <class T>
std::vector<T> chosen(Settings settings, std::initializer_list<T> usual,
                      std::initializer_list<T> swept) {
  return settings == Settings::usual ? usual : swept;
}

// Joins lists to one, in their order.
template <class T>
std::vector<T> joined(std::vector<std::vector<T>> parts) {
  std::vector<T> all;
  for (std::vector<T>& part : parts) std::move(part.begin(), part.end(), std::back_inserter(all));
  return all;
}

// A contender takes Uncounted or Counted as a template argument, so that no counting is timed.
struct Uncounted {
  static void one() {}
};

struct Counted {
  static void one() { ++total; }
  static inline double total = 0;
};

// The number of evaluations that `work` makes.
template <class Work>
double evaluations_of(Work&& work) {
  const double before = Counted::total;
  work();
  return Counted::total - before;
}

// Calls a method of Boost. Returns NaN if Boost throws, as it does for NaN and infinite numbers.
template <class Method>
double value_or_nan(const Method& method) {
  try {
    return method();
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace tribo::benchmarks
