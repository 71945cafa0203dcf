// SPDX-License-Identifier: Apache-2.0
// Numbers and texts as bytes, for what is written to a part: little-endian, as they lie in
// memory on every machine that this is built for.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tribo::sweep {

static_assert(std::endian::native == std::endian::little);

using Bytes = std::vector<std::byte>;

template <class T>
void put(Bytes& to, const T& value) {
  static_assert(std::is_arithmetic_v<T>);
  const auto* const first = reinterpret_cast<const std::byte*>(&value);
  to.insert(to.end(), first, first + sizeof value);
}
inline void put(Bytes& to, std::span<const std::byte> bytes) {
  put(to, static_cast<std::uint64_t>(bytes.size()));
  to.insert(to.end(), bytes.begin(), bytes.end());
}
inline void put_text(Bytes& to, std::string_view text) { put(to, std::as_bytes(std::span(text))); }

// Takes from the front what put() wrote. Throws std::runtime_error where there is not enough.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class T>
  T take() {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, some(sizeof value).data(), sizeof value);
    return value;
  }
  std::span<const std::byte> take_bytes() {
    return some(static_cast<std::size_t>(take<std::uint64_t>()));
  }
  std::string take_text() {
    const std::span<const std::byte> bytes = take_bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  bool empty() const { return left_.empty(); }

 private:
  std::span<const std::byte> some(std::size_t count) {
    if (count > left_.size()) throw std::runtime_error("a record ends too early");
    const auto first = left_.first(count);
    left_ = left_.subspan(count);
    return first;
  }

  std::span<const std::byte> left_;
};

}  // namespace tribo::sweep
