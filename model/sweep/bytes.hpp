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

// --- A struct is written as its fields, one after the other. A struct without write() and read()
// of its own names its fields in a function each_field(to, of), or in its member
//   template <class To, class Of> static void fields(To& to, Of& of) { to(of.one, of.another); }

template <class T>
constexpr bool is_in_one_piece = std::is_same_v<T, double> || std::is_same_v<T, std::byte>;

// Writes values behind the bytes that are there.
class Sender {
 public:
  explicit Sender(Bytes& to) : to_(to) {}
  template <class... T>
  void operator()(const T&... values) {
    (one(values), ...);
  }

 private:
  template <class T>
  void one(const T& value) {
    if constexpr (std::is_arithmetic_v<T>)
      put(to_, value);
    else if constexpr (requires { value.write(to_); })
      value.write(to_);
    else if constexpr (requires { T::fields(*this, value); })
      T::fields(*this, value);
    else
      each_field(*this, value);
  }
  void one(const std::string& text) { put(to_, std::as_bytes(std::span(text))); }
  template <class First, class Second>
  void one(const std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class T>
  void one(const std::vector<T>& list) {
    if constexpr (is_in_one_piece<T>)
      put(to_, std::as_bytes(std::span(list)));
    else
      each_of(list);
  }
  template <class Key, class T>
  void one(const std::map<Key, T>& map) {
    each_of(map);
  }
  template <class List>
  void each_of(const List& list) {
    put(to_, std::uint64_t{list.size()});
    for (const auto& element : list) one(element);
  }

  Bytes& to_;
};

// Takes from the front what a Sender wrote. Throws std::runtime_error where the bytes are not those
// of a Sender. A count in the bytes may be false, so that no memory is reserved by it: elements are
// added as they are read.
class Receiver {
 public:
  explicit Receiver(std::span<const std::byte> bytes) : left_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }
  template <class T>
  T take() {
    T value{};
    one(value);
    return value;
  }
  bool empty() const { return left_.empty(); }

 private:
  std::span<const std::byte> some(std::uint64_t count) {
    if (count > left_.size()) throw std::runtime_error("a record ends too early");
    const auto first = left_.first(static_cast<std::size_t>(count));
    left_ = left_.subspan(first.size());
    return first;
  }
  std::span<const std::byte> some() { return some(take<std::uint64_t>()); }

  template <class T>
  void one(T& value) {
    if constexpr (std::is_arithmetic_v<T>)
      std::memcpy(&value, some(sizeof value).data(), sizeof value);
    else if constexpr (requires { T::read(*this); })
      value = T::read(*this);
    else if constexpr (requires { T::fields(*this, value); })
      T::fields(*this, value);
    else
      each_field(*this, value);
  }
  void one(std::string& text) {
    const std::span<const std::byte> bytes = some();
    text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  template <class First, class Second>
  void one(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class T>
  void one(std::vector<T>& list) {
    if constexpr (is_in_one_piece<T>) {
      const std::span<const std::byte> bytes = some();
      if (bytes.size() % sizeof(T) != 0) throw std::runtime_error("a list ends within a number");
      list.resize(bytes.size() / sizeof(T));
      if (!list.empty()) std::memcpy(list.data(), bytes.data(), bytes.size());
    } else {
      const auto count = take<std::uint64_t>();
      for (std::uint64_t i = 0; i < count; ++i) one(list.emplace_back());
    }
  }
  template <class Key, class T>
  void one(std::map<Key, T>& map) {
    const auto count = take<std::uint64_t>();
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto key = take<Key>();
      if (!map.empty() && map.rbegin()->first >= key)
        throw std::runtime_error("its keys do not ascend");
      one(map[key]);
    }
  }

  std::span<const std::byte> left_;
};

}  // namespace tribo::sweep
