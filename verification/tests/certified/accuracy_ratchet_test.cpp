// SPDX-License-Identifier: Apache-2.0
// The ratchet: no quantity of the certified tables may become much worse than it once was, even
// within its contract. `make baseline` renews reference/baselines/accuracy.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "accuracy/accuracy.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

// Errors vary with compiler and libm: 4 times the baseline, or 4 ulp, is no news.
constexpr double leeway = 4;

testing::AssertionResult is_no_worse(double now, double baseline, const char* unit,
                                     const QuantityResult& result) {
  const double bound = leeway * std::max(1.0, baseline);
  record_part_of_bound(now / bound);
  if (now <= bound) return testing::AssertionSuccess();
  return testing::AssertionFailure() << fmt::format(
             "\n  {}: worst {:.4g} {} ({:a}), baseline {:.4g} ({:a}), bound {:.4g}; missed by a "
             "factor {:.3g}; worst part of the contract at row {}",
             result.quantity, now, unit, now, baseline, baseline, bound, now / bound,
             result.worst_row);
}

TEST(AccuracyRatchet, NoQuantityIsMuchWorseThanItsBaseline) {
  const std::string path = TRIBOCHECK_SOURCE_DIR "/reference/baselines/accuracy.json";
  std::ifstream file(path);
  ASSERT_EQ(file.is_open(), true) << path << ": make baseline";
  const nlohmann::json baseline = nlohmann::json::parse(file);
  std::set<std::string> held;
  for (const auto& row : baseline.at("quantities")) held.insert(row.at("quantity"));
  for (const QuantityResult& result : check_accuracy(TRIBOCHECK_SOURCE_DIR "/reference/exact")) {
    const auto row =
        std::find_if(baseline.at("quantities").begin(), baseline.at("quantities").end(),
                     [&](const auto& each) { return each.at("quantity") == result.quantity; });
    ASSERT_NE(row, baseline.at("quantities").end())
        << result.quantity << " has no baseline: make baseline";
    held.erase(result.quantity);
    EXPECT_TRUE(is_no_worse(result.worst_ulp, row->at("worst_ulp"), "ulp", result));
    EXPECT_TRUE(is_no_worse(result.worst_ulp_per_condition, row->at("worst_ulp_per_condition"),
                            "ulp/condition", result));
    EXPECT_GE(result.cases, row->at("cases").get<std::size_t>()) << result.quantity;
  }
  for (const std::string& quantity : held)
    ADD_FAILURE() << quantity << " is in the baseline, and no longer judged";
}

}  // namespace
}  // namespace tribo::verification
