// SPDX-License-Identifier: Apache-2.0
// The certified tables of reference/exact, quantity by quantity, as CTest tests. They judge as
// `tribocheck verify` does, and print the count of rows and the greatest part of the bound for the
// inventory. The ratchet allows no quantity to become much worse than its baseline, even within its
// contract. `make baseline` renews reference/baselines/accuracy.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>

#include "accuracy/accuracy.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

const std::vector<QuantityResult>& results() {
  static const std::vector<QuantityResult> all =
      check_accuracy(TRIBOCHECK_SOURCE_DIR "/reference/exact");
  return all;
}

}  // namespace

// GoogleTest looks for this function beside the type, and without it prints bytes.
void PrintTo(const QuantityResult& result, std::ostream* to) { *to << result.quantity; }

namespace {

class CertifiedTable : public testing::TestWithParam<QuantityResult> {};

TEST_P(CertifiedTable, HoldsTheContract) {
  const QuantityResult& result = GetParam();
  record_part_of_bound(result.worst_part_of_bound);
  case_count.held += result.cases;
  EXPECT_LE(result.worst_part_of_bound, 1)
      << fmt::format("row {}: worst {:.4g} ulp, {:.4g} ulp/condition; allowed {} or {} × condition",
                     result.worst_row, result.worst_ulp, result.worst_ulp_per_condition,
                     result.allowed_ulp, result.allowed_ulp_per_condition);
  EXPECT_GT(result.cases, 0u);
}

INSTANTIATE_TEST_SUITE_P(OfEachQuantity, CertifiedTable, testing::ValuesIn(results()),
                         [](const auto& each) {
                           std::string name = each.param.quantity;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

// Errors vary with compiler and libm: they may reach 4 times the baseline, or 4 ulp.
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
  for (const QuantityResult& result : results()) {
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
