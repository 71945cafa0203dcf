// SPDX-License-Identifier: Apache-2.0
// The certified tables of reference/exact, quantity by quantity, as CTest tests: what `tribocheck
// verify` prints, here with the count of rows and the greatest part of the bound for the inventory.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

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

// GoogleTest looks for it beside the type; else it writes bytes.
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

}  // namespace
}  // namespace tribo::verification
