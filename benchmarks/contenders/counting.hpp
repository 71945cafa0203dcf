// SPDX-License-Identifier: Apache-2.0
// Counting the evaluations of an integrand or a moment. A contender takes one of these as a
// template argument, so that the timed one does not count.
#pragma once

namespace tribo::benchmarks {

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

}  // namespace tribo::benchmarks
