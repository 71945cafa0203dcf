// SPDX-License-Identifier: Apache-2.0
// An array of numbers or words in the form that HDF5's filters `shuffle` and `deflate` give it. So
// all threads can pack, and one writes. Doubles make eight byte planes. Planes that look random
// (the low digits) are not packed: zlib would spend most of its time on them for no gain.
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
