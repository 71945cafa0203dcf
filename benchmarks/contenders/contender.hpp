// SPDX-License-Identifier: Apache-2.0
// Common to all contenders: at which tolerances, numbers of points and of knots they run, and how
// evaluations of an integrand or a moment are counted.
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

// The parts in their order, as one.
template <class T>
std::vector<T> joined(std::vector<std::vector<T>> parts) {
  std::vector<T> all;
  for (std::vector<T>& part : parts) std::move(part.begin(), part.end(), std::back_inserter(all));
  return all;
}

// A contender takes one of these two as a template argument, so that the timed one does not count.
struct Uncounted {
  static void one() {}
};

struct Counted {
  static void one() { ++total; }
  static inline double total = 0;
};

// How many evaluations `work` makes.
template <class Work>
double evaluations_of(Work&& work) {
  const double before = Counted::total;
  work();
  return Counted::total - before;
}

// Boost throws where it meets what is not finite: a NaN in place of its exceptions.
template <class Method>
double value_or_nan(const Method& method) {
  try {
    return method();
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace tribo::benchmarks
