// SPDX-License-Identifier: Apache-2.0
// True errors of a contender: the differences of its answers from certified or recomputed values.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace tribo::benchmarks {

struct Errors {
  std::size_t judged = 0;
  // Answers that are not finite or have an error above failed_beyond · max(1, condition) · |high|.
  // The number failed_beyond is that of the tolerance `engineering` of `verify`.
  std::size_t failures = 0;
  std::size_t no_numbers = 0;  // failures whose answer is not finite
  double max_ulp = 0;          // this number and the next two are of the finite answers
  double p99_ulp = 0;
  double mean_ulp = 0;
};

// The value that a contender gives for a case that it does not offer. Such a case is not judged, as
// in `verify`.
inline constexpr double not_offered = -std::numeric_limits<double>::infinity();

class ErrorTally {
 public:
  static constexpr double failed_beyond = 1e-6;  // relative

  // Adds an answer and judges it. The right number is high + low, a sum of two doubles.
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
