// SPDX-License-Identifier: Apache-2.0
// True errors of a contender: the differences of its answers from certified or recomputed values.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace tribo::benchmarks {

struct Errors {
  std::size_t judged = 0;
  // Answers that are no number or are off by more than failed_beyond times the condition, which is
  // the tolerance `engineering` of `verify`.
  std::size_t failures = 0;
  std::size_t no_numbers = 0;  // failures without a number
  double max_ulp = 0;          // this and the next two are over the answers that are numbers
  double p99_ulp = 0;
  double mean_ulp = 0;
};

// A contender gives this in place of an answer to a case that it does not offer. The case is not
// judged, as in `verify`.
inline constexpr double not_offered = -std::numeric_limits<double>::infinity();

class ErrorTally {
 public:
  static constexpr double failed_beyond = 1e-6;  // relative

  // Adds an answer, judged against high + low.
  void add(double got, double high, double low, double condition = 1);
  void add(double got, long double exact);
  Errors errors() const;

 private:
  std::vector<double> ulps_;
  std::size_t judged_ = 0;
  std::size_t failures_ = 0;
};

// |got − (high + low)| in units in the last place of high.
double ulps_off(double got, double high, double low);

}  // namespace tribo::benchmarks
