// SPDX-License-Identifier: Apache-2.0
// The templates of F_n against the certified table. Double has kernels of its own, so these are the
// only values that long double and 50 digits are held to from outside.
#include <gtest/gtest.h>

#include "accuracy/reference_table.hpp"
#include "support/judge.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::verification {
namespace {

struct Row {
  Order order;
  double argument;
  Reference value;
};

std::vector<Row> rows() {
  std::vector<Row> result;
  for (const ReferenceRow& row :
       read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/exact/gaussian_moment.csv"))
    result.push_back({static_cast<Order>(static_cast<int>(2 * row.number("order"))),
                      row.number("argument"), Reference(row.text("value"))});
  return result;
}

TEST(MomentTemplates, LongDoubleKeepsFiveHundredEpsilon) {
  for (const Row& row : rows())
    EXPECT_TRUE(is_close(gaussian_moment(row.order, static_cast<long double>(row.argument)),
                         row.value, 500 * 0x1p-63,
                         {{"2n", double(twice(row.order))}, {"d", row.argument}}));
}

// The table has 40 digits.
TEST(MomentTemplates, FiftyDigitsAgreeToFortyDigits) {
  const std::vector<Row> all = rows();
  for (std::size_t i = 0; i < all.size(); i += 3) {
    const Reference got = gaussian_moment(all[i].order, Reference(all[i].argument));
    const Reference error = abs(got / all[i].value - 1);
    record_part_of_bound(static_cast<double>(error) / 1e-39);
    EXPECT_LE(error, 1e-39) << describe(
        {{"2n", double(twice(all[i].order))}, {"d", all[i].argument}});
  }
}

}  // namespace
}  // namespace tribo::verification
