// SPDX-License-Identifier: Apache-2.0
// Answers next to a limit. An answer has to change between two neighbouring doubles at its limit,
// and at the limit itself it has to be the promised one.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>

#include "support/case_count.hpp"

namespace tribo::verification {

// Where the answer is true: above or below the limit; with `from` and `up_to` at the limit, too.
enum class True { above, from, below, up_to };

struct Threshold {
  std::string name;
  double limit;  // not 0
  True side;
  std::function<bool(double)> answer;
  // The answer may change at this relative distance from the limit. It is above 0 where the judged
  // number is computed from the given one, and so rounded. 0: it changes at the limit itself.
  double slack = 0;
  double reach = 0.125;  // relative: within this distance the answer changes once
};

// Do the answers differ at the two ends of the reach, and change at the limit?
inline testing::AssertionResult changes_at_its_limit(const Threshold& one) {
  const auto failed = [&](const std::string& what) {
    return testing::AssertionFailure() << one.name << ", limit " << one.limit << ": " << what;
  };
  const bool is_true_above = one.side == True::above || one.side == True::from;
  const double reach = std::abs(one.limit) * one.reach;
  double low = one.limit - reach, high = one.limit + reach;
  if (one.answer(low) == is_true_above) return failed(fmt::format("wrong at {}", low));
  if (one.answer(high) != is_true_above) return failed(fmt::format("wrong at {}", high));
  while (std::nextafter(low, high) < high) {
    const double middle = low + (high - low) / 2;
    (one.answer(middle) == is_true_above ? high : low) = middle;
  }
  // The answer is that below the limit up to `low`, and that above the limit from `high` on.
  const bool is_with_those_above = one.side == True::from || one.side == True::below;
  const double found = is_with_those_above ? high : low;
  record_part_of_bound(one.slack == 0 ? 0 : std::abs(found / one.limit - 1) / one.slack);
  if (!(std::abs(found - one.limit) <= one.slack * std::abs(one.limit)))
    return failed(fmt::format("the answer changes between {} and {}", low, high));
  return testing::AssertionSuccess();
}

}  // namespace tribo::verification
