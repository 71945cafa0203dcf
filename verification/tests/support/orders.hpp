// SPDX-License-Identifier: Apache-2.0
// Orders of moments in the names of tests.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tribo/gaussian_moment.hpp"

namespace tribo {

// GoogleTest looks for this function beside the type, and without it prints bytes.
inline void PrintTo(Order n, std::ostream* to) { *to << fmt::format("{}/2", twice(n)); }

namespace verification {

inline std::string order_name(const testing::TestParamInfo<Order>& info) {
  return fmt::format("order_{}_halves", twice(info.param));
}

}  // namespace verification
}  // namespace tribo
