// SPDX-License-Identifier: Apache-2.0
// The judges pass a number inside its bound. They fail a number outside, and say by how much.
#include "support/judge.hpp"

#include <gtest/gtest.h>

#include "sampling/philox.hpp"

namespace tribo::verification {
namespace {

TEST(Judge, PassesInsideTheBoundAndFailsOutside) {
  const Reference expected = 3;
  const double ulp = 0x1p-51;  // of 3
  EXPECT_EQ(bool(is_close(3.0 + ulp, expected, 1.01 * ulp / 3, {})), true);
  EXPECT_EQ(bool(is_close(3.0 + ulp, expected, 0.99 * ulp / 3, {})), false);
  EXPECT_EQ(bool(is_close(3.0 - ulp, expected, 0.99 * ulp / 3, {})), false);
  EXPECT_EQ(bool(is_close(3.0 + ulp, expected, 0.11 * ulp / 3, {}, 10)), true);
  EXPECT_EQ(bool(is_close(3.0 + ulp, expected, 0.09 * ulp / 3, {}, 10)), false);
  EXPECT_EQ(bool(is_within(1.05, 1, 0.06)), true);
  EXPECT_EQ(bool(is_within(1.05, 1, 0.04)), false);
  EXPECT_EQ(bool(is_within(0.95, 1, 0.04)), false);
}

TEST(Judge, NothingButTheNumberItselfIsCloseToNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(bool(is_close(nan, 1, 1e300, {})), false);
  EXPECT_EQ(bool(is_close(infinity, 1, 1e300, {})), false);
  EXPECT_EQ(bool(is_close(1e-300, 0, 1, {})), false);
  EXPECT_EQ(bool(is_close(0.0, 0, 1, {})), true);
  EXPECT_EQ(bool(is_within(nan, 1, 1e300)), false);
}

TEST(Judge, SaysInputExpectedGotErrorConditionBoundAndFactor) {
  const std::string text = is_close(1.5, 1, 0.1, {{"x", 0.5}}, 2).message();
  for (const char* part : {"x = 0.5 (0x1p-1)", "expected 1", "got      1.5 (0x1.8p+0)",
                           "error 0.5 relative", "ulp", "condition 2", "bound 0.2", "factor 2.5"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in" << text;
}

TEST(Judge, CountsWhatItHasHeldAndHowNearTheBoundItCame) {
  case_count = {};
  EXPECT_TRUE(is_close(1.25, 1, 0.5, {}));
  EXPECT_EQ(case_count.held, 1u);
  EXPECT_EQ(case_count.greatest_part_of_bound, 0.5);
  EXPECT_TRUE(is_close(1.25, 1, 0.5, {}, 8));  // a sixteenth of the bound
  EXPECT_EQ(case_count.greatest_part_of_bound, 0.5);
  EXPECT_TRUE(is_within(0.25, 1, 1));
  EXPECT_EQ(case_count.greatest_part_of_bound, 0.75);
  case_count = {};
  EXPECT_TRUE(is_close(1.25, 1, 0.5, {}, 8));
  EXPECT_EQ(case_count.greatest_part_of_bound, 0.0625);
}

// The C++ standard gives the ten thousandth number of mt19937_64 with its default seed.
TEST(Sampler, GivesTheSameNumbersEverywhere) {
  Sampler sampler(5489);
  for (int i = 1; i < 10000; ++i) sampler.uniform(0, 1);
  EXPECT_EQ(sampler.uniform(0, 1), static_cast<double>(9981545732273789042ULL >> 11) * 0x1p-53);
}

// Vectors 1 to 3 of Random123's kat_vectors.
TEST(Philox, GivesTheKnownAnswersOfRandom123) {
  EXPECT_EQ(philox_words({0, 0, 0, 0}, {0, 0}),
            (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(
      philox_words({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
      (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(
      philox_words({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
      (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

}  // namespace
}  // namespace tribo::verification
