// SPDX-License-Identifier: Apache-2.0
// The summary of a column of values. The values themselves are not kept.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sweep/bytes.hpp"
#include "sweep/quantile_sketch.hpp"

namespace tribo::sweep {

// Count, mean, and sum of squared distances from the mean. The corrected two-pass algorithm and the
// update of parts of Chan, Golub and LeVeque (1983) avoid cancellation.
struct Moments {
  std::uint64_t count = 0;
  double mean = 0;
  double squares = 0;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();

  void add(std::span<const double> values);  // finite
  void merge(const Moments& other);
  template <class To, class Of>
  static void fields(To& to, Of& of) {
    to(of.count, of.mean, of.squares, of.least, of.greatest);
  }
  // The standard deviation of a sample; NaN for fewer than two values.
  double sd() const {
    if (count < 2) return std::numeric_limits<double>::quiet_NaN();
    return std::sqrt(squares / static_cast<double>(count - 1));
  }
};

// A number that is estimated, and the ends of its interval.
struct Bounded {
  double value, low, high;
};

// A value that does not exist (an onset that is not there, friction of a collapsed film), or is not
// finite, counts as undefined and enters no other number.
struct ValueSummary {
  Moments moments;
  QuantileSketch sketch;
  std::uint64_t undefined = 0;

  // The bits of the moments depend on which values are added together.
  void add(std::span<const double> values);
  void merge(const ValueSummary& other);
  template <class To, class Of>
  static void fields(To& to, Of& of) {
    to(of.moments, of.undefined, of.sketch);
  }
};

// The p-quantile, with an interval that holds the distribution's own p-quantile in 95 of 100 sweeps
// of independent draws. It is that of the binomial distribution of ranks, wider by the sketch's
// error. An end is infinite where too few values bound that side; without a value all are NaN.
Bounded quantile_of(const ValueSummary& summary, double p);

// At most `most` bins, without gaps, from the least value to the greatest. Each joins the same
// number of neighbouring bins of the sketch, so that the counts are exact. On a logarithmic axis
// the bins have nearly one width.
std::vector<QuantileSketch::Bin> histogram_of(const QuantileSketch& sketch, std::size_t most);

}  // namespace tribo::sweep
