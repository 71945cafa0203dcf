// SPDX-License-Identifier: Apache-2.0
// The reference files: header, rows, checksum. A row is admitted when its enclosure is narrower
// than 1e-40 relative and a second method's enclosure overlaps it.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "generators/ball.hpp"

namespace tribo::reference {

struct Header {
  std::string quantity, definition, units, domain, first_method, second_method, columns;
};

struct Row {
  std::string id;
  std::vector<std::string> inputs;  // hexfloats and words
  Ball value, second;
  Ball condition;
  std::string region;
};

inline std::string hexfloat(double x) { return fmt::format("{:a}", x); }

// The row's text: value to 40 digits, the same as high + low doubles, the condition number to 3
// digits; these are empty where the quantity is undefined.
inline std::string line(const Row& row) {
  std::string text = row.id;
  for (const std::string& input : row.inputs) text += "," + input;
  if (!is_finite(row.value) && !is_finite(row.second)) return text + ",,,,," + row.region;
  const bool is_zero = row.value == 0 && row.second == 0;
  if (!is_zero && (row.value.accurate_bits() < 133 || !overlaps(row.value, row.second)))
    throw std::runtime_error(fmt::format("row {} is not admitted: {} bits, {} {}", row.id,
                                         row.value.accurate_bits(), row.value.decimal(25),
                                         row.second.decimal(25)));
  const double high = row.value.nearest();  // 0 below the range of double
  const double low = (row.value - Ball(high)).nearest();
  return text + fmt::format(",{},{},{},{:.3g},{}", row.value.decimal(40), hexfloat(high),
                            hexfloat(low), row.condition.nearest(), row.region);
}

}  // namespace tribo::reference
