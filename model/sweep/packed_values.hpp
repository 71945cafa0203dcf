// SPDX-License-Identifier: Apache-2.0
// An array of numbers or words as HDF5's filters `shuffle` and `deflate` would leave it, made here
// so that all threads pack and one need only write. Doubles make eight byte planes; those that look
// random (the low digits) are stored as they are: zlib would take most of its time to gain nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "sweep/bytes.hpp"

namespace tribo::sweep {

struct PackedValues {
  std::uint32_t element_size = 8;  // bytes: 8 for doubles, 1 for words
  Bytes bytes;                     // a zlib stream of the shuffled array

  template <class To, class Values>
  static void fields(To& to, Values& of) {
    to(of.element_size, of.bytes);
  }
};

PackedValues pack(std::span<const double> values);
PackedValues pack(std::span<const std::uint8_t> words);

}  // namespace tribo::sweep
