// SPDX-License-Identifier: Apache-2.0
// How often values fell into fixed bins of the number line, 1024 to each power of two: counts that
// add up to the same whatever the order, and quantiles whose error is known.
//
// The bins of DDSketch (Masson, Rim, Lee: DDSketch, VLDB 2019), with the floating-point format's
// own logarithm in place of the true one: a value's bin is its sign, its exponent and its first ten
// binary places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sweep/bytes.hpp"

namespace tribo::sweep {

class QuantileSketch {
 public:
  // A quantile is within this part of the value that has that rank (unless that is below 2.3e-308).
  static constexpr double relative_error = 0x1p-11;

  void add(double value);  // finite
  void merge(const QuantileSketch& other);

  std::uint64_t count() const { return count_; }
  // The middle of the bin of the value of rank `rank`, 0 ≤ rank < count(), in ascending order.
  double value_at_rank(std::uint64_t rank) const;

  // The bins that are not empty, ascending.
  struct Bin {
    double low, high;
    std::uint64_t count;
  };
  std::vector<Bin> bins() const;

  void write(Bytes& to) const;
  static QuantileSketch read(ByteReader& from);

 private:
  static std::int32_t bin_of(double value);
  static double edge(std::int32_t bin);
  std::uint64_t& room_for(std::int32_t bin);

  std::int32_t first_ = 0;             // the bin of counts_[0]
  std::vector<std::uint64_t> counts_;  // of all bins from the least to the greatest seen
  std::uint64_t count_ = 0;
};

}  // namespace tribo::sweep
