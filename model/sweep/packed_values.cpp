// SPDX-License-Identifier: Apache-2.0
#include "sweep/packed_values.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <stdexcept>
#include <vector>

namespace tribo::sweep {
namespace {

// Exchanges byte j of x[i] with byte i of x[j].
void transpose(std::array<std::uint64_t, 8>& x) {
  const auto swap = [&x](std::size_t i, std::size_t j, int shift, std::uint64_t mask) {
    const std::uint64_t changed = ((x[i] >> shift) ^ x[j]) & mask;
    x[j] ^= changed;
    x[i] ^= changed << shift;
  };
  for (const std::size_t i : {0U, 1U, 2U, 3U}) swap(i, i + 4, 32, 0x00000000FFFFFFFF);
  for (const std::size_t i : {0U, 1U, 4U, 5U}) swap(i, i + 2, 16, 0x0000FFFF0000FFFF);
  for (const std::size_t i : {0U, 2U, 4U, 6U}) swap(i, i + 1, 8, 0x00FF00FF00FF00FF);
}

// Puts all first bytes of the values first, then all second bytes, and so on.
void shuffle(std::span<const double> values, std::span<std::byte> planes) {
  const std::size_t count = values.size();
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    std::array<std::uint64_t, 8> x;
    std::memcpy(x.data(), &values[i], sizeof x);
    transpose(x);
    for (std::size_t p = 0; p < 8; ++p) std::memcpy(&planes[p * count + i], &x[p], 8);
  }
  for (; i < count; ++i) {
    std::array<std::byte, 8> bytes;
    std::memcpy(bytes.data(), &values[i], sizeof bytes);
    for (std::size_t p = 0; p < 8; ++p) planes[p * count + i] = bytes[p];
  }
}

enum class Method : std::uint8_t { stored, huffman, matches };

// Would a Huffman code shorten a plane by less than about 0.2 bits a byte? The answer comes from
// the counts c of the byte values in a sample of n bytes, in integers, so that all machines decide
// alike. For evenly spread bytes, 256 Σc² is n², plus about 256 n by chance.
bool is_spread_evenly(std::span<const std::byte> plane) {
  constexpr std::size_t runs = 16, run = 64;
  std::array<std::uint32_t, 256> counts{};
  const auto count = [&counts](std::span<const std::byte> bytes) {
    for (const std::byte b : bytes) ++counts[std::to_integer<std::size_t>(b)];
  };
  const bool is_small = plane.size() <= runs * run;
  const std::uint64_t sampled = is_small ? plane.size() : runs * run;
  if (is_small)
    count(plane);
  else
    for (std::size_t r = 0; r < runs; ++r)
      count(plane.subspan((plane.size() - run) / (runs - 1) * r, run));
  std::uint64_t squares = 0;
  for (const std::uint64_t c : counts) squares += c * c;
  return 256 * squares < sampled * sampled * 13 / 10 + 256 * sampled;
}

// Does over 1/4 of the words, `step` bytes apart, repeat a recent one? Counts 1024 in the middle.
template <class Word>
bool has_matches(std::span<const std::byte> bytes, std::size_t step) {
  constexpr std::size_t most = 1024;
  const std::size_t words = bytes.size() / step;
  const std::size_t length = std::min(words, most);
  const std::span<const std::byte> stretch = bytes.subspan((words - length) / 2 * step);
  std::array<Word, most> last{};
  std::size_t matches = 0;
  for (std::size_t i = 0; i + sizeof(Word) <= length * step; i += step) {
    Word word;
    std::memcpy(&word, &stretch[i], sizeof word);
    Word& before = last[static_cast<std::uint64_t>(word) * 0x9E3779B97F4A7C15 >> 54];
    if (before == word) ++matches;
    before = word;
  }
  return matches * 4 > length;
}

// `may_repeat`: do whole values repeat? If not, bytes that are spread evenly hold no matches.
Method method_for(std::span<const std::byte> plane, bool may_repeat) {
  const bool is_even = is_spread_evenly(plane);
  if (is_even && !may_repeat) return Method::stored;
  if (has_matches<std::uint32_t>(plane, 1)) return Method::matches;
  return is_even ? Method::stored : Method::huffman;
}

// The buffers and the zlib stream of a thread. They are kept, because zlib takes a while to set up.
class Packer {
 public:
  Packer() {
    if (deflateInit2(&zlib_, 1, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;
  ~Packer() { deflateEnd(&zlib_); }

  std::span<std::byte> room_for_planes(std::size_t size) {
    if (planes_.size() < size) planes_.resize(size);
    return std::span(planes_).first(size);
  }

  // A zlib stream (RFC 1950) of deflate blocks (RFC 1951). Each plane begins and ends at a whole
  // byte and refers to no bytes of other planes.
  Bytes stream(std::span<const std::byte> bytes, std::size_t plane_size, bool may_repeat) {
    used_ = 0;
    put({0x78, 0x01});
    for (std::size_t first = 0; first < bytes.size(); first += plane_size)
      add_plane(bytes.subspan(first, plane_size), may_repeat);
    put({0x03, 0x00});  // an empty last block
    const uLong sum = adler32_z(adler32_z(0, nullptr, 0),
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    for (const int shift : {24, 16, 8, 0}) put({static_cast<std::uint8_t>(sum >> shift)});
    return {packed_.begin(), packed_.begin() + static_cast<std::ptrdiff_t>(used_)};
  }

 private:
  static constexpr std::size_t most_stored = 65535, stored_header = 5;

  std::span<std::byte> room(std::size_t size) {
    if (packed_.size() < used_ + size) packed_.resize(used_ + size);
    return std::span(packed_).subspan(used_, size);
  }
  void put(std::initializer_list<std::uint8_t> bytes) {
    std::memcpy(room(bytes.size()).data(), bytes.begin(), bytes.size());
    used_ += bytes.size();
  }

  void add_plane(std::span<const std::byte> plane, bool may_repeat) {
    const Method method = method_for(plane, may_repeat);
    if (method == Method::stored || !deflate_plane(plane, method)) store(plane);
  }

  void store(std::span<const std::byte> plane) {
    while (!plane.empty()) {
      const std::size_t size = std::min(plane.size(), most_stored);
      const auto low = static_cast<std::uint8_t>(size & 0xFF);
      const auto high = static_cast<std::uint8_t>(size >> 8);
      put({0, low, high, static_cast<std::uint8_t>(~low), static_cast<std::uint8_t>(~high)});
      std::memcpy(room(size).data(), plane.data(), size);
      used_ += size;
      plane = plane.subspan(size);
    }
  }

  // Returns false, and adds nothing, where the plane would be no shorter than in stored blocks.
  bool deflate_plane(std::span<const std::byte> plane, Method method) {
    const std::size_t stored = plane.size() + stored_header * (plane.size() / most_stored + 1);
    if (stored > 0xFFFFFFFF) throw std::length_error("too many values to pack");
    const std::span<std::byte> to = room(stored);
    deflateReset(&zlib_);
    deflateParams(&zlib_, 1, method == Method::huffman ? Z_HUFFMAN_ONLY : Z_DEFAULT_STRATEGY);
    zlib_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(plane.data()));
    zlib_.avail_in = static_cast<uInt>(plane.size());
    zlib_.next_out = reinterpret_cast<Bytef*>(to.data());
    zlib_.avail_out = static_cast<uInt>(to.size());
    deflate(&zlib_, Z_SYNC_FLUSH);
    if (zlib_.avail_in > 0 || zlib_.avail_out == 0) return false;
    used_ += stored - zlib_.avail_out;
    return true;
  }

  z_stream zlib_{};
  std::vector<std::byte> planes_, packed_;  // packed_ is valid up to used_
  std::size_t used_ = 0;
};

Packer& packer() {
  thread_local Packer of_this_thread;
  return of_this_thread;
}

}  // namespace

PackedValues pack(std::span<const double> values) {
  const std::span<std::byte> planes = packer().room_for_planes(values.size_bytes());
  shuffle(values, planes);
  const bool may_repeat = has_matches<std::uint64_t>(std::as_bytes(values), sizeof(double));
  return {8, packer().stream(planes, values.size(), may_repeat)};
}

PackedValues pack(std::span<const std::uint8_t> words) {
  return {1, packer().stream(std::as_bytes(words), words.size(), true)};
}

}  // namespace tribo::sweep
