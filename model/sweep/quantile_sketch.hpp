// SPDX-License-Identifier: Apache-2.0
// Counts of values in fixed bins of the number line, 1024 for each power of two. The counts do not
// depend on the order of the values, and the error of quantiles is known.
//
// The bins are those of DDSketch (Masson, Rim, Lee: DDSketch, VLDB 2019) with the logarithm that
// the floating-point format has: a value's sign, exponent and first ten binary places give its bin.
// Bin 0 holds zero and all values nearer to it than the least normal number, 2.2e-308. The bins
// above it have the numbers 1, 2 …, and the bins below it −1, −2 ….
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sweep/bytes.hpp"

namespace tribo::sweep {

class QuantileSketch {
 public:
  // The relative error of a quantile is at most this, if its magnitude is 2.3e-308 or more.
  static constexpr double relative_error = 0x1p-11;
  static constexpr std::int32_t greatest_bin = 2046 * 1024;  // of the greatest finite number

  void add(std::span<const double> values);  // finite
  void merge(const QuantileSketch& other);

  std::uint64_t count() const { return count_; }
  // The greatest memory() of a sketch of `values` values.
  static double most_memory(double values);
  // Bytes that the sketch has allocated.
  std::size_t memory() const {
    return pages_.capacity() * sizeof(Page) + places_.capacity() * sizeof places_.front();
  }
  // The middle of the bin of the value at `rank` in ascending order, 0 ≤ rank < count(); zero for
  // bin 0.
  double value_at_rank(std::uint64_t rank) const;

  // The bins that are not empty, ascending.
  struct Bin {
    double low, high;
    std::uint64_t count;
  };
  std::vector<Bin> bins() const;

  static std::int32_t bin_of(double value);
  // The lower edge of a bin, which is the upper one of the bin below; finite at both ends.
  static double edge(std::int32_t bin);

  // The same bytes for the same values in any order.
  void write(Bytes& to) const;
  // Throws std::runtime_error where the bytes are not those of a sketch.
  static QuantileSketch read(Receiver& from);

 private:
  // Counts are kept in pages, each a sixteenth of a power of two. Empty pages are not allocated,
  // for example those between 1e-300 and 1 if no values lie there. Longer pages cost time where
  // each column of a chunk has few values.
  static constexpr std::size_t page_bins = 64;
  using Page = std::array<std::uint64_t, page_bins>;

  std::uint64_t& count_of(std::int32_t bin);
  Page& make_page(std::int32_t page);
  template <class Use>
  void each_bin(Use use) const;  // use(bin, count), ascending, of those that are not empty

  std::int32_t first_page_ = 0;        // its place is places_[0]
  std::vector<std::uint32_t> places_;  // 1 + the place of a page in pages_; 0: no page
  std::vector<Page> pages_;
  std::uint64_t count_ = 0;
};

}  // namespace tribo::sweep
