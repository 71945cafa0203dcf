// SPDX-License-Identifier: Apache-2.0
// The orders of moments, and their names in tests.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>

#include "tribo/gaussian_moment.hpp"

namespace tribo {

// GoogleTest looks for this function beside the type, and without it prints bytes.
inline void PrintTo(Order n, std::ostream* to) { *to << fmt::format("{}/2", twice(n)); }

namespace verification {

inline constexpr std::array orders{Order::zero,         Order::half, Order::one,
                                   Order::three_halves, Order::two,  Order::five_halves};

inline std::string order_name(const testing::TestParamInfo<Order>& info) {
  return fmt::format("order_{}_halves", twice(info.param));
}

}  // namespace verification
}  // namespace tribo
