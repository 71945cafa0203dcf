// SPDX-License-Identifier: Apache-2.0
// The arrays of OperatingPoints as the engine fills them.
#pragma once

#include "engine.hpp"
#include "tribo/operating_points.hpp"

namespace tribo {

namespace detail {

// The places of the numbers of points from `first` on.
inline Destination destination(OperatingPoints& points, std::size_t first) {
  const auto from = [first](auto& array) { return array.empty() ? nullptr : array.data() + first; };
  Destination to;
  to.regime = from(points.regime);
  to.inlet = from(points.inlet);
  for_each_number(points, [&](Output output, std::vector<double>& array) {
    to.numbers[static_cast<std::size_t>(output)] = from(array);
  });
  return to;
}

// The places of the outputs of one point; its speed is not among them.
inline Destination destination(OperatingPoint<double>& point, OutputSet outputs) {
  const auto asked = [&](Output output, auto& member) {
    return outputs.contains(output) ? &member : nullptr;
  };
  Destination to;
  to.regime = outputs.contains_any(balance_outputs()) ? &point.regime : nullptr;
  to.inlet = asked(Output::inlet, point.inlet);
  for_each_number(point, [&](Output output, double& number) {
    to.numbers[static_cast<std::size_t>(output)] = asked(output, number);
  });
  return to;
}

inline void store(const OperatingPoint<double>& point, OperatingPoints& points, std::size_t i) {
  const auto put = [i](auto& array, auto value) {
    if (!array.empty()) array[i] = value;
  };
  const auto numbers = numbers_of(point);
  for_each_number(points, [&](Output output, std::vector<double>& array) {
    put(array, numbers[static_cast<std::size_t>(output)]);
  });
  put(points.regime, point.regime);
  put(points.inlet, point.inlet);
}

}  // namespace detail

}  // namespace tribo
