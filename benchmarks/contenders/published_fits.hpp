// SPDX-License-Identifier: Apache-2.0
// Fits to F_{5/2} and F_2 from the literature, with the range that each claims. Beyond it they are
// used as 0, which is how programs write them.
#pragma once

#include <array>
#include <string_view>

#include "contenders/moment_contender.hpp"

namespace tribo::benchmarks {

struct PublishedFit {
  std::string_view name;
  Order order;
  Range claimed;
  double (*value)(double d);
};

const std::array<PublishedFit, 6>& all_published_fits();

}  // namespace tribo::benchmarks
