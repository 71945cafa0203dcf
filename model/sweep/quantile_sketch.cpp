// SPDX-License-Identifier: Apache-2.0
#include "sweep/quantile_sketch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tribo::sweep {
namespace {

constexpr int dropped_places = 52 - 10;
constexpr std::int32_t subnormal_bins = 1023;  // of exponent 0: they are joined to bin 0

constexpr int page_places = 6;
constexpr std::int32_t bins_of_page = 1 << page_places;
constexpr std::int32_t page_of(std::int32_t bin) { return bin >> page_places; }
std::size_t place_in_page(std::int32_t bin) {
  return static_cast<std::size_t>(bin & (bins_of_page - 1));
}

constexpr std::size_t longest_varint = 10;

// LEB128: seven bits a byte, the lowest first. Returns where it ends.
std::byte* put_varint(std::byte* to, std::uint64_t value) {
  for (; value > 127; value >>= 7) *to++ = static_cast<std::byte>((value & 127) | 128);
  *to++ = static_cast<std::byte>(value);
  return to;
}

[[noreturn]] void refuse() { throw std::runtime_error("these bytes are no sketch of quantiles"); }

std::uint64_t take_varint(Receiver& from) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint64_t byte = from.take<std::uint8_t>();
    if (shift == 63 && byte > 1) refuse();
    value |= (byte & 127) << shift;
    if (byte < 128) {
      if (byte == 0 && shift > 0) refuse();  // longer than it need be
      return value;
    }
  }
  refuse();
}

}  // namespace

std::int32_t QuantileSketch::bin_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto places = static_cast<std::int32_t>(bits << 1 >> (dropped_places + 1));
  const std::int32_t magnitude = std::max(places - subnormal_bins, 0);
  return (bits >> 63) != 0 ? -magnitude : magnitude;
}

double QuantileSketch::edge(std::int32_t bin) {
  if (bin <= 0) return -edge(1 - bin);
  if (bin > greatest_bin) return std::numeric_limits<double>::max();
  return std::bit_cast<double>(static_cast<std::uint64_t>(bin + subnormal_bins) << dropped_places);
}

QuantileSketch::Page& QuantileSketch::make_page(std::int32_t page) {
  if (places_.empty()) first_page_ = page;
  if (page < first_page_) {
    places_.insert(places_.begin(), static_cast<std::size_t>(first_page_ - page), 0);
    first_page_ = page;
  }
  const auto at = static_cast<std::size_t>(page - first_page_);
  if (at >= places_.size()) places_.resize(at + 1);
  if (places_[at] == 0) {
    pages_.emplace_back();
    places_[at] = static_cast<std::uint32_t>(pages_.size());
  }
  return pages_[places_[at] - 1];
}

std::uint64_t& QuantileSketch::count_of(std::int32_t bin) {
  const std::int32_t page = page_of(bin);
  const auto at = static_cast<std::size_t>(static_cast<std::int64_t>(page) - first_page_);
  if (at < places_.size() && places_[at] != 0) return pages_[places_[at] - 1][place_in_page(bin)];
  return make_page(page)[place_in_page(bin)];
}

template <class Use>
void QuantileSketch::each_bin(Use use) const {
  static_assert(page_bins == std::size_t{bins_of_page});
  for (std::size_t at = 0; at < places_.size(); ++at) {
    if (places_[at] == 0) continue;
    const Page& page = pages_[places_[at] - 1];
    const std::int32_t first = (first_page_ + static_cast<std::int32_t>(at)) * bins_of_page;
    for (std::size_t i = 0; i < page_bins; ++i)
      if (page[i] != 0) use(first + static_cast<std::int32_t>(i), page[i]);
  }
}

double QuantileSketch::most_memory(double values) {
  constexpr double all_pages = 2 * (page_of(greatest_bin) + 1);
  constexpr double growth = 2;  // of a vector's room over its size
  return growth * (std::min(values, all_pages) * sizeof(Page) + all_pages * sizeof(std::uint32_t));
}

void QuantileSketch::add(std::span<const double> values) {
  for (const double value : values) ++count_of(bin_of(value));
  count_ += values.size();
}

void QuantileSketch::merge(const QuantileSketch& other) {
  for (std::size_t at = 0; at < other.places_.size(); ++at) {
    if (other.places_[at] == 0) continue;
    const Page& from = other.pages_[other.places_[at] - 1];
    Page& to = make_page(other.first_page_ + static_cast<std::int32_t>(at));
    for (std::size_t i = 0; i < page_bins; ++i) to[i] += from[i];
  }
  count_ += other.count_;
}

double QuantileSketch::value_at_rank(std::uint64_t rank) const {
  if (rank >= count_) throw std::out_of_range("a sketch has no such rank");
  std::uint64_t before = 0;
  std::int32_t found = 0;
  bool is_found = false;
  each_bin([&](std::int32_t bin, std::uint64_t count) {
    before += count;
    if (is_found || rank >= before) return;
    found = bin;
    is_found = true;
  });
  if (found == 0) return 0;
  const double low = edge(std::abs(found));
  const double middle =
      std::bit_cast<double>(std::bit_cast<std::uint64_t>(low) | std::uint64_t{1} << 41);
  return found < 0 ? -middle : middle;
}

std::vector<QuantileSketch::Bin> QuantileSketch::bins() const {
  std::vector<Bin> bins;
  each_bin([&](std::int32_t bin, std::uint64_t count) {
    bins.push_back({edge(bin), edge(bin + 1), count});
  });
  return bins;
}

// Writes the number of bins, then the distance of each bin from the bin before it, and its count.
// The distance of the first bin is from the bin number just below the least possible one.
void QuantileSketch::write(Bytes& to) const {
  std::uint64_t size = 0;
  each_bin([&](std::int32_t, std::uint64_t) { ++size; });
  const std::size_t start = to.size();
  to.resize(start + longest_varint * (1 + 2 * size));
  std::byte* end = put_varint(&to[start], size);
  std::int32_t previous = -greatest_bin - 1;
  each_bin([&](std::int32_t bin, std::uint64_t count) {
    end = put_varint(end, static_cast<std::uint64_t>(bin - previous));
    end = put_varint(end, count);
    previous = bin;
  });
  to.resize(static_cast<std::size_t>(end - to.data()));
}

QuantileSketch QuantileSketch::read(Receiver& from) {
  QuantileSketch sketch;
  std::int32_t bin = -greatest_bin - 1;
  for (std::uint64_t size = take_varint(from); size > 0; --size) {
    const std::uint64_t gap = take_varint(from);
    if (gap == 0 || gap > static_cast<std::uint64_t>(greatest_bin - bin)) refuse();
    bin += static_cast<std::int32_t>(gap);
    const std::uint64_t count = take_varint(from);
    if (count == 0 || count > std::numeric_limits<std::uint64_t>::max() - sketch.count_) refuse();
    sketch.count_of(bin) = count;
    sketch.count_ += count;
  }
  return sketch;
}

}  // namespace tribo::sweep
