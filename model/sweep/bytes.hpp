// SPDX-License-Identifier: Apache-2.0
// Numbers and texts as the bytes of a part: little-endian, as they lie in memory on every machine
// for which the program is built.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace tribo::sweep {

static_assert(std::endian::native == std::endian::little);

using Bytes = std::vector<std::byte>;

template <class T>
void put(Bytes& to, const T& value) {
  static_assert(std::is_arithmetic_v<T>);
  const std::size_t before = to.size();
  to.resize(before + sizeof value);  // g++ 12 warns of insert() without a reason
  std::memcpy(to.data() + before, &value, sizeof value);
}
inline void put(Bytes& to, std::span<const std::byte> bytes) {
  put(to, static_cast<std::uint64_t>(bytes.size()));
  to.insert(to.end(), bytes.begin(), bytes.end());
}
inline void put_text(Bytes& to, std::string_view text) { put(to, std::as_bytes(std::span(text))); }

// Takes from the front what put() wrote. Throws std::runtime_error where too few bytes are left.
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

// --- A struct is written as its fields, one after the other. A struct without write() and read()
// of its own names its fields in a function each_field(to, of), or in its member
//   template <class To, class Of> static void fields(To& to, Of& of) { to(of.one, of.another); }

template <class T>
constexpr bool is_in_one_piece = std::is_same_v<T, double> || std::is_same_v<T, std::byte>;

class Sender {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (one(values), ...);
  }
  Bytes bytes;

 private:
  template <class T>
  void one(const T& value) {
    if constexpr (std::is_arithmetic_v<T>)
      put(bytes, value);
    else if constexpr (requires { value.write(bytes); })
      value.write(bytes);
    else if constexpr (requires { T::fields(*this, value); })
      T::fields(*this, value);
    else
      each_field(*this, value);
  }
  void one(const std::string& text) { put_text(bytes, text); }
  template <class First, class Second>
  void one(const std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class T>
  void one(const std::vector<T>& list) {
    if constexpr (is_in_one_piece<T>)
      put(bytes, std::as_bytes(std::span(list)));
    else
      each_of(list);
  }
  template <class Key, class T>
  void one(const std::map<Key, T>& map) {
    each_of(map);
  }
  template <class List>
  void each_of(const List& list) {
    put(bytes, std::uint64_t{list.size()});
    for (const auto& element : list) one(element);
  }
};

// Throws std::runtime_error where the bytes are not those of a Sender. It reserves no memory by a
// count, which may be false: elements are added as they are read.
class Receiver {
 public:
  explicit Receiver(std::span<const std::byte> bytes) : from_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }
  bool empty() const { return from_.empty(); }

 private:
  template <class T>
  void one(T& value) {
    if constexpr (std::is_arithmetic_v<T>)
      value = from_.take<T>();
    else if constexpr (requires { T::read(from_); })
      value = T::read(from_);
    else if constexpr (requires { T::fields(*this, value); })
      T::fields(*this, value);
    else
      each_field(*this, value);
  }
  void one(std::string& text) { text = from_.take_text(); }
  template <class First, class Second>
  void one(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class T>
  void one(std::vector<T>& list) {
    if constexpr (is_in_one_piece<T>) {
      const std::span<const std::byte> bytes = from_.take_bytes();
      if (bytes.size() % sizeof(T) != 0) throw std::runtime_error("a list ends within a number");
      list.resize(bytes.size() / sizeof(T));
      if (!list.empty()) std::memcpy(list.data(), bytes.data(), list.size() * sizeof(T));
    } else {
      const auto count = from_.take<std::uint64_t>();
      for (std::uint64_t i = 0; i < count; ++i) one(list.emplace_back());
    }
  }
  template <class Key, class T>
  void one(std::map<Key, T>& map) {
    const auto count = from_.take<std::uint64_t>();
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto key = from_.take<Key>();
      if (!map.empty() && map.rbegin()->first >= key)
        throw std::runtime_error("its keys do not ascend");
      one(map[key]);
    }
  }

  ByteReader from_;
};

}  // namespace tribo::sweep
